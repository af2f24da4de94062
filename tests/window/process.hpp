// Process: a program started by a test, with its own surroundings, watched with a time limit and never left behind.
#pragma once

#include "temporary_folder.hpp"

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace drapeau::window_tests {

using drapeau::TemporaryFolder;
using Seconds = std::chrono::duration<double>;

/// Generous: software rendering on a busy machine. Nothing waits this long unless something is wrong.
inline constexpr Seconds patience{60.0};

/// What a program is told besides its arguments. A variable without a value is taken out of the environment.
struct Surroundings {
    std::map<std::string, std::optional<std::string>> variables;
    std::filesystem::path folder;  // where it runs; empty: here
};

class Process {
public:
    /// Starts `command` (found in PATH), both outputs going to files in `logs`.
    Process(const std::vector<std::string>& command, const Surroundings& surroundings, std::filesystem::path logs);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    bool running();
    /// Asks it to end (SIGTERM).
    void stop();
    /// Exit status, 128 + signal if it was killed; nothing if it still runs after `limit`.
    std::optional<int> wait(Seconds limit = patience);

    pid_t id() const { return id_; }
    std::string output() const;
    std::string errors() const;

private:
    pid_t id_ = -1;
    std::optional<int> status_;
    std::filesystem::path output_file_, error_file_;
};

struct Finished {
    int status = 0;
    std::string output, errors;
};

/// Runs a program to its end; throws if it does not end in time.
Finished run(const std::vector<std::string>& command, const Surroundings& surroundings = {}, Seconds limit = patience);

std::string read_text(const std::filesystem::path& file);
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace drapeau::window_tests
