#include "commands.hpp"
#include "stability.hpp"

#include <memory>

namespace drapeau::lab {

namespace {

constexpr const char* stability_notes =
    "The cloth lies at rest without weight or wind, all but for noise of a ten-billionth of the distance between "
    "masses.\n"
    "Its growth in a step is fitted; a run that breaks is not waited for. Theory is the method's own limit for the\n"
    "fastest mode of springs, bending, dampers, drag and friction as they lie. In motion a cloth may have faster "
    "modes,\n"
    "up to the bound that dt auto respects.\n\n"
    "Example: drapeau-lab stability report --methods leapfrog,rk4 --stiffness 80,800,8000\n"
    "Exit status: 0 good, 2 bad input.";

}  // namespace

Job add_stability(CLI::App& command) {
    const auto given = std::make_shared<StabilityOptions>();
    StabilityOptions& options = *given;
    command.footer(stability_notes);
    add_scene(command, options.scene);
    command
        .add_option("--methods", options.methods, "Methods to measure, separated by commas; all of them unless given")
        ->type_name("M,...");
    command
        .add_option("--stiffness", options.stiffness,
                    "Stiffnesses, N/m; from a hundredth of the scene's to a hundredfold unless given")
        ->type_name("K,...");
    command
        .add_option("--damping", options.damping,
                    "Dampings of every spring, N s/m; from none to a tenth of sqrt(k m) unless given")
        ->type_name("C,...");
    add_assignments(command, options.set);
    take_as_path(command.add_option("--json", options.json, "Write the results as one JSON object")->type_name("FILE"));
    add_plot_option(command, options.plot, "Draw limits over stiffness and damping");
    add_part_options(command, options.part);
    return [given] { return stability(*given); };
}

}  // namespace drapeau::lab
