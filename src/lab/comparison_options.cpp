#include "comparison_options.hpp"

#include "commands.hpp"
#include "io/error.hpp"
#include "io/text.hpp"
#include "shared_options.hpp"

#include "drapeau/stability.hpp"

namespace drapeau::lab {

namespace {

constexpr TextOption<ComparisonOptions> texts[] = {{"--settle", &ComparisonOptions::settle},
                                                   {"--seconds", &ComparisonOptions::seconds},
                                                   {"--budget", &ComparisonOptions::budget},
                                                   {"--tolerance", &ComparisonOptions::tolerance}};

}  // namespace

void add_comparison_options(CLI::App& command, ComparisonOptions& options, const std::string& tolerance) {
    add_assignments(command, options.set);
    command.add_option("--settle", options.settle, "Time to swing in before, s (" + options.settle + ")")
        ->type_name("T");
    command
        .add_option("--seconds", options.seconds, "Time compared, s (0.5, or half the chaos horizon if that is less)")
        ->type_name("T");
    command.add_option("--budget", options.budget, "Time it may take, minutes (" + options.budget + ")")
        ->type_name("MINUTES");
    if (!tolerance.empty()) command.add_option("--tolerance", options.tolerance, tolerance)->type_name("DISTANCE");
    add_part_options(command, options.part);
}

void read_comparison(const ComparisonOptions& options, ComparisonRequest& request) {
    request.batches_are_given = !options.seconds.empty();
    if (request.batches_are_given) request.batches = batches_option("--seconds", options.seconds, 1);
    request.settle = static_cast<double>(batches_option("--settle", options.settle, 0)) * batch_seconds;
    request.budget = budget_option(options.budget);
    if (!options.tolerance.empty()) request.tolerance = distance_in("--tolerance", options.tolerance);
    request.counts_work = !options.part.file.empty();
}

void check_tolerance(const ComparisonOptions& options, double compared, double horizon) {
    if (options.tolerance.empty() || horizon >= compared) return;
    throw InputError("--tolerance = " + one_line(options.tolerance, 60) + ": within " + quantity(compared, "s") +
                     " the motion is chaotic: a nanometre becomes as much in " + quantity(horizon, "s", 2) +
                     "; compare no more --seconds than that");
}

Json comparison_json(const ComparisonOptions& options) {
    return texts_json<ComparisonOptions>(options, texts);
}

void read_comparison_json(const Json& json, ComparisonOptions& options) {
    read_texts<ComparisonOptions>(json, options, texts);
}

}  // namespace drapeau::lab
