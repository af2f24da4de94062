// Work clock: what a search has spent: time on the wall, or work counted at a fixed rate, which is the same on any
// machine however busy it is.
#pragma once

#include "measure/clocks.hpp"

namespace drapeau {

class WorkClock {
public:
    /// `unit`: s that a unit of step_cost counts for; 0: time on the wall counts.
    explicit WorkClock(double unit) : unit_(unit) {}

    /// s since the clock was made.
    double spent() const { return unit_ > 0.0 ? counted_ : wall_seconds() - began_; }
    /// So many units of step_cost were worked off.
    void count(double units) { counted_ += unit_ * units; }

private:
    double unit_, counted_ = 0.0;
    double began_ = wall_seconds();
};

}  // namespace drapeau
