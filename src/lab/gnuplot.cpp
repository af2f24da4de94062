#include "gnuplot.hpp"

#include "io/error.hpp"
#include "io/given_path.hpp"
#include "io/output_file.hpp"
#include "io/text.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace drapeau::lab {

namespace {

/// A file that is only in memory.
class MemoryFile {
public:
    explicit MemoryFile(std::string_view text) : descriptor_(memfd_create("gnuplot", MFD_CLOEXEC)) {
        while (descriptor_ >= 0 && !text.empty()) {
            const ssize_t count = write(descriptor_, text.data(), text.size());
            if (count < 0 && errno != EINTR) break;
            if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
        }
        if (descriptor_ < 0 || !text.empty()) throw InputError("--plot: not enough memory for gnuplot's script");
        lseek(descriptor_, 0, SEEK_SET);
    }
    ~MemoryFile() { close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    int descriptor() const { return descriptor_; }
    std::string text() const {
        std::string all(2000, '\0');
        const ssize_t count = pread(descriptor_, all.data(), all.size(), 0);
        all.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
        return all;
    }

private:
    int descriptor_;
};

/// Runs gnuplot on a script; what it complains of, "" if it ends well.
std::string complaint_of_gnuplot(const std::string& script) {
    const MemoryFile input(script), complaints("");
    std::vector<std::string> words{"gnuplot", "-d", "-"};  // without the user's own settings
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input.descriptor(), STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, complaints.descriptor(), STDERR_FILENO);
    pid_t child = -1;
    const int failure = posix_spawnp(&child, words.front().c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failure != 0)
        throw InputError(std::string("--plot needs gnuplot, which could not be started: ") + std::strerror(failure) +
                         " (Debian's package is gnuplot-nox)");
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
    std::string said;  // gnuplot shows the line and a caret before it says what is wrong
    for (std::string left = complaints.text(); !left.empty();) {
        const auto end = left.find('\n');
        const std::string line(without_space(std::string_view(left).substr(0, end)));
        if (!line.empty() && line != "^") said = line;
        left = end == std::string::npos ? "" : left.substr(end + 1);
    }
    return said.empty() ? "it ended badly" : one_line(said, 300);
}

/// Twice as many pixels as an SVG has units.
std::string terminal_of(const std::string& ending) {
    const std::string font = "enhanced font 'DejaVu Sans,13'";
    return ending == ".svg"
               ? "set terminal svg size 960,640 background '#ffffff' " + font + "\n"
               : "set terminal pngcairo size 1920,1280 fontscale 2 pointscale 2 linewidth 2 " + font + "\n";
}

}  // namespace

void check_plot(const std::string& option, const std::string& file) {
    if (file.empty()) return;
    const std::string ending = ending_of(file);
    if (ending != ".svg" && ending != ".png")
        throw InputError(option + " = " + one_line(file, 1000) +
                         ": .svg or .png is allowed, the ending chooses the format");
    if (const std::string complaint = complaint_of_gnuplot(terminal_of(ending)); !complaint.empty())
        throw InputError(option + ": gnuplot cannot make " + ending + " files: " + complaint);
}

void plot(const std::string& file, const std::string& script) {
    OutputFile output(file);
    const std::string complaint =
        complaint_of_gnuplot("set encoding utf8\nset micro\n" + terminal_of(ending_of(file)) + "set output " +
                             plot_text(output.path().string()) + "\n" + script + "\nunset output\n");
    std::error_code failure;
    if (!complaint.empty() || std::filesystem::file_size(output.path(), failure) == 0 || failure)
        throw InputError("--plot = " + one_line(file, 1000) + ": gnuplot could not make it" +
                         (complaint.empty() ? "" : ": " + complaint));
    output.finish();
}

std::string plot_text(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? "''" : c == '\n' ? "'.\"\\n\".'" : std::string(1, c);
    return quoted + "'";
}

std::string plot_number(double value) {
    return shortest(value);
}

MethodStyle style_of(Method method) {
    constexpr MethodStyle styles[] = {{"#E69F00", 5, 4},   {"#0072B2", 7, 6},   {"#D55E00", 9, 8},
                                      {"#009E73", 13, 12}, {"#CC79A7", 11, 10}, {"#56B4E9", 15, 14}};
    return styles[static_cast<std::size_t>(method) % std::size(styles)];
}

}  // namespace drapeau::lab
