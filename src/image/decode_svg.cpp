// SVG by rsvg-convert, librsvg's own program. A drawing may ask for any amount of time and memory, and librsvg cannot
// be stopped: so it runs in a process of its own, under limits. It reads the SVG from its standard input, so there is
// no folder to resolve references against: it opens no other file and no connection.
#include "image/decoders.hpp"

#include "image/image_file.hpp"
#include "io/error.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <string>
#include <vector>

#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace drapeau {

namespace {

constexpr int longest_drawing = 10;  // seconds of processor time

// A file in memory: unlike a pipe, nobody waits for its reader.
class MemoryFile {
public:
    MemoryFile() : number(memfd_create("svg", MFD_CLOEXEC)) {
        if (number < 0) throw InputError("which cannot be drawn: no file for it could be made");
    }
    ~MemoryFile() { close(number); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    void put(Bytes bytes) const {
        while (!bytes.empty()) {
            const ssize_t count = write(number, bytes.data(), bytes.size());
            if (count < 0 && errno != EINTR) throw InputError("which cannot be drawn: its bytes found no room");
            if (count > 0) bytes = bytes.subspan(std::size_t(count));
        }
        lseek(number, 0, SEEK_SET);
    }
    std::vector<std::uint8_t> contents() const {
        std::vector<std::uint8_t> bytes(std::size_t(std::max<off_t>(0, lseek(number, 0, SEEK_END))));
        std::size_t there = 0;
        while (there < bytes.size()) {
            const ssize_t count = pread(number, bytes.data() + there, bytes.size() - there, off_t(there));
            if (count == 0 || (count < 0 && errno != EINTR)) break;
            if (count > 0) there += std::size_t(count);
        }
        bytes.resize(there);
        return bytes;
    }

    const int number;
};

/// Waits until the program has ended, by itself or killed because nobody wants its result. It keeps its number for now:
/// killed later, that might be another program's.
void wait_for(pid_t child, const std::stop_token& stop) {
    const std::stop_callback abandon(stop, [child] { kill(child, SIGKILL); });
    siginfo_t ended{};
    while (waitid(P_PID, id_t(child), &ended, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
    }
}

/// The exit status as of waitpid. Throws if the program cannot be started.
int run_limited(std::vector<std::string> words, int seconds, const MemoryFile& in, const MemoryFile& out,
                const MemoryFile& err, const std::stop_token& stop) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in.number, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, out.number, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, err.number, STDERR_FILENO);
    pid_t child = 0;
    const int error = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw InputError("which needs " + words[0] + " to be drawn (Debian package librsvg2-bin)");

    const rlimit time{rlim_t(seconds), rlim_t(seconds)}, memory{largest_decoding_memory, largest_decoding_memory};
    prlimit(child, RLIMIT_CPU, &time, nullptr);
    prlimit(child, RLIMIT_DATA, &memory, nullptr);
    wait_for(child, stop);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

/// Exactly of that size, or no larger than it with the proportions of the drawing.
Image drawn(Bytes bytes, int seconds, int width, int height, bool keep_proportions, const std::stop_token& stop) {
    check_wanted(stop);
    const MemoryFile svg, png, complaints;
    svg.put(bytes);
    std::vector<std::string> words{"rsvg-convert", "--format=png", "--width=" + std::to_string(width),
                                   "--height=" + std::to_string(height)};
    if (keep_proportions) words.push_back("--keep-aspect-ratio");
    const int status = run_limited(words, seconds, svg, png, complaints, stop);
    check_wanted(stop);
    if (WIFSIGNALED(status))
        throw InputError("which takes more than " + std::to_string(seconds) + " s or " +
                         memory_text(double(largest_decoding_memory)) + " to draw");
    if (status != 0) {
        const std::vector<std::uint8_t> said = complaints.contents();
        fail_decoding(std::string(said.begin(), said.end()).c_str());
    }
    return decode_png(png.contents(), stop);
}

}  // namespace

Image draw_svg(Bytes bytes, int seconds, const std::stop_token& stop) {
    const Image fitting = drawn(bytes, seconds, svg_longest_side, svg_longest_side, true, stop);
    if (fitting.width == fitting.height) return fitting;
    // Its shorter side may end within a pixel, whose edge would be half transparent: whole pixels the second time.
    return drawn(bytes, seconds, fitting.width, fitting.height, false, stop);
}

Image decode_svg(Bytes bytes, const std::stop_token& stop) {
    return draw_svg(bytes, longest_drawing, stop);
}

}  // namespace drapeau
