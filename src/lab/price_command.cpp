#include "commands.hpp"
#include "price.hpp"

#include <memory>

namespace drapeau::lab {

namespace {

constexpr const char* price_notes =
    "Left out, one at a time: settings of the springs that may be absent, each term and limit the scene lists, parts "
    "of\n"
    "the wind, double precision (float instead), and half the grid: inside the cloth mass per area and stiffness "
    "stay,\n"
    "and what interpolating the start on it changes is part of the effect.\n"
    "Effect: from the same swung-in state the motion is flown with and without, by rk4 in double at steps so small "
    "that\n"
    "the difference is not theirs; root mean square over the masses that are free, at the end of the time compared "
    "and\n"
    "over it, and the greatest of any mass. Past the time in which a nanometre becomes a millimetre, or --tolerance,\n"
    "the statistics of the fly end's middle are compared instead.\n"
    "Cost: processor time of the scene as given, with its own method, precision and step, less that without the part,\n"
    "in percent of the first. A given step is rounded to a whole part of 1/60 s, as in the window. All take turns\n"
    "in many rounds; a cost is the median of what the rounds say, and behind it stands what covers the true one with\n"
    "95 %. An automatic step may be larger or smaller without a part: costs are given with that step and at the "
    "scene's\n"
    "own. Without time.tolerance it is the automatic step alone; its effect is what that changes of the scene's own "
    "run.\n\n"
    "With --part each part of the scene is kept as soon as it is measured, and --budget is work of the whole study at\n"
    "4 ns for a step of one mass, not time. The scene as given is timed in every shard, beside the parts it prices.\n\n"
    "--tolerance leaves out one part after the other, the least effect first, as long as all of it together stays\n"
    "within that distance and each saves time that can be measured; then what is left is looked at in the time that\n"
    "follows, and checked and timed in the time after that. It is known to hold for as long, from states of the scene "
    "as\n"
    "given; for what matters in the long run compare statistics over many --seconds.\n\n"
    "Example: drapeau-lab price report --tolerance 1mm --write less.toml\n"
    "Exit status: 0 good, 1 nothing can be left out within --tolerance or its check failed, 2 bad input, 3 diverged.";

}  // namespace

Job add_price(CLI::App& command) {
    const auto given = std::make_shared<PriceOptions>();
    PriceOptions& options = *given;
    command.footer(price_notes);
    add_scene(command, options.scene);
    add_comparison_options(command, options, "Leave out what changes less than this distance, such as 1mm");
    take_as_path(command.add_option("--write", options.write, "Save the scene that is left, if its check holds")
                     ->type_name("FILE.toml"));
    take_as_path(command.add_option("--json", options.json, "Write the results as one JSON object")->type_name("FILE"));
    add_plot_option(command, options.plot, "Draw what parts cost and change");
    return [given] { return price(*given); };
}

}  // namespace drapeau::lab
