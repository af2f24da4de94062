#include "commands.hpp"
#include "run.hpp"
#include "scene/file.hpp"

#include <memory>

namespace drapeau::lab {

namespace {

constexpr const char* run_notes =
    "A step given as a number is used as it is, and the time must be a whole number of such steps. With dt auto the "
    "run\n"
    "takes the largest step known to be stable, in whole batches of 1/60 s as the window does; a time that is no "
    "whole\n"
    "number of batches is divided into equal steps none of which is longer.\n\n"
    "The state file has one line for each mass, row by row: column,row,x,y,z,vx,vy,vz in m and m/s, with as many "
    "digits\n"
    "as read back to the same number in the precision of the run.\n\n"
    "Example: drapeau-lab run storm --seconds 10 --dt auto --state storm.csv\n"
    "Exit status: 0 good, 2 bad input, 3 diverged.";

}  // namespace

Job add_run(CLI::App& command) {
    const auto given = std::make_shared<RunOptions>();
    RunOptions& options = *given;
    command.footer(run_notes);
    add_scene(command, options.scene);
    command.add_option("--seconds", options.seconds, "Time to simulate, s")->required()->type_name("T");
    command.add_option("--method", options.method, method_choices())->type_name("M");
    command.add_option("--dt", options.dt, "Step, s, or auto")->type_name("S");
    command.add_option("--precision", options.precision, "float or double")->type_name("P");
    add_assignments(command, options.set);
    command
        .add_option("--threads", options.threads, "Threads that share a step; the result is the same for any number")
        ->type_name("N")
        ->check(whole_number(1, 256));
    take_as_path(command.add_option("--state", options.state, "Write the state of every mass")->type_name("FILE.csv"));
    take_as_path(command.add_option("--json", options.json, "Write the results as one JSON object")->type_name("FILE"));
    take_as_path(
        command.add_option("--csv", options.csv, "Write the results as a header and a row")->type_name("FILE"));
    command.add_flag("--force", options.force, "Run it however long it is estimated to take");
    return [given] { return run(*given); };
}

}  // namespace drapeau::lab
