// Child: another program, run to its end.
#pragma once

#include <string>
#include <vector>

namespace drapeau::bench {

/// Where a child writes what is read of it. Whatever else it writes to its standard output is dropped.
enum class Outlet {
    standard_output,  // and its errors are dropped
    results           // the file `child_results`, for a child that is told to write one; its errors pass through
};
constexpr const char* child_results = "/dev/fd/3";

struct ChildRun {
    std::string output;
    std::string ending;  // how it ended, for a message: "ended with status 2"; empty for status 0
};

/// Runs the program in that file, with nothing to read. Throws InputError if it cannot be started.
ChildRun run_child(const std::string& program, std::vector<std::string> arguments, Outlet outlet);

}  // namespace drapeau::bench
