// Commands: what each subcommand takes, and what it does with that. Each adds its options and help to its part of the
// command line and returns what is to be done once that is read: it gives the exit status and throws InputError for bad
// input, before anything is computed or written.
#pragma once

#include "io/command_line.hpp"

#include <functional>
#include <string>

namespace drapeau::lab {

inline constexpr const char* program = "drapeau-lab";

using Job = std::function<int()>;

Job add_run(CLI::App& command);
Job add_trade(CLI::App& command);
Job add_stability(CLI::App& command);
Job add_merge(CLI::App& command);

/// What every command asks for.
inline void add_scene(CLI::App& command, std::string& scene) {
    take_as_path(command.add_option("SCENE", scene, "A scene file, or the name of a shipped scene")->required());
}

}  // namespace drapeau::lab
