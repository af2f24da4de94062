#include "commands.hpp"
#include "report.hpp"

#include <memory>

namespace drapeau::lab {

namespace {

constexpr const char* report_notes =
    "Runs trade, stability, price and converge on the scene, and puts what they say on one page: the answers first, "
    "then\n"
    "pictures and tables, then the settings and the machine. The page needs no other file and no network.\n\n"
    "Example: drapeau-lab report storm --output storm.html\n"
    "Exit status: 0 good (what could not be measured is said on the page), 2 bad input or nothing measured.";

}  // namespace

Job add_report(CLI::App& command) {
    const auto given = std::make_shared<ReportOptions>();
    ReportOptions& options = *given;
    command.footer(report_notes);
    add_scene(command, options.scene);
    add_assignments(command, options.set);
    take_as_path(command.add_option("-o,--output", options.output, "The page to write")->type_name("FILE.html"));
    command
        .add_option("--tolerance", options.tolerance, "Distance that settings and smaller models are named for (1mm)")
        ->type_name("DISTANCE");
    command.add_option("--budget", options.budget, "Time it may take, minutes (8)")->type_name("MINUTES");
    return [given] { return report(*given); };
}

}  // namespace drapeau::lab
