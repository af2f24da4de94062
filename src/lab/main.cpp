// The laboratory's command line: subcommands, and the one place where bad input becomes an exit status.
#include "io/command_line.hpp"
#include "io/error.hpp"
#include "io/terminal.hpp"
#include "io/text.hpp"
#include "run.hpp"
#include "scene/file.hpp"
#include "scene/reference.hpp"

#include <cstdio>
#include <new>

namespace {

using namespace drapeau;
using namespace drapeau::lab;

constexpr const char* exit_notes =
    "Example: drapeau-lab run storm --seconds 10 --dt auto --state storm.csv\n"
    "Exit status: 0 good, 2 bad input, 3 diverged.";
constexpr const char* run_notes =
    "A step given as a number is used as it is, and the time must be a whole number of such steps. With dt auto the "
    "run\n"
    "takes the largest step known to be stable, in whole batches of 1/60 s as the window does; a time that is no "
    "whole\n"
    "number of batches is divided into equal steps none of which is longer.\n\n"
    "The state file has one line for each mass, row by row: column,row,x,y,z,vx,vy,vz in m and m/s, with as many "
    "digits\n"
    "as read back to the same number in the precision of the run.";

constexpr const char* program = "drapeau-lab";

int refuse(const std::string& message) {
    complain(program, message);
    return exit_bad_input;
}

int list_scenes() {
    for (const std::string& name : shipped_scenes()) std::puts(name.c_str());
    return exit_good;
}

int list_settings() {
    std::fputs(settings_reference().c_str(), stdout);
    return exit_good;
}

}  // namespace

int main(int count, char** arguments) {
    CLI::App app("drapeau-lab: what every setting of a flag costs, and where it leads", "drapeau-lab");
    app.set_version_flag("--version", "drapeau-lab " DRAPEAU_VERSION);
    app.require_subcommand(1);
    app.footer(exit_notes);

    RunOptions options;
    auto* run_command = app.add_subcommand("run", "Simulate a scene for a time: where it is then, and what it cost");
    run_command->footer(std::string(run_notes) + "\n\n" + exit_notes);
    take_as_path(
        run_command->add_option("SCENE", options.scene, "A scene file, or the name of a shipped scene")->required());
    run_command->add_option("--seconds", options.seconds, "Time to simulate, s")->required()->type_name("T");
    run_command->add_option("--method", options.method, method_choices())->type_name("M");
    run_command->add_option("--dt", options.dt, "Step, s, or auto")->type_name("S");
    run_command->add_option("--precision", options.precision, "float or double")->type_name("P");
    add_assignments(*run_command, options.set);
    run_command
        ->add_option("--threads", options.threads, "Threads that share a step; the result is the same for any number")
        ->type_name("N")
        ->check(whole_number(1, 256));
    take_as_path(
        run_command->add_option("--state", options.state, "Write the state of every mass")->type_name("FILE.csv"));
    take_as_path(
        run_command->add_option("--json", options.json, "Write the results as one JSON object")->type_name("FILE"));
    take_as_path(
        run_command->add_option("--csv", options.csv, "Write the results as a header and a row")->type_name("FILE"));
    run_command->add_flag("--force", options.force, "Run it however long it is estimated to take");
    auto* scenes_command = app.add_subcommand("scenes", "List the shipped scenes");
    auto* settings_command = app.add_subcommand("settings", "List every setting of a scene, with unit and range");

    try {
        parse(app, count, arguments);
        if (settings_command->parsed()) return finish_output(program, list_settings());
        return finish_output(program, scenes_command->parsed() ? list_scenes() : run(options));
    } catch (const CLI::Success& help_or_version) {
        return finish_output(program, app.exit(help_or_version));
    } catch (const CLI::ParseError& error) {
        if (app.get_subcommands().empty()) {
            const std::string given =
                count > 1 ? one_line(arguments[1]) + " is no command; " : "a command is missing; ";
            return refuse(given + "run, scenes or settings is allowed (drapeau-lab --help says more)");
        }
        return refuse(explained(app, error) + " (drapeau-lab --help says more)");
    } catch (const InputError& error) {
        return refuse(error.what());
    } catch (const std::bad_alloc&) {
        return refuse("not enough memory for this scene");
    } catch (const std::exception& error) {  // what the file system may still say
        return refuse(one_line(error.what(), 300));
    }
}
