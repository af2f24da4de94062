#include "child.hpp"

#include "io/error.hpp"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace drapeau::bench {
namespace {

constexpr int results_descriptor = 3;  // child_results

void check(int error, const std::string& what) {
    if (error != 0) throw InputError(what + ": " + std::strerror(error));
}

/// A pipe's two ends; closed when no longer held.
struct Pipe {
    int from = -1, to = -1;

    Pipe() {
        int ends[2];
        check(pipe2(ends, O_CLOEXEC) == 0 ? 0 : errno, "no pipe to another program");
        from = ends[0], to = ends[1];
    }
    Pipe(const Pipe&) = delete;
    ~Pipe() {
        close(from);
        close_input();
    }
    void close_input() {
        if (to >= 0) close(to);
        to = -1;
    }
};

struct FileActions {
    posix_spawn_file_actions_t actions;

    FileActions() { check(posix_spawn_file_actions_init(&actions), "no room to start another program"); }
    FileActions(const FileActions&) = delete;
    ~FileActions() { posix_spawn_file_actions_destroy(&actions); }
    void drop(int descriptor) {
        posix_spawn_file_actions_addopen(&actions, descriptor, "/dev/null", descriptor == 0 ? O_RDONLY : O_WRONLY, 0);
    }
    void redirect(int from, int to) { posix_spawn_file_actions_adddup2(&actions, from, to); }
};

std::string everything_from(int descriptor) {
    std::string all;
    char block[4096];
    for (;;) {
        const ssize_t count = read(descriptor, block, sizeof block);
        if (count > 0) all.append(block, static_cast<std::size_t>(count));
        if (count == 0) return all;
        if (count < 0 && errno != EINTR) return all;
    }
}

std::string ending_of(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return "was lost";
    if (WIFSIGNALED(status)) return std::string("was ended by a signal: ") + strsignal(WTERMSIG(status));
    if (WEXITSTATUS(status) != 0) return "ended with status " + std::to_string(WEXITSTATUS(status));
    return {};
}

}  // namespace

ChildRun run_child(const std::string& program, std::vector<std::string> arguments, Outlet outlet) {
    // Every child gets the same name: the length of its path would move its stack, and with it its speed.
    std::string name = "drapeau-bench";
    std::vector<char*> pointers{name.data()};
    for (auto& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);

    Pipe pipe;
    FileActions files;
    files.drop(STDIN_FILENO);
    if (outlet == Outlet::standard_output) {
        files.redirect(pipe.to, STDOUT_FILENO);
        files.drop(STDERR_FILENO);
    } else {
        files.drop(STDOUT_FILENO);
        files.redirect(pipe.to, results_descriptor);
    }
    pid_t child = 0;
    check(posix_spawn(&child, program.c_str(), &files.actions, nullptr, pointers.data(), environ),
          program + " cannot be run");
    pipe.close_input();
    ChildRun run;
    run.output = everything_from(pipe.from);
    run.ending = ending_of(child);
    return run;
}

}  // namespace drapeau::bench
