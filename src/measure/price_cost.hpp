// Price cost: processor time of several scenes over the same stretch, as the programs run them, taking turns.
#pragma once

#include "measure/trade_measure.hpp"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace drapeau {

struct Cost {
    double ms_per_second = NAN;  // ms of processor time a simulated second, the least of the rounds; NAN where it fails
    double dt = NAN;             // s, the step at the end of the stretch
    std::string remark;          // how it diverged, or why the programs refuse it
};

/// A share of a scene's time, and within what the true one is with a probability of 95 %.
struct Share {
    double value = NAN;
    double known_to = NAN;  // at least 0.01: no smaller difference is looked for

    bool is_resolved() const { return std::abs(value) >= known_to; }
    bool is_saving() const { return value > known_to; }
};

/// "43.3 ± 1.1 %"; of what is smaller than it is known to the most that it may be, "< 2.4 %"; "-" where it is unknown.
std::string percent(const Share& share);

struct Costs {
    std::vector<Cost> of;                    // each scene
    std::vector<std::vector<double>> turns;  // ms of processor time a simulated second, of each in every round

    double first() const { return of.front().ms_per_second; }
    /// The share of the first scene's time that the second one named takes less than the first named: the median of
    /// what the rounds say, in each of which all scenes meet the same machine, as busy as it is.
    Share saved(std::size_t from, std::size_t to) const;
};

/// `seconds`: of time on the wall that the rounds may take; six are made at least.
Costs costs_of(const std::vector<Scene>& scenes, const Footing& ground, double seconds,
               const std::function<void()>& tick);

/// Runs the scene over the stretch once, for its step and whether it holds; it is not timed.
Cost as_run(const Scene& scene, const Footing& ground);

/// The scene at a given step (s).
Scene at_step(const Scene& scene, double dt);

}  // namespace drapeau
