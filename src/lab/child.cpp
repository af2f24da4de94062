#include "child.hpp"

#include "io/error.hpp"

#include <cerrno>
#include <cstring>

#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace drapeau::lab {

namespace {

/// A file that is only in memory.
class MemoryFile {
public:
    MemoryFile(const std::string& what, std::string_view text) : descriptor_(memfd_create("child", MFD_CLOEXEC)) {
        while (descriptor_ >= 0 && !text.empty()) {
            const ssize_t count = write(descriptor_, text.data(), text.size());
            if (count < 0 && errno != EINTR) break;
            if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
        }
        if (descriptor_ < 0 || !text.empty()) throw InputError(what + ": not enough memory for another program");
        lseek(descriptor_, 0, SEEK_SET);
    }
    ~MemoryFile() { close(descriptor_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    int descriptor() const { return descriptor_; }
    std::string text() const {
        struct stat status {};
        if (fstat(descriptor_, &status) != 0) return "";
        std::string all(static_cast<std::size_t>(status.st_size), '\0');
        const ssize_t count = pread(descriptor_, all.data(), all.size(), 0);
        all.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
        return all;
    }

private:
    int descriptor_;
};

}  // namespace

Said run_child(const std::string& what, std::vector<std::string> words, std::string_view input) {
    const MemoryFile given(what, input), output(what, ""), complaints(what, "");
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, given.descriptor(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output.descriptor(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, complaints.descriptor(), STDERR_FILENO);
    pid_t child = -1;
    const int failure = posix_spawnp(&child, words.front().c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failure != 0)
        throw InputError(what + " needs " + words.front() + ", which could not be started: " + std::strerror(failure));
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, output.text(), complaints.text()};
}

}  // namespace drapeau::lab
