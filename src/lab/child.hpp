// Child: another program run to its end, with what it is given and what it says.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace drapeau::lab {

struct Said {
    int status = -1;  // the exit status; -1 if a signal ended it
    std::string output, complaints;
};

/// Runs a program found on PATH, or the one at a path, with `input` on its standard input. Throws InputError, saying
/// that `what` needs it, if it cannot be started or there is no memory.
Said run_child(const std::string& what, std::vector<std::string> words, std::string_view input);

}  // namespace drapeau::lab
