// Progress line: how far a film is, on a terminal; into a file or a pipe nothing is written.
#pragma once

#include "film_plan.hpp"

#include <chrono>
#include <string>

namespace drapeau {

/// "flag.mp4: 120 of 480 frames, 25 %, 12 s left"; `seconds` have passed.
std::string progress_text(const FilmPlan& plan, long long written, double seconds);

class ProgressLine {
public:
    explicit ProgressLine(const FilmPlan& plan);

    void show(long long written);
    void end();  // the line stays, what follows begins on one of its own

private:
    FilmPlan plan_;
    bool shown_;
    long long written_ = -1;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace drapeau
