#include "run/tolerance_step.hpp"

#include "drapeau/stability.hpp"

#include <algorithm>

namespace drapeau {
namespace {

constexpr int to_shrink = 2, to_grow = 4;       // estimates in a row
constexpr double safety = 0.9, worth_it = 1.2;  // of the step; of the number of steps
constexpr double least_factor = 0.5, most_factor = 2.0;
constexpr double far_above = 2.0;  // of the tolerance

bool is_above(const ErrorEstimate& estimate, double rate) {
    if (estimate.verdict == ErrorEstimate::Verdict::coarse) return estimate.apart > rate;
    return estimate.resolved() && estimate.rate > rate;
}

/// By how much the step may be larger for the error to be the tolerance.
double factor(const ErrorEstimate& estimate, double tolerance) {
    return safety * std::pow(tolerance / estimate.apart, 1.0 / estimate.order);  // infinite without an error
}

double steps_a_batch(double dt) {
    return std::round(batch_seconds / whole_steps_per_batch(dt));
}

}  // namespace

bool ToleranceStep::take_in(const ErrorEstimate& estimate, double tolerance, double usual) {
    const bool above = is_above(estimate, tolerance);
    double wanted = estimate.dt;
    if (above || estimate.resolved()) {
        const double by = estimate.resolved() ? factor(estimate, tolerance) : least_factor;
        wanted = std::min(usual, estimate.dt * std::clamp(by, least_factor, most_factor));
    }
    const double steps = steps_a_batch(estimate.dt), needed = steps_a_batch(wanted);
    const bool shrinks = above && needed > steps, grows = !above && needed * worth_it < steps;
    if ((shrinks && shrinking_ == 0) || (grows && growing_ == 0)) least_ = INFINITY;
    const bool is_far = estimate.resolved() && is_above(estimate, far_above * tolerance);
    shrinking_ = shrinks ? shrinking_ + (is_far ? to_shrink : 1) : 0;
    growing_ = grows ? growing_ + 1 : 0;
    least_ = std::min(least_, wanted);
    if (shrinking_ < to_shrink && growing_ < to_grow) return false;
    shrinking_ = growing_ = 0;
    allowed_ = least_;
    return true;
}

bool ToleranceStep::lower_at_once(const ErrorEstimate& estimate, double tolerance) {
    if (!is_above(estimate, tolerance)) return false;
    constexpr double least_at_once = 1.0 / 16.0;
    const double by = estimate.resolved() ? std::max(least_at_once, factor(estimate, tolerance)) : least_factor;
    allowed_ = by * estimate.dt;
    return true;
}

bool needs_double(const ErrorEstimate& estimate, double tolerance) {
    return estimate.verdict == ErrorEstimate::Verdict::rounding && estimate.by_rounding > tolerance;
}

}  // namespace drapeau
