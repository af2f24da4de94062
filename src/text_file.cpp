#include "text_file.hpp"

#include "error.hpp"
#include "text.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace drapeau {

namespace fs = std::filesystem;

namespace {

struct Descriptor {
    int number;

    explicit Descriptor(int descriptor) : number(descriptor) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (number >= 0) close(number);
    }
};

[[noreturn]] void fail(const std::string& name, const std::string& why) {
    throw InputError(one_line(name, 1000) + ": " + why);
}
[[noreturn]] void fail_writing(const std::string& name, int error) {
    fail(name, std::string("cannot be written: ") + std::strerror(error));
}

/// Devices, pipes and what stands for an open file are written as they are; they cannot be replaced.
bool is_written_directly(const fs::path& name) {
    const std::string absolute = fs::absolute(name).lexically_normal().string();
    if (absolute.starts_with("/dev/") || absolute.starts_with("/proc/")) return true;
    std::error_code ignored;
    const auto type = fs::status(name, ignored).type();
    return type != fs::file_type::regular && type != fs::file_type::not_found;
}

/// A device or pipe open for writing. What is this program's own already is not opened anew: it would begin at its
/// start.
int open_directly(const std::string& name) {
    if (name == "/dev/stdout") return dup(STDOUT_FILENO);
    if (name == "/dev/stderr") return dup(STDERR_FILENO);
    return open(name.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
}

/// The name a finished file takes: where a link points, so that the link stays.
fs::path behind_links(const fs::path& name) {
    std::error_code error;
    const fs::path target = fs::weakly_canonical(name, error);
    return error ? name : target;
}

fs::path unfinished(const fs::path& target) {
    std::string hidden = ".";
    hidden.append(target.filename().string(), 0, 200).append(".").append(std::to_string(getpid()));
    return target.parent_path() / hidden;
}

/// Signals that would end the program wait while a file is given its name.
class SignalsWait {
public:
    SignalsWait() {
        sigset_t ending;
        sigemptyset(&ending);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&ending, signal);
        pthread_sigmask(SIG_BLOCK, &ending, &before_);
    }
    ~SignalsWait() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    SignalsWait(const SignalsWait&) = delete;
    SignalsWait& operator=(const SignalsWait&) = delete;

private:
    sigset_t before_;
};

void write_all(int descriptor, std::string_view text, const std::string& name) {
    while (!text.empty()) {
        const ssize_t count = write(descriptor, text.data(), text.size());
        if (count < 0 && errno != EINTR) fail_writing(name, errno);
        if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
    }
}

void write_into(int descriptor, const std::string& name, const std::function<void(const Append&)>& write) {
    std::string waiting;
    write([&](std::string_view text) {
        waiting += text;
        if (waiting.size() < (1 << 16)) return;
        write_all(descriptor, waiting, name);
        waiting.clear();
    });
    write_all(descriptor, waiting, name);
}

}  // namespace

std::string read_text_file(const std::string& name, std::size_t most_bytes) {
    const Descriptor file(open(name.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (file.number < 0) fail(name, std::strerror(errno));

    std::string bytes;
    std::string block(1 << 16, '\0');
    constexpr int patience = 5000;  // ms
    while (bytes.size() <= most_bytes) {
        pollfd waiting{file.number, POLLIN, 0};
        if (poll(&waiting, 1, patience) == 0) fail(name, "nothing to read for 5 s");
        const ssize_t count = read(file.number, block.data(), block.size());
        if (count == 0) return bytes;
        if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (count < 0) fail(name, std::strerror(errno));
        bytes.append(block, 0, static_cast<std::size_t>(count));
    }
    fail(name, "more than " + memory_text(static_cast<double>(most_bytes)) + " long");
}

void check_writable(const std::string& name) {
    std::error_code ignored;
    if (name.empty()) throw InputError("an empty file name cannot be written");
    if (fs::is_directory(name, ignored)) fail(name, "a folder, a file to write is wanted");
    if (is_written_directly(name)) {
        if (access(name.c_str(), W_OK) != 0) fail_writing(name, errno);
        return;
    }
    // A file that exists may be replaced only if it may be written.
    if (fs::exists(name, ignored) && access(name.c_str(), W_OK) != 0) fail_writing(name, errno);
    const SignalsWait signals_wait;
    const fs::path trial = unfinished(behind_links(name));
    const Descriptor file(open(trial.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (file.number < 0) fail_writing(name, errno);
    unlink(trial.c_str());
}

void write_text_file(const std::string& name, const std::function<void(const Append&)>& write) {
    if (is_written_directly(name)) {
        const Descriptor file(open_directly(name));
        if (file.number < 0) fail_writing(name, errno);
        write_into(file.number, name, write);
        return;
    }

    const SignalsWait signals_wait;
    const fs::path target = behind_links(name);
    const fs::path part = unfinished(target);
    try {
        const Descriptor file(open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
        if (file.number < 0) fail_writing(name, errno);
        write_into(file.number, name, write);
        if (fsync(file.number) != 0) fail_writing(name, errno);
        if (rename(part.c_str(), target.c_str()) != 0) fail_writing(name, errno);
    } catch (...) {
        unlink(part.c_str());
        throw;
    }
}

}  // namespace drapeau
