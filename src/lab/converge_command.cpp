#include "commands.hpp"
#include "converge.hpp"

#include <memory>

namespace drapeau::lab {

namespace {

constexpr const char* converge_notes =
    "Steps: every method in double on the scene's grid, its step halved again and again. Order: log2 of the ratio of\n"
    "successive differences (Richardson); error: from a reference by rk4, which leapfrog confirms and judges.\n"
    "Grids: the same cloth on grids whose cells are halved, flown by rk4 at far smaller steps than it needs, compared "
    "at\n"
    "the coarsest grid's masses. What is inside the cloth keeps its mass per area and its stiffness. All begin on one\n"
    "smooth surface: the coarsest grid's start, with cubic splines between its masses. With --settle each grid then\n"
    "swings in by itself.\n"
    "Differences and errors are root mean squares over masses and up to 60 moments. Where there is no convergence its\n"
    "cause is looked for: the growth of a nanometre, springs that are compressed and folds as wide as the cells, "
    "borders "
    "as\n"
    "heavy as the inside, a stretch limit, rounding. What does not fit the budget is left out, the finest first.\n\n"
    "With --part each method, grid, and grid with light borders is kept as soon as it is measured, and --budget is "
    "work\n"
    "of the whole sweep at 4 ns for a step of one mass, not time: methods share it evenly.\n\n"
    "Example: drapeau-lab converge drum --methods leapfrog,rk4 --levels 4\n"
    "Exit status: 0 good (whether it converges or not), 2 bad input, 3 diverged.";

}  // namespace

Job add_converge(CLI::App& command) {
    const auto given = std::make_shared<ConvergeOptions>();
    ConvergeOptions& options = *given;
    command.footer(converge_notes);
    add_scene(command, options.scene);
    command
        .add_option("--methods", options.methods, "Methods to measure, separated by commas; all of them unless given")
        ->type_name("M,...");
    command.add_option("--grids", options.grids, "Three grids or more, each with the cells of the one before halved")
        ->type_name("COLUMNSxROWS,...");
    command.add_option("--levels", options.levels, "Or so many, from the scene's own grid on (4)")->type_name("N");
    add_comparison_options(command, options);
    take_as_path(command.add_option("--json", options.json, "Write the results as one JSON object")->type_name("FILE"));
    add_plot_option(command, options.plot, "Draw differences over step and cell");
    return [given] { return converge(*given); };
}

}  // namespace drapeau::lab
