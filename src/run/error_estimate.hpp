// Error estimate: how far a run strays from the exact motion of its model, in metres per second of simulated time.
//
// The last tenth of a second is run again from its beginning with steps dt, dt/2 and dt/4, which end at x1, x2, x4.
// With a method of order p the error is C dt^p + A dt^(p+1) + ..., so the root mean square of x1 - x2 over the masses
// that are free, times f = 2^p/(2^p - 1), is the error of x1 but for A's part. The third run tells whether that is
// right to a tenth. R = (x1 - x2) - 2^p (x2 - x4) is what does not shrink as the order says.
//
// - If R is A's part, the error of x1 is f (x1 - x2) - R 2^(p+1)/((2^p - 1) (2^(p+1) - 1)): insert the two terms. Its
//   size must be that of the estimate, to a tenth.
// - If R is noise (rounding, or chaos that has made of every difference the same), of size n in each of the three ends,
//   the estimate is the root of s^2 + 2 f^2 n^2 where the error is that of s^2 + n^2: a tenth too large where
//   n^2 = 0.21 s^2 / (2 f^2 - 1.21). R is then as large as n sqrt(1 + (1 + 2^p)^2 + 4^p), and x1 - x2 as large as
//   sqrt(s^2/f^2 + 2 n^2): the ratio of the two must stay below what follows, 1.2, 2.3 and 9 for p = 1, 2 and 4. (Were
//   there nothing but noise it would be 2.6, 4.6 and 17.)
//
// Otherwise the error is not resolvable, and a reason is given instead.
//
// In float a run in double from the same state tells what rounding does. Each step rounds a position by up to half a
// unit. Where a step changes velocities by enough to round to another side, that adds up to a walk, which grows as
// dt^-1/2; smaller steps round to the same side for a while, dt^-3/2, and in the end always, dt^-1. With C'/dt through
// the middle the sum C dt^p + C'/dt is least at dt (r / (p m))^(1/(p+1)), r and m being the errors of rounding and
// method at dt.
#pragma once

#include "run/engine.hpp"

#include <atomic>
#include <cmath>
#include <optional>
#include <string>

namespace drapeau {

/// What is run again: from a moment on, for a time.
struct ErrorWindow {
    static constexpr double usual = 0.1;  // s

    State<double> state;
    double time = 0.0;  // s, of that state
    double seconds = usual;
};

struct ErrorEstimate {
    enum class Verdict { unmeasured, resolved, coarse, chaos, rounding, limit, not_finite, no_memory };

    Verdict verdict = Verdict::unmeasured;
    double rate = NAN;         // m/s, root mean square over the masses that are free; NAN where it is not resolvable
    double apart = NAN;        // m/s, the same of x1 - x2 even where it is not
    double by_method = NAN;    // m/s, the error without rounding; of float's estimates that rounding hides too
    double by_rounding = 0.0;  // m/s, how far a run in float parts from one in double
    double dt = 0.0;           // s, of the step it holds for
    double seconds = 0.0;      // of the window
    int order = 0;             // of the method

    bool resolved() const { return verdict == Verdict::resolved; }
    /// In float, the step (s) at which the errors of method and rounding are least in sum; empty where either is
    /// unknown.
    std::optional<double> best_float_step() const;
    /// Why there is no number, in a few words and in a sentence; empty where there is one.
    std::string reason() const;
    std::string explanation() const;
};

/// The error of steps of dt (s). Once `abandon` is set it gives up soon, unmeasured. With `half_kick_start`
/// semi-implicit Euler is of order 2 where nothing damps.
ErrorEstimate measure_error(const Model& model, Method method, Precision precision, const ErrorWindow& window,
                            double dt, const std::atomic<bool>* abandon = nullptr, bool half_kick_start = false);

/// The order that a method declares.
int order_of(Method method);

}  // namespace drapeau
