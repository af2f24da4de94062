#include "converge.hpp"

#include "commands.hpp"
#include "converge_conclusion.hpp"
#include "converge_plot.hpp"
#include "converge_report.hpp"
#include "exit_status.hpp"
#include "gnuplot.hpp"
#include "io/error.hpp"
#include "io/terminal.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "lists.hpp"
#include "measure/same_cloth.hpp"
#include "outputs.hpp"
#include "progress.hpp"
#include "report_text.hpp"
#include "scene/file.hpp"
#include "scene/settings.hpp"
#include "shared_options.hpp"

#include "drapeau/stability.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace drapeau::lab {

namespace {

using Grids = std::vector<std::pair<int, int>>;

int halved(int masses) {
    return masses > 1 ? 2 * masses - 1 : 1;
}

Grids given_grids(const std::string& list, const Scene& scene) {
    constexpr std::size_t least = 3;
    Grids grids;
    for (const std::string& item : items_of(list)) {
        const auto grid = grid_in(item);
        if (!grids.empty()) {
            const auto [columns, rows] = grids.back();
            if (grid != std::pair(halved(columns), halved(rows)))
                refuse("--grids", item,
                       fmt::format("half the cells of {}x{} before it, which is {}x{},", columns, rows, halved(columns),
                                   halved(rows)));
        }
        grids.push_back(grid);
    }
    if (grids.size() < least)
        refuse("--grids", list, "three grids or more, each with the cells of the one before halved,");
    for (const auto& [columns, rows] : grids) same_cloth(scene, columns, rows);
    return grids;
}

/// The scene's own grid and finer ones: so many, or as many of the usual number as are possible.
Grids finer_grids(const std::string& levels, const Scene& scene) {
    constexpr int usual = 4;
    constexpr settings::Range range{3.0, 10.0};
    int count = usual;
    if (!levels.empty()) {
        const auto number = number_in(without_space(levels));
        if (!number || !range.contains(*number) || *number != std::floor(*number))
            refuse("--levels", levels, "a whole number from 3 to 10");
        count = static_cast<int>(*number);
    }
    Grids grids{{scene.flag.columns, scene.flag.rows}};
    while (static_cast<int>(grids.size()) < count) {
        const std::pair finer{halved(grids.back().first), halved(grids.back().second)};
        try {
            same_cloth(scene, finer.first, finer.second);
        } catch (const InputError& impossible) {
            if (levels.empty()) break;
            throw InputError("--levels = " + one_line(levels, 60) + ": " + impossible.what());
        }
        grids.push_back(finer);
    }
    return grids;
}

ConvergeRequest request_in(const ConvergeOptions& options) {
    constexpr double most_minutes = 7.0 * 24.0 * 60.0;
    ConvergeRequest request;
    request.batches_are_given = !options.seconds.empty();
    if (request.batches_are_given) request.batches = batches_option("--seconds", options.seconds, 1);
    request.settle = static_cast<double>(batches_option("--settle", options.settle, 0)) * batch_seconds;
    request.budget = 60.0 * number_option("--budget", options.budget, {0.01, most_minutes}, "minutes");
    request.methods = names_option<Method>("--methods", options.methods, settings::method_names);
    if (request.methods.empty())
        for (std::size_t n = 0; n < method_count; ++n) request.methods.push_back(static_cast<Method>(n));
    request.scene = scene_in(options.scene, options.set);
    if (!options.grids.empty() && !options.levels.empty())
        throw InputError("--levels: it counts grids from the scene's own on; give it or --grids");
    request.grids =
        options.grids.empty() ? finer_grids(options.levels, request.scene) : given_grids(options.grids, request.scene);
    return request;
}

}  // namespace

int converge(const ConvergeOptions& options) {
    const ConvergeRequest request = request_in(options);
    const std::vector<NamedFile> outputs = asked_for({{"--json", options.json}, {"--plot", options.plot}});
    check_outputs({{"the scene", find_scene(options.scene).string()}}, outputs);
    check_plot("--plot", options.plot);
    ConvergeSweep sweep(request);
    complain(program, fmt::format("{} methods and {} grids, about {}, at most {}", request.methods.size(),
                                  request.grids.size(), duration(sweep.estimate()), duration(request.budget)));
    ConvergeFindings found;
    {
        Progress progress;
        found = sweep.find([&](double share) { progress.show(share); });
    }
    if (found.diverged) {
        complain(program, "the scene diverges while it swings in, at rk4's automatic step: " + *found.diverged);
        return exit_diverged;
    }
    const std::string text = compared_text(request, found) + "\n" + steps_table(found) + "\n" +
                             grids_table(request, found) + "\n" + conclusion(found) + "\n";
    std::fputs(text.c_str(), place_of_table(outputs));
    if (!options.json.empty())
        write_text_file(options.json, [&](const Append& append) { append(as_json(request, found).dump(2) + "\n"); });
    if (!options.plot.empty()) plot(options.plot, converge_script(request, found));
    return exit_good;
}

}  // namespace drapeau::lab
