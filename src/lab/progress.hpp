// How far a command is and how long it still takes: a bar on a terminal; in a pipe or a file a plain line now and then.
#pragma once

#include <chrono>
#include <string>

namespace drapeau::lab {

/// "40 s", "12 min" or "5 h".
std::string duration(double seconds);

class Progress {
public:
    Progress();
    ~Progress();  // clears the bar
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// `share` of the work is done, from 0 to 1. Draws at most ten times a second; says a line every half minute.
    void show(double share);

private:
    using Clock = std::chrono::steady_clock;
    bool on_terminal_;
    bool drawn_ = false;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
};

}  // namespace drapeau::lab
