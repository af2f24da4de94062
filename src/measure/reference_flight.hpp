// Reference flight: a stretch flown so finely that what other runs differ from it by is their own error. By two methods
// that share no formula: rk4, and leapfrog with its errors of order 2 and 3 extrapolated away, both in double. A method
// is never judged by itself: rk4 is judged by leapfrog, every other by rk4.
#pragma once

#include "measure/flight.hpp"

#include <functional>
#include <string>

namespace drapeau {

struct ReferenceFlight {
    Flight by_rk4, by_leapfrog;
    long long rk4_steps = 0, leapfrog_steps = 0;  // a batch, of the finest flight of each
    // m, root mean square: the errors of each as its own halvings tell them, and how far the two are apart.
    double rk4_error = 0.0, leapfrog_error = 0.0, methods_apart = 0.0;

    /// m, root mean square: how well the motion is known. What the methods are apart is the error of both, unless they
    /// share it.
    double error() const;
    const Flight& judge_of(Method method) const;
};

/// The error (m) of the finer of two flights that are `now` apart, the two before having been `before` apart: what the
/// same shrinking leaves at ever smaller steps.
double error_left(double before, double now, int order);

/// How fast neighbouring motions part: two flights that begin a nanometre apart.
struct Growth {
    static constexpr double first = 1e-9;  // m, root mean square

    double last = first;  // m, at the stretch's end
    double rate = 0.0;    // 1/s, fitted; 0 where they did not grow a hundredfold in the stretch

    bool is_seen() const { return rate > 0.0; }
    /// The time (s) until they are this far apart (m); infinite where no growth was seen.
    double horizon(double distance) const;
    /// What a push is multiplied by in so many seconds, no more than were looked at; at least 1.
    double amplification(double seconds) const;
};

/// The start with every free mass moved a little (m), in directions that are always the same.
State<double> pushed_aside(const Model& model, State<double> state, double distance);

/// The growth that two flights tell which began Growth::first apart. `model`: of the masses whose positions they kept.
Growth growth_of(const Model& model, const Stretch& stretch, const Flight& one, const Flight& other);

/// What a search may take.
struct ReferenceLimits {
    double goal = 0.0;             // m: no better is asked for
    double seconds = 0.0;          // of time on the wall, about
    std::function<void()> tick{};  // called now and then
    double unit = 0.0;             // s that a unit of step_cost counts for, instead of time on the wall; 0: that counts
};

/// Throws InputError if rk4 does not hold at any step that there is time for.
Growth find_growth(const Model& model, const Stretch& stretch, Yardstick& yardstick, const ReferenceLimits& limits);

/// Halves the steps of both methods until they reach the goal, halving no longer helps, or time is up. Throws
/// InputError as above.
ReferenceFlight find_reference(const Model& model, const Stretch& stretch, Yardstick& yardstick,
                               const ReferenceLimits& limits);

}  // namespace drapeau
