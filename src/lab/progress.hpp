// A progress bar on a terminal; nothing in a pipe or a file.
#pragma once

#include <chrono>

namespace drapeau::lab {

class Progress {
public:
    Progress();
    ~Progress();  // clears the bar
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// `share` of the work is done, from 0 to 1. Draws at most ten times a second.
    void show(double share);

private:
    using Clock = std::chrono::steady_clock;
    bool on_terminal_;
    bool drawn_ = false;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
};

}  // namespace drapeau::lab
