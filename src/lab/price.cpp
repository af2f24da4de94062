#include "price.hpp"

#include "commands.hpp"

#include "io/error.hpp"
#include "io/terminal.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "outputs.hpp"
#include "progress.hpp"
#include "exit_status.hpp"
#include "gnuplot.hpp"
#include "price_plot.hpp"
#include "price_report.hpp"
#include "report_text.hpp"
#include "scene/file.hpp"
#include "shared_options.hpp"

#include "drapeau/stability.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace drapeau::lab {

namespace {

std::vector<NamedFile> outputs_of(const PriceOptions& options) {
    return asked_for({{"--write", options.write}, {"--json", options.json}, {"--plot", options.plot}});
}

PriceRequest request_in(const PriceOptions& options) {
    PriceRequest request;
    request.batches_are_given = !options.seconds.empty();
    if (request.batches_are_given) request.batches = batches_option("--seconds", options.seconds, 1);
    request.settle = static_cast<double>(batches_option("--settle", options.settle, 0)) * batch_seconds;
    request.budget = budget_option(options.budget);
    if (!options.tolerance.empty()) request.tolerance = distance_in("--tolerance", options.tolerance);
    if (!options.write.empty() && !request.tolerance)
        throw InputError("--write: it saves the scene that --tolerance leaves; give --tolerance too");
    request.scene = scene_in(options.scene, options.set);
    return request;
}

}  // namespace

int price(const PriceOptions& options) {
    const PriceRequest request = request_in(options);
    const std::filesystem::path file = find_scene(options.scene);
    check_outputs({{"the scene", file.string()}}, outputs_of(options));
    check_plot("--plot", options.plot);

    std::optional<Progress> progress;
    PriceStudy study(request, [&](double share) {
        if (progress) progress->show(share);
    });
    complain(program, fmt::format("{} parts, about {}, at most {}", study.parts().size(), duration(study.estimate()),
                                  duration(request.budget)));
    progress.emplace();
    const auto diverged = [&](const std::string& when, const std::string& how) {
        progress.reset();
        complain(program, "the scene diverges " + when + ": " + how);
        return exit_diverged;
    };
    if (const auto how = study.prepare()) return diverged("while it swings in, at rk4's automatic step", *how);
    if (request.tolerance && study.is_beyond_horizon()) {
        progress.reset();
        throw InputError("--tolerance = " + one_line(options.tolerance, 60) + ": within " +
                         quantity(study.ground().stretch.seconds(), "s") +
                         " the motion is chaotic: a nanometre becomes as much in " + quantity(study.horizon(), "s", 2) +
                         "; compare no more --seconds than that");
    }
    const Prices prices = study.measure();
    if (prices.diverged) return diverged("in the time compared, at its own step", *prices.diverged);
    std::optional<Reduction> reduction;
    if (request.tolerance) reduction = study.reduce(prices);
    progress.reset();

    std::FILE* table = place_of_table(outputs_of(options));
    std::fputs((compared_text(study) + "\n" + parts_table(study, prices)).c_str(), table);
    if (reduction) std::fputs(("\n" + reduction_text(study, prices, *reduction)).c_str(), table);
    if (!options.json.empty())
        write_text_file(options.json,
                        [&](const Append& append) { append(as_json(study, prices, reduction).dump(2) + "\n"); });
    if (!options.plot.empty()) plot(options.plot, price_script(study, prices));
    if (!reduction) return exit_good;
    if (!holds(study, *reduction)) return exit_not_met;
    if (!options.write.empty())
        write_text_file(options.write, [&](const Append& append) { append(reduced_text(study, *reduction, file)); });
    return exit_good;
}

}  // namespace drapeau::lab
