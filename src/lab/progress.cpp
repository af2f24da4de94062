#include "progress.hpp"

#include "io/text.hpp"

#include <cstdio>
#include <string>

#include <unistd.h>

namespace drapeau::lab {

std::string duration(double seconds) {
    constexpr double few_minutes = 100.0, few_hours = 6000.0;
    if (seconds < few_minutes) return rounded(seconds, 2) + " s";
    return seconds < few_hours ? rounded(seconds / 60.0, 2) + " min" : rounded(seconds / 3600.0, 2) + " h";
}

Progress::Progress() : on_terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (drawn_) std::fputs("\r\033[K", stderr);
}

void Progress::show(double share) {
    const auto now = Clock::now();
    const auto pause = on_terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(30000);
    if (now - last_ < pause) return;
    last_ = now;

    const double passed = std::chrono::duration<double>(now - start_).count();
    std::string text = std::to_string(static_cast<int>(share * 100.0)) + " %";
    if (share > 0.0) text += ", " + duration(passed * (1.0 - share) / share) + " left";
    if (on_terminal_) {
        constexpr int width = 40;
        const int done = static_cast<int>(share * width);
        drawn_ = true;
        text = "\r[" + std::string(done, '#') + std::string(width - done, '.') + "] " + text + "\033[K";
    } else {
        text = "drapeau-lab: " + text + "\n";
    }
    std::fputs(text.c_str(), stderr);
    std::fflush(stderr);
}

}  // namespace drapeau::lab
