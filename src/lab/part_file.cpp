#include "part_file.hpp"

#include "exit_status.hpp"
#include "gnuplot.hpp"
#include "io/error.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "program.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace drapeau::lab {

namespace {

constexpr int ending_signals[] = {SIGINT, SIGTERM, SIGHUP};

[[noreturn]] void fail(const std::string& file, const std::string& why) {
    throw InputError(one_line(file, 1000) + ": " + why);
}
[[noreturn]] void fail_writing(const std::string& file, int error) {
    fail(file, std::string("cannot be written: ") + std::strerror(error));
}

char farewell[2000];  // what a signal's handler says

// Records are whole at any moment: nothing is waited for. A bar of progress that was drawn is cleared.
extern "C" void say_how_to_go_on(int signal) {
    if (isatty(STDERR_FILENO) == 1) [[maybe_unused]]
        const auto cleared = write(STDERR_FILENO, "\r\033[K", 4);
    [[maybe_unused]] const auto said = write(STDERR_FILENO, farewell, std::strlen(farewell));
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

/// A signal that the program was started to ignore stays ignored.
void replace_handler(void (*from)(int), void (*to)(int)) {
    for (const int signal : ending_signals)
        if (const auto before = std::signal(signal, to); before != from) std::signal(signal, before);
}

/// Opens the file and keeps it for this process. Sets `bytes` to its length.
int open_alone(const PartOptions& options, off_t& bytes) {
    struct stat status {};
    if (stat(options.file.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
        fail(options.file, S_ISDIR(status.st_mode) ? "a folder, a file is wanted" : "no file, which a part must be");
    const int descriptor = open(options.file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor < 0) fail_writing(options.file, errno);
    if (flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        close(descriptor);
        fail(options.file, "another process is writing it");
    }
    bytes = fstat(descriptor, &status) == 0 ? status.st_size : 0;
    return descriptor;
}

/// Throws InputError unless what is in the file may be gone on with.
Part resumed(const PartOptions& options, const SweepIdentity& sweep, const Shard& shard) {
    if (!options.resume) fail(options.file, "there already; --resume goes on with it, another --part begins anew");
    Part part = read_part(options.file);
    if (const auto what = difference(part.sweep, sweep)) fail(options.file, "of another sweep: " + *what);
    if (part.shard != shard) fail(options.file, "shard " + part.shard.text() + " of this sweep, not " + shard.text());
    return part;
}

}  // namespace

Shard checked_shard(const PartOptions& options, const SweepOutputs& outputs) {
    const Shard shard = shard_in("--shard", options.shard);
    std::vector<NamedFile> files = outputs.files();
    if (options.file.empty() && !options.shard.empty())
        throw InputError("--shard: give --part too, the file that keeps its points");
    if (options.file.empty() && options.resume) throw InputError("--resume: give --part too, the file to go on with");
    if (!shard.is_whole() && !files.empty())
        throw InputError(files.front().asked_by +
                         ": a shard has not all points; drapeau-lab merge takes it, for all shards");
    if (!options.file.empty()) files.push_back({"--part", options.file});
    check_outputs({{"the scene", outputs.scene_file.string()}}, files);
    check_plot("--plot", outputs.plot);
    return shard;
}

int say_shard_is_done(const Part& part) {
    const std::string text = "shard " + part.shard.text() + " is done: " + counted(part.points.size(), "point") +
                             " in " + one_line(part.file, 1000) + "; when all " + std::to_string(part.shard.count) +
                             " are, drapeau-lab merge joins them\n";
    std::fputs(text.c_str(), stdout);
    return exit_good;
}

PartFile::PartFile(const PartOptions& options, const SweepIdentity& sweep, const Shard& shard) {
    off_t bytes = 0;
    descriptor_ = open_alone(options, bytes);
    part_.file = options.file;
    const std::string header = header_line(sweep, shard);
    try {
        if (bytes > 0 && bytes < static_cast<off_t>(header.size()) &&
            header.starts_with(read_text_file(options.file, header.size()))) {
            bytes = 0;  // cut off in its first line
            if (ftruncate(descriptor_, 0) != 0) fail_writing(options.file, errno);
        }
        if (bytes == 0) {
            part_.sweep = sweep;
            part_.shard = shard;
            append(header);
        } else {
            part_ = resumed(options, sweep, shard);
            const auto whole = static_cast<off_t>(part_.whole_bytes);
            if (whole < bytes && ftruncate(descriptor_, whole) != 0) fail_writing(options.file, errno);
        }
    } catch (...) {
        close(descriptor_);
        throw;
    }
    const std::string text = std::string(program) + ": interrupted; what is done is in " +
                             one_line(options.file, 1000) + ", and the same command with --resume goes on\n";
    std::strncpy(farewell, text.c_str(), sizeof farewell - 1);
    replace_handler(SIG_DFL, say_how_to_go_on);
}

PartFile::~PartFile() {
    replace_handler(say_how_to_go_on, SIG_DFL);
    close(descriptor_);
}

void PartFile::append(const std::string& line) {
    const off_t before = lseek(descriptor_, 0, SEEK_END);
    const ssize_t count = write(descriptor_, line.data(), line.size());
    const int error = count < 0 ? errno : ENOSPC;
    if (count == static_cast<ssize_t>(line.size()) && fdatasync(descriptor_) == 0) return;
    // What does not fit whole is taken back.
    [[maybe_unused]] const int taken_back = ftruncate(descriptor_, before);
    fail_writing(part_.file, error);
}

// What is kept in memory is what a reader of the file gets: what is not finite is null there.
void PartFile::set_basis(const Json& basis) {
    const Json read = Json::parse(basis.dump());
    if (part_.basis.is_null()) append(basis_line(read));
    if (part_.basis.is_null()) part_.basis = read;
    if (part_.basis != read)
        fail(part_.file, "begun by another build or on another processor, where the reference came out otherwise");
}

void PartFile::add(const std::string& key, const Json& cost, const Json& result) {
    append(point_line(key, cost, result));
    PointRecord& point = part_.points[key];
    point.result = Json::parse(result.dump());
    if (!cost.is_null()) point.costs.push_back({Json::parse(cost.dump())});
}

void PartFile::add_cost(const std::string& key, const Json& cost) {
    append(point_line(key, cost));
    part_.points.at(key).costs.push_back({Json::parse(cost.dump())});
}

}  // namespace drapeau::lab
