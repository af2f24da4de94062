#include "progress.hpp"

#include "io/text.hpp"

#include <cstdio>
#include <string>

#include <unistd.h>

namespace drapeau::lab {

Progress::Progress() : on_terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (drawn_) std::fputs("\r\033[K", stderr);
}

void Progress::show(double share) {
    const auto now = Clock::now();
    if (!on_terminal_ || now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    drawn_ = true;

    constexpr int width = 40;
    const int done = static_cast<int>(share * width);
    const double passed = std::chrono::duration<double>(now - start_).count();
    std::string bar = "\r[" + std::string(done, '#') + std::string(width - done, '.') + "] ";
    bar += std::to_string(static_cast<int>(share * 100.0)) + " %";
    if (share > 0.0) bar += ", " + rounded(passed * (1.0 - share) / share, 2) + " s left";
    std::fputs((bar + "\033[K").c_str(), stderr);
    std::fflush(stderr);
}

}  // namespace drapeau::lab
