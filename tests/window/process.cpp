#include "process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace drapeau::window_tests {

namespace {

constexpr int could_not_start = 127;

void send_to_file(int stream, const std::filesystem::path& file) {
    const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (descriptor < 0) _exit(could_not_start);
    dup2(descriptor, stream);
    close(descriptor);
}

}  // namespace

Process::Process(const std::vector<std::string>& command, const Surroundings& surroundings,
                 std::filesystem::path logs) {
    const std::string name = std::filesystem::path(command.front()).filename().string();
    output_file_ = logs / (name + ".out");
    error_file_ = logs / (name + ".err");

    std::vector<char*> arguments;
    for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);

    id_ = fork();
    if (id_ < 0) throw std::runtime_error("could not start " + name);
    if (id_ == 0) {
        for (const auto& [variable, value] : surroundings.variables) {
            if (value) {
                setenv(variable.c_str(), value->c_str(), 1);
            } else {
                unsetenv(variable.c_str());
            }
        }
        send_to_file(STDOUT_FILENO, output_file_);
        send_to_file(STDERR_FILENO, error_file_);
        if (!surroundings.folder.empty() && chdir(surroundings.folder.c_str()) != 0) _exit(could_not_start);
        execvp(arguments.front(), arguments.data());
        _exit(could_not_start);
    }
}

Process::~Process() {
    if (!running()) return;
    stop();
    if (!wait(Seconds(5.0))) {
        kill(id_, SIGKILL);
        wait();
    }
}

bool Process::running() {
    return !wait(Seconds(0.0));
}

void Process::stop() {
    if (!status_) kill(id_, SIGTERM);
}

std::optional<int> Process::wait(Seconds limit) {
    const auto deadline = std::chrono::steady_clock::now() + limit;
    while (!status_) {
        int status = 0;
        if (waitpid(id_, &status, WNOHANG) == id_) {
            status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        } else if (std::chrono::steady_clock::now() >= deadline) {
            return std::nullopt;
        } else {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    }
    return status_;
}

std::string Process::output() const {
    return read_text(output_file_);
}
std::string Process::errors() const {
    return read_text(error_file_);
}

Finished run(const std::vector<std::string>& command, const Surroundings& surroundings, Seconds limit) {
    const TemporaryFolder logs;
    Process process(command, surroundings, logs.path);
    const std::optional<int> status = process.wait(limit);
    if (!status) throw std::runtime_error(command.front() + " did not end in time:\n" + process.errors());
    return {*status, process.output(), process.errors()};
}

std::string read_text(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void write_text(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

}  // namespace drapeau::window_tests
