#include "commands.hpp"
#include "trade.hpp"

#include <memory>

namespace drapeau::lab {

namespace {

constexpr const char* trade_notes =
    "Each setting starts from the same swung-in state and is compared with a reference: rk4 in double at far smaller\n"
    "steps, whose error is estimated and confirmed by leapfrog (which judges rk4). Steps are whole parts of 1/60 s, as "
    "in\n"
    "the window. Errors are root mean squares over the masses that are free, at the end of the time compared;\n"
    "\"greatest\", energy and stretch are the greatest at any of up to 60 moments. Cost is processor time of the run "
    "as the\n"
    "programs run it, its energy ledger included: the least of several repeats. Past the time in which a nanometre\n"
    "becomes a millimetre, or --tolerance, the statistics of the fly end's middle are compared instead.\n\n"
    "With --part each setting is kept as soon as it is measured, and --budget is work of the whole sweep at 4 ns for a "
    "step of\n"
    "one mass, not time: what is measured is then the same on every machine. docs/laboratory.md says how to spread "
    "it.\n\n"
    "--tolerance is a distance at the end of the time compared (and the rms over it). It is not time.tolerance of "
    "scenes,\n"
    "which is in m per simulated second.\n\n"
    "Example: drapeau-lab trade report --tolerance 1mm --write quick.toml\n"
    "Exit status: 0 good, 1 no setting meets --tolerance or its check failed, 2 bad input, 3 diverged.";

}  // namespace

Job add_trade(CLI::App& command) {
    const auto given = std::make_shared<TradeOptions>();
    TradeOptions& options = *given;
    command.footer(trade_notes);
    add_scene(command, options.scene);
    command
        .add_option("--methods", options.methods, "Methods to compare, separated by commas; all of them unless given")
        ->type_name("M,...");
    command.add_option("--dt", options.dt, "Steps to compare, s; unless given, fractions of each method's limit")
        ->type_name("S,...");
    command.add_option("--precisions", options.precisions, "float, double or both (as without it)")->type_name("P,...");
    command.add_option("--grids", options.grids, "Other grids to compare, of the same cloth")
        ->type_name("COLUMNSxROWS,...");
    command.add_flag("--diagonals", options.both_diagonals, "Compare the model with and without diagonal springs");
    command.add_option("--limits", options.limits, "Stretch limits to compare: shares, or off")->type_name("L,...");
    add_comparison_options(command, options, "Name the cheapest setting within this distance, such as 1mm");
    take_as_path(command.add_option("--write", options.write, "Save the scene with that setting, if its check holds")
                     ->type_name("FILE.toml"));
    take_as_path(command.add_option("--json", options.json, "Write the results as one JSON object")->type_name("FILE"));
    add_plot_option(command, options.plot, "Draw cost over error");
    return [given] { return trade(*given); };
}

}  // namespace drapeau::lab
