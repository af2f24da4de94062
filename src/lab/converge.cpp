#include "converge.hpp"

#include "basis_records.hpp"
#include "converge_conclusion.hpp"
#include "converge_plot.hpp"
#include "converge_records.hpp"
#include "converge_report.hpp"
#include "exit_status.hpp"
#include "gnuplot.hpp"
#include "io/error.hpp"
#include "io/terminal.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "lists.hpp"
#include "measure/same_cloth.hpp"
#include "merge.hpp"
#include "outputs.hpp"
#include "program.hpp"
#include "progress.hpp"
#include "report_text.hpp"
#include "scene/file.hpp"
#include "scene/settings.hpp"
#include "shared_options.hpp"

#include "drapeau/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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

ConvergeRequest request_in(const ConvergeOptions& options, const Scene& scene) {
    ConvergeRequest request;
    read_comparison(options, request);
    request.methods = names_option<Method>("--methods", options.methods, settings::method_names);
    if (request.methods.empty())
        for (std::size_t n = 0; n < method_count; ++n) request.methods.push_back(static_cast<Method>(n));
    request.scene = scene;
    if (!options.grids.empty() && !options.levels.empty())
        throw InputError("--levels: it counts grids from the scene's own on; give it or --grids");
    request.grids =
        options.grids.empty() ? finer_grids(options.levels, request.scene) : given_grids(options.grids, request.scene);
    return request;
}

int report(const ConvergeRequest& request, const ConvergeFindings& found, const SweepOutputs& outputs) {
    const std::string text = compared_text(request, found) + "\n" + steps_table(found) + "\n" +
                             grids_table(request, found) + "\n" + conclusion(found) + "\n";
    std::fputs(text.c_str(), place_of_table(outputs.files()));
    if (!outputs.json.empty())
        write_text_file(outputs.json, [&](const Append& append) { append(as_json(request, found).dump(2) + "\n"); });
    if (!outputs.plot.empty()) plot(outputs.plot, converge_script(request, found));
    return exit_good;
}

int say_diverged(const std::string& how) {
    complain(program, "the scene diverges " + how);
    return exit_diverged;
}

/// A sweep at once, as far as the budget goes.
int at_once(const ConvergeRequest& request, const SweepOutputs& outputs) {
    ConvergeSweep sweep(request);
    const double expected = std::max(sweep.estimate(), 1e-3);
    complain(program, fmt::format("{} and {}, about {}, at most {}", counted(request.methods.size(), "method"),
                                  counted(request.grids.size(), "grid"), duration(expected), duration(request.budget)));
    std::optional<Progress> progress(std::in_place);
    const auto tick = [&] { progress->show(std::min(0.99, sweep.elapsed() / expected)); };
    const auto diverged = sweep.prepare(tick);
    ConvergeFindings found;
    if (!diverged) found = sweep.measure(tick);
    progress.reset();
    return diverged ? say_diverged(*diverged) : report(sweep.request(), found, outputs);
}

/// A sweep, or a shard of one, whose points are kept as they are done. The whole ends as one at once does.
int in_parts(const ConvergeOptions& options, const ConvergeRequest& request, const SweepOutputs& outputs,
             const Shard& shard) {
    ConvergeSweep sweep(request);
    PartFile file(options.part, identity_of(options, request), shard);
    const std::vector<ConvergePoint> points = sweep.points();
    std::vector<ConvergePoint> missing;
    const std::vector<std::size_t> places = shard.places(points.size());
    for (const std::size_t n : places)
        if (!file.has(points[n].key)) missing.push_back(points[n]);
    const double share = static_cast<double>(missing.size() + 1) / static_cast<double>(points.size() + 1);
    complain(program, fmt::format("shard {}: {} of {}, {} of them done, about {}", shard.text(), places.size(),
                                  counted(points.size(), "point"), places.size() - missing.size(),
                                  duration(share * sweep.estimate())));
    std::optional<Progress> progress(std::in_place);
    double done = 0.0;
    const auto tick = [&] { progress->show(done / static_cast<double>(missing.size() + 1)); };
    if (const auto how = sweep.prepare(tick)) {
        progress.reset();
        return say_diverged(*how);
    }
    file.set_basis(basis_json(sweep.basis()));
    for (const ConvergePoint& point : missing) {
        done += 1.0;
        file.add(point.key, nullptr, result_of(sweep, point, tick));
    }
    progress.reset();
    return shard.is_whole() ? report(sweep.request(), findings_in(file.part(), sweep), outputs)
                            : say_shard_is_done(file.part());
}

}  // namespace

int converge(const ConvergeOptions& options) {
    const ConvergeRequest request = request_in(options, scene_in(options.scene, options.set));
    const SweepOutputs outputs{options.json, "", options.plot, find_scene(options.scene)};
    const Shard shard = checked_shard(options.part, outputs);
    return request.counts_work ? in_parts(options, request, outputs, shard) : at_once(request, outputs);
}

int merge_converge(const Joined& joined, const MergeOptions& merging) {
    if (!merging.write.empty()) throw InputError("--write: orders of convergence have no setting to save");
    const ConvergeOptions options = options_of_converge(joined.all.sweep);
    ConvergeRequest request = request_in(options, parse_scene(joined.all.sweep.scene, joined.all.file + ", its scene"));
    request.counts_work = true;
    ConvergeSweep sweep(request);
    if (const auto missing = joined.missing(keys_of(sweep.points()))) {
        complain(program, *missing);
        return exit_not_met;
    }
    use_basis(joined.all, [&](const Json& basis) { sweep.restore(basis_in(basis)); });
    return report(sweep.request(), findings_in(joined.all, sweep), {merging.json, "", merging.plot, {}});
}

}  // namespace drapeau::lab
