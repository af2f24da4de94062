// The laboratory's command line: subcommands, and the one place where bad input becomes an exit status.
#include "commands.hpp"
#include "exit_status.hpp"
#include "io/error.hpp"
#include "io/terminal.hpp"
#include "io/text.hpp"
#include "scene/file.hpp"
#include "scene/reference.hpp"

#include <cstdio>
#include <iterator>
#include <new>
#include <utility>
#include <vector>

namespace {

using namespace drapeau;
using namespace drapeau::lab;

constexpr const char* exit_notes =
    "Example: drapeau-lab run storm --seconds 10 --dt auto --state storm.csv\n"
    "Exit status: 0 good, 1 a check that did not hold or a failure, 2 bad input, 3 diverged.";
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

struct Command {
    const char* name;
    const char* description;
    Job (*add)(CLI::App&);
};

Job add_scenes(CLI::App&) {
    return list_scenes;
}
Job add_settings(CLI::App&) {
    return list_settings;
}

constexpr Command commands[] = {
    {"run", "Simulate a scene for a time: where it is then, and what it cost", add_run},
    {"trade", "Speed against accuracy: what every method, step and precision costs and loses", add_trade},
    {"price", "What each part of a scene costs in time and what leaving it out changes", add_price},
    {"stability", "The largest stable step of every method over stiffness and damping, measured and in theory",
     add_stability},
    {"converge", "Error against step and grid: the orders measured, and what prevents convergence", add_converge},
    {"report", "All of that on one page: trade, stability, price and converge", add_report},
    {"merge", "Join the parts of a sweep that several processes or machines made", add_merge},
    {"scenes", "List the shipped scenes", add_scenes},
    {"settings", "List every setting of a scene, with unit and range", add_settings},
};

/// "run, trade or stability"
std::string names_of_commands() {
    std::string names;
    for (const Command& command : commands) {
        const char* separator = names.empty() ? "" : &command == &commands[std::size(commands) - 1] ? " or " : ", ";
        names += separator + std::string(command.name);
    }
    return names;
}

}  // namespace

int main(int count, char** arguments) {
    CLI::App app("drapeau-lab: what every setting of a flag costs, and where it leads", "drapeau-lab");
    app.set_version_flag("--version", "drapeau-lab " DRAPEAU_VERSION);
    app.require_subcommand(1);
    app.footer(exit_notes);

    std::vector<std::pair<CLI::App*, Job>> jobs;
    for (const Command& command : commands) {
        CLI::App* part = app.add_subcommand(command.name, command.description);
        jobs.emplace_back(part, command.add(*part));
    }

    try {
        parse(app, count, arguments);
        for (const auto& [part, job] : jobs)
            if (part->parsed()) return finish_output(program, job());
        return exit_bad_input;  // never: one is required
    } catch (const CLI::Success& help_or_version) {
        return finish_output(program, app.exit(help_or_version));
    } catch (const CLI::ParseError& error) {
        if (app.get_subcommands().empty()) {
            const std::string given =
                count > 1 ? one_line(arguments[1]) + " is no command; " : "a command is missing; ";
            return refuse(given + names_of_commands() + " is allowed (drapeau-lab --help says more)");
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
