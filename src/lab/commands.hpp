// Commands: what each subcommand takes, and what it does with that. Each adds its options and help to its part of the
// command line and returns what is to be done once that is read: it gives the exit status and throws InputError for bad
// input, before anything is computed or written.
#pragma once

#include "io/command_line.hpp"
#include "part_file.hpp"
#include "program.hpp"

#include <functional>
#include <string>

namespace drapeau::lab {

using Job = std::function<int()>;

Job add_run(CLI::App& command);
Job add_trade(CLI::App& command);
Job add_price(CLI::App& command);
Job add_stability(CLI::App& command);
Job add_converge(CLI::App& command);
Job add_merge(CLI::App& command);
Job add_report(CLI::App& command);

/// What every command asks for.
inline void add_scene(CLI::App& command, std::string& scene) {
    take_as_path(command.add_option("SCENE", scene, "A scene file, or the name of a shipped scene")->required());
}

inline void add_plot_option(CLI::App& command, std::string& file, const std::string& what) {
    take_as_path(command.add_option("--plot", file, what + " into a picture, by gnuplot")->type_name("FILE.svg|png"));
}

/// What every sweep takes.
inline void add_part_options(CLI::App& command, PartOptions& options) {
    take_as_path(
        command.add_option("--part", options.file, "Keep each point in this file as it is done; merge reads it")
            ->type_name("FILE.jsonl"));
    command.add_option("--shard", options.shard, "Measure only the I-th of N shares of the points; merge joins them")
        ->type_name("I/N");
    command.add_flag("--resume", options.resume, "Go on with what --part holds, if it is there");
}

}  // namespace drapeau::lab
