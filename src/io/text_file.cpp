#include "io/text_file.hpp"

#include "io/error.hpp"
#include "io/text.hpp"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace drapeau {

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

}  // namespace

std::string read_text_file(const std::string& name, std::size_t max_bytes) {
    const Descriptor file(open(name.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (file.number < 0) fail(name, std::strerror(errno));

    std::string bytes;
    std::string block(1 << 16, '\0');
    constexpr int patience = 5000;  // ms
    while (bytes.size() <= max_bytes) {
        pollfd waiting{file.number, POLLIN, 0};
        if (poll(&waiting, 1, patience) == 0) fail(name, "nothing to read for 5 s");
        const ssize_t count = read(file.number, block.data(), block.size());
        if (count == 0) return bytes;
        if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (count < 0) fail(name, std::strerror(errno));
        bytes.append(block, 0, static_cast<std::size_t>(count));
    }
    fail(name, "more than " + memory_text(static_cast<double>(max_bytes)) + " long");
}

}  // namespace drapeau
