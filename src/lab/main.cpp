// The laboratory's command line: subcommands, and the one place where bad input becomes an exit status.
#include "io/command_line.hpp"
#include "io/error.hpp"
#include "io/terminal.hpp"
#include "io/text.hpp"
#include "run.hpp"
#include "scene/file.hpp"
#include "scene/reference.hpp"
#include "stability.hpp"
#include "trade.hpp"

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

constexpr const char* trade_notes =
    "Each setting starts from the same swung-in state and is compared with a reference: rk4 in double at far smaller\n"
    "steps, whose error is estimated and confirmed by leapfrog (which judges rk4). Steps are whole parts of 1/60 s, as "
    "in\n"
    "the window. Errors are root mean squares over the masses that are free, at the end of the time compared;\n"
    "\"greatest\", energy and stretch are the greatest at any of up to 60 moments. Cost is processor time of the run "
    "as the\n"
    "programs run it, its energy ledger included: the least of several repeats. Past the time in which a nanometre\n"
    "becomes a millimetre, or --tolerance, the statistics of the fly end's middle are compared instead.\n\n"
    "--tolerance is a distance at the end of the time compared (and the rms over it). It is not time.tolerance of "
    "scenes,\n"
    "which is in m per simulated second.\n\n"
    "Example: drapeau-lab trade report --tolerance 1mm --write quick.toml\n"
    "Exit status: 0 good, 1 no setting meets --tolerance or its check failed, 2 bad input, 3 diverged.";

constexpr const char* program = "drapeau-lab";

void add_scene(CLI::App& command, std::string& scene) {
    take_as_path(command.add_option("SCENE", scene, "A scene file, or the name of a shipped scene")->required());
}

void add_trade(CLI::App& command, TradeOptions& options) {
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
    add_assignments(command, options.set);
    command.add_option("--settle", options.settle, "Time to swing in before, s (2)")->type_name("T");
    command
        .add_option("--seconds", options.seconds, "Time compared, s (0.5, or half the chaos horizon if that is less)")
        ->type_name("T");
    command.add_option("--budget", options.budget, "Time it may take, minutes (2)")->type_name("MINUTES");
    command.add_option("--tolerance", options.tolerance, "Name the cheapest setting within this distance, such as 1mm")
        ->type_name("DISTANCE");
    take_as_path(command.add_option("--write", options.write, "Save the scene with that setting, if its check holds")
                     ->type_name("FILE.toml"));
    take_as_path(command.add_option("--json", options.json, "Write the results as one JSON object")->type_name("FILE"));
}

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

constexpr const char* stability_notes =
    "The cloth lies at rest without weight or wind, all but for noise of a ten-billionth of the distance between "
    "masses.\n"
    "Its growth in a step is fitted; a run that breaks is not waited for. Theory is the method's own limit for the\n"
    "fastest mode of the springs, dampers, drag and friction as they lie. In motion a cloth may have faster modes, up "
    "to\n"
    "the bound that dt auto respects.\n\n"
    "Example: drapeau-lab stability report --methods leapfrog,rk4 --stiffness 80,800,8000\n"
    "Exit status: 0 good, 2 bad input.";

void add_stability(CLI::App& command, StabilityOptions& options) {
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
    add_scene(*run_command, options.scene);
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
    TradeOptions trade_options;
    auto* trade_command =
        app.add_subcommand("trade", "Speed against accuracy: what every method, step and precision costs and loses");
    add_trade(*trade_command, trade_options);
    StabilityOptions stability_options;
    auto* stability_command = app.add_subcommand(
        "stability", "The largest stable step of every method over stiffness and damping, measured and in theory");
    add_stability(*stability_command, stability_options);
    auto* scenes_command = app.add_subcommand("scenes", "List the shipped scenes");
    auto* settings_command = app.add_subcommand("settings", "List every setting of a scene, with unit and range");

    try {
        parse(app, count, arguments);
        if (settings_command->parsed()) return finish_output(program, list_settings());
        if (trade_command->parsed()) return finish_output(program, trade(trade_options));
        if (stability_command->parsed()) return finish_output(program, stability(stability_options));
        return finish_output(program, scenes_command->parsed() ? list_scenes() : run(options));
    } catch (const CLI::Success& help_or_version) {
        return finish_output(program, app.exit(help_or_version));
    } catch (const CLI::ParseError& error) {
        if (app.get_subcommands().empty()) {
            const std::string given =
                count > 1 ? one_line(arguments[1]) + " is no command; " : "a command is missing; ";
            return refuse(given +
                          "run, trade, stability, scenes or settings is allowed (drapeau-lab --help says more)");
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
