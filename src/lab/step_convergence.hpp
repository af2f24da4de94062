// Step convergence: what halving the step does to a motion, method by method: the order that successive halvings show,
// and where they show none, what prevents it.
#pragma once

#include "measure/reference_flight.hpp"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace drapeau::lab {

/// A run among others at twice and half its step.
struct StepRung {
    enum class Flag { first, asymptotic, pre_asymptotic, chaos, limit, rounding, diverged };

    long long steps_a_batch = 1;
    double difference = NAN;  // m, root mean square over masses and time, from the run at twice the step
    double error = NAN;       // m, likewise, from the reference
    double order = NAN;       // log2 of the ratio of this difference and the one before (Richardson)
    double alignment = NAN;   // cosine between that difference and the one before: 1 where errors shrink in proportion
    Flag flag = Flag::first;
    bool is_below_resolution = false;  // nearer to the reference than ten times what that is known to

    double dt() const;  // s
};

struct MethodConvergence {
    Method method{};
    int declared = 0;             // order
    std::vector<StepRung> rungs;  // the largest step first
    std::string left_out;         // why there are no rungs, or no finer ones; "" if none are wanted

    /// The finest rung whose order is not rounding's; nothing if there is none.
    const StepRung* best() const;
    bool is_asymptotic() const { return best() && best()->flag == StepRung::Flag::asymptotic; }
};

/// What the runs of all methods have in common.
struct StepGround {
    const Model& model;
    const Stretch& stretch;
    Yardstick& yardstick;
    const ReferenceFlight& reference;
    const Growth& growth;
    double unit = 0.0;             // s, of step_cost: as measured, or as work is counted
    bool counts_work = false;      // instead of time
    std::function<void()> tick{};  // called after every batch
};

/// Halves the step of the method, from its automatic one on, until two orders in a row are the declared one, halving
/// shows nothing but rounding, or `seconds` (on the wall, or of counted work) are over.
MethodConvergence converge_in_step(Method method, const StepGround& ground, double seconds);

/// What three runs at the method's largest steps take, about (s).
double least_seconds(Method method, const StepGround& ground);

}  // namespace drapeau::lab
