// Timing: subjects in turns, so that a noisy machine is noisy for all of them, each from its start state every time.
#pragma once

#include "subject.hpp"

#include <span>
#include <vector>

namespace drapeau::bench {

struct Contender {
    Subject* subject;
    int at_least;  // times the work is done in one repeat, at least
};

/// Seconds for doing the work once.
struct Timing {
    double min = 0.0, median = 0.0;
    std::vector<double> turns;  // as they were taken: turn n of one contender stands beside turn n of another
};

/// Warms every contender up, then repeats them in turns for `budget` seconds each and five times at least.
std::vector<Timing> time_in_turns(std::span<const Contender> contenders, double budget);

}  // namespace drapeau::bench
