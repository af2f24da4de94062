#include "io/terminal.hpp"

#include "io/text.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

namespace drapeau {

void complain(std::string_view program, std::string_view text) {
    const std::string line = std::string(program) + ": " + printable(text) + "\n";
    std::fputs(line.c_str(), stderr);
}

int finish_output(std::string_view program, int status) {
    constexpr int not_written = 2;
    if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return status;
    complain(program, std::string("standard output cannot be written: ") + std::strerror(errno));
    return not_written;
}

}  // namespace drapeau
