// The laboratory as a user runs it: a folder of its own, arguments, outputs, exit status.
#pragma once

#include "catch.hpp"
#include "temporary_folder.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace drapeau::testing {

namespace fs = std::filesystem;

inline const fs::path lab = fs::read_symlink("/proc/self/exe").parent_path() / "drapeau-lab";

inline std::string contents(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

struct Outcome {
    int status = -1;
    std::string output;    // standard output
    std::string messages;  // standard error
};

/// A folder of its own in which the laboratory runs.
struct Bench : TemporaryFolder {
    void write(const std::string& name, const std::string& text) const { std::ofstream(path / name) << text; }

    /// Under a sanitizer, beside other tests, a minute's work may take several.
    Outcome run(const std::string& arguments, const std::string& under = "timeout 600 ") const {
        const std::string command =
            "cd '" + path.string() + "' && " + under + "'" + lab.string() + "' " + arguments + " 2>.messages";
        Outcome outcome;
        std::FILE* pipe = popen(command.c_str(), "r");
        std::array<char, 4096> block;
        for (std::size_t n; (n = std::fread(block.data(), 1, block.size(), pipe)) > 0;)
            outcome.output.append(block.data(), n);
        outcome.status = WEXITSTATUS(pclose(pipe));
        outcome.messages = contents(path / ".messages");
        fs::remove(path / ".messages");
        return outcome;
    }

    std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(path)) names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }
};

inline bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Bad input as it should be: status 2, one line on standard error that says this, nothing on standard output.
inline void check_refused(const Outcome& outcome, const std::string& part) {
    INFO("status " << outcome.status << ", messages: " << outcome.messages);
    CHECK(outcome.status == 2);
    CHECK(outcome.output.empty());
    CHECK(outcome.messages.starts_with("drapeau-lab: "));
    CHECK(std::count(outcome.messages.begin(), outcome.messages.end(), '\n') == 1);
    CHECK(has(outcome.messages, part));
}

}  // namespace drapeau::testing
