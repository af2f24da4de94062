// Tolerance step: the largest step that a tolerance allows, from estimates of the error one after another.
//
//   dt_a = dt clip(0.9 (tolerance/error)^(1/p), 1/2, 2)
//
// A wind that changes must not make the step follow every gust: it shrinks when two estimates in a row are above the
// tolerance, or one is more than twice the tolerance, and grows when four in a row would do with fewer than 1/1.2 of
// the steps. The 0.9 and the 1.2 leave at most a quarter of the steps more than the tolerance needs. Where the error is
// not resolvable the step stays, unless it is too coarse for its order to show: then only a smaller one can tell.
#pragma once

#include "run/error_estimate.hpp"

#include <cmath>

namespace drapeau {

class ToleranceStep {
public:
    /// The largest step (s) that the tolerance allows as far as is known; infinite until an estimate says otherwise.
    double allowed() const { return allowed_; }

    /// Takes in an estimate; `usual` is the step (s) that stability alone allows. Whether allowed() has changed.
    bool take_in(const ErrorEstimate& estimate, double tolerance, double usual);

    /// At a start, where one estimate must do: lowers the step as far as it says. Whether it did.
    bool lower_at_once(const ErrorEstimate& estimate, double tolerance);

private:
    double allowed_ = INFINITY;
    int shrinking_ = 0, growing_ = 0;  // estimates in a row
    double least_ = INFINITY;          // s, that one of them asked for
};

/// Whether float's own rounding moves masses by more than the tolerance (m/s).
bool needs_double(const ErrorEstimate& estimate, double tolerance);

}  // namespace drapeau
