#include "io/output_file.hpp"

#include "io/error.hpp"
#include "io/text.hpp"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace drapeau {

namespace fs = std::filesystem;

namespace {

constexpr int max_links = 40;                       // as many as the system follows
constexpr std::chrono::seconds reader_patience(5);  // for somebody to open the other end of a pipe
constexpr std::size_t longest_kept_name = 200;      // bytes of the target's name within that of the hidden file

[[noreturn]] void fail(const std::string& name, const std::string& why) {
    throw InputError(one_line(name, 1000) + ": " + why);
}
[[noreturn]] void fail_writing(const std::string& name, int error) {
    fail(name, std::string("cannot be written: ") + std::strerror(error));
}

/// The path behind all links, also when the last of them points to nothing yet.
fs::path behind_links(const std::string& name) {
    fs::path path = name;
    for (int link = 0; link < max_links; ++link) {
        std::error_code failure;
        const fs::path folder = fs::canonical(path.has_parent_path() ? path.parent_path() : ".", failure);
        if (failure) fail_writing(name, failure.value());
        path = folder / path.filename();
        // What stands for an open file is no file to look behind.
        if (folder.string().starts_with("/proc/")) return path;
        const fs::path next = fs::read_symlink(path, failure);
        if (failure) return path;
        path = folder / next;
    }
    fail_writing(name, ELOOP);
}

/// The number of this program's own open file behind /dev/stdout, /dev/fd/3 and the like.
std::optional<int> own_descriptor(const fs::path& path) {
    if (path.parent_path() != "/proc/" + std::to_string(getpid()) + "/fd") return {};
    const auto number = number_in(path.filename().string());
    return number ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

/// What a name stands for, once all that can be known of it without touching anything has been checked.
struct Target {
    fs::path path;  // behind all links
    struct stat status {};
    bool exists = false;
    bool direct = false;  // a device, a pipe or an open file: it cannot be replaced

    explicit Target(const std::string& name) {
        if (name.empty()) throw InputError("an empty file name cannot be written");
        path = behind_links(name);
        exists = stat(path.c_str(), &status) == 0;
        if (!exists && errno != ENOENT) fail_writing(name, errno);
        if (!path.has_filename() || (exists && S_ISDIR(status.st_mode)))
            fail(name, "a folder, a file to write is wanted");
        direct = path.string().starts_with("/proc/") || (exists && !S_ISREG(status.st_mode));
        if (direct && !exists) fail_writing(name, ENOENT);
        // A file that exists may be replaced only if it may be written.
        if (exists && access(path.c_str(), W_OK) != 0) fail_writing(name, errno);
    }
};

/// What is this program's own already is not opened anew: it would begin at its start. A pipe is waited for, but not
/// for ever: somebody has to open its other end.
int open_directly(const std::string& name, const Target& target) {
    const auto own = own_descriptor(target.path);
    const auto deadline = std::chrono::steady_clock::now() + reader_patience;
    while (true) {
        const int descriptor = own ? fcntl(*own, F_DUPFD_CLOEXEC, 0)
                                   : open(target.path.c_str(), O_WRONLY | O_APPEND | O_NONBLOCK | O_CLOEXEC);
        if (descriptor >= 0) {
            if (!own) fcntl(descriptor, F_SETFL, O_APPEND);
            return descriptor;
        }
        if (errno != ENXIO || !S_ISFIFO(target.status.st_mode)) fail_writing(name, errno);
        if (std::chrono::steady_clock::now() > deadline) fail(name, "nobody reads this pipe");
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

/// Makes a hidden file beside the target, with its ending and permissions, and sets `path` to it.
int open_beside(const std::string& name, const Target& target, fs::path& path) {
    static std::atomic<unsigned> count = 0;
    std::string kept = target.path.filename().string();
    if (kept.size() > longest_kept_name) kept.erase(0, kept.size() - longest_kept_name);
    int descriptor = -1;
    do {
        const std::string unique = "." + std::to_string(getpid()) + "-" + std::to_string(count++) + ".";
        path = target.path.parent_path() / (unique + kept);
        descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor < 0 && errno == EEXIST);
    if (descriptor < 0) fail_writing(name, errno);
    if (!target.exists) return descriptor;

    // The owner first: a change of owner takes permissions away. Only an administrator may give a file to another.
    const bool same_owner = fchown(descriptor, target.status.st_uid, target.status.st_gid) == 0;
    const mode_t kept_bits = same_owner ? 07777 : 0777;
    if (fchmod(descriptor, target.status.st_mode & kept_bits) == 0) return descriptor;
    const int error = errno;
    close(descriptor);
    unlink(path.c_str());
    fail_writing(name, error);
}

/// Signals that would end the program wait while a file is written and given its name.
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

}  // namespace

OutputFile::OutputFile(const std::string& name) : name_(name) {
    const Target target(name);
    target_ = path_ = target.path;
    direct_ = target.direct;
    descriptor_ = direct_ ? open_directly(name, target) : open_beside(name, target, path_);
}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!direct_ && !finished_) unlink(path_.c_str());
}

void OutputFile::append(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) fail_writing(name_, errno);
        if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
    }
}

void OutputFile::finish() {
    if (!direct_ && fsync(descriptor_) != 0) fail_writing(name_, errno);
    if (close(std::exchange(descriptor_, -1)) != 0) fail_writing(name_, errno);
    if (!direct_ && rename(path_.c_str(), target_.c_str()) != 0) fail_writing(name_, errno);
    finished_ = true;
}

void write_file(const std::string& name, const std::function<void(const Append&)>& write) {
    const SignalsWait signals_wait;
    OutputFile file(name);
    constexpr std::size_t block = 1 << 16;  // bytes
    std::string waiting;
    write([&](std::string_view bytes) {
        waiting += bytes;
        if (waiting.size() < block) return;
        file.append(waiting);
        waiting.clear();
    });
    file.append(waiting);
    file.finish();
}

void check_writable(const std::string& name) {
    const SignalsWait signals_wait;
    // A pipe is not opened on trial: its reader would see it end.
    if (!Target(name).direct) OutputFile file(name);
}

bool is_same_file(const std::string& one, const std::string& other) {
    std::error_code ignored;
    return fs::equivalent(one, other, ignored) || behind_links(one) == behind_links(other);
}

void check_outputs(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs) {
    std::vector<NamedFile> taken = inputs;
    for (const NamedFile& output : outputs) {
        check_writable(output.name);
        std::error_code ignored;
        if (fs::is_other(output.name, ignored)) continue;
        for (const NamedFile& other : taken) {
            if (is_same_file(other.name, output.name))
                throw InputError(output.asked_by + " = " + one_line(output.name, 1000) + ": the same file as " +
                                 other.asked_by);
        }
        taken.push_back(output);
    }
}

}  // namespace drapeau
