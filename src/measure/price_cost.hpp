// Price cost: processor time of several scenes over the same stretch, as the programs run them, taking turns.
#pragma once

#include "measure/trade_measure.hpp"

#include <functional>
#include <string>
#include <vector>

namespace drapeau {

struct Cost {
    double ms_per_second = NAN;  // ms of processor time a simulated second, the least of the rounds; NAN where it fails
    double dt = NAN;             // s, the step at the end of the stretch
    std::string remark;          // how it diverged, or why the programs refuse it
};

struct Costs {
    std::vector<Cost> of;      // each scene
    double resolution = 0.01;  // share of the first: no smaller difference counts

    double first() const { return of.front().ms_per_second; }
    /// The share of the first's time that the second scene named takes less than the first named.
    double saved(std::size_t from, std::size_t to) const {
        return (of[from].ms_per_second - of[to].ms_per_second) / first();
    }
};

/// `seconds`: of time on the wall that the rounds may take; four are made at least.
Costs costs_of(const std::vector<Scene>& scenes, const Ground& ground, double seconds,
               const std::function<void()>& tick);

/// The step (s) that a scene takes at the end of the stretch.
double step_of(const Scene& scene, const Ground& ground);

/// The scene at a given step (s).
Scene at_step(const Scene& scene, double dt);

}  // namespace drapeau
