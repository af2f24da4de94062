// Comparison request: what every comparison of a scene's motions is asked: from where, over which time, how finely, and
// what it may take.
#pragma once

#include "scene/scene.hpp"

#include <functional>
#include <optional>

namespace drapeau {

struct ComparisonRequest {
    Scene scene;
    double settle = 2.0;  // s that the scene swings in before
    // Of 1/60 s, that are compared. Unless they were asked for: fewer where the motion is chaotic, so that errors of
    // steps grow no more than a thousandfold.
    long long batches = 30;
    bool batches_are_given = false;
    double budget = 120.0;            // s of time on the wall
    std::optional<double> tolerance;  // m
    // The budget is of work, counted at a fixed rate instead of timed: what is measured is the same wherever and
    // however often it is done.
    bool counts_work = false;
};

/// Is told the share of the work that is done.
using Tick = std::function<void(double)>;

/// s that a unit of step_cost counts for where work is counted.
inline constexpr double counted_unit = 4e-9;

}  // namespace drapeau
