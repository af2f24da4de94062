// Slow motion: pictures between two moments of the run, on straight lines, for time that passes more slowly than the
// run's own steps could show.
#pragma once

#include "run/simulation.hpp"

#include <deque>

namespace drapeau {

/// Every mass at a share of its way from one snapshot to the next; to the next where their grids differ.
void interpolate(const Snapshot& from, const Snapshot& to, double share, Snapshot& into);

class SlowMotion {
public:
    void add(const Snapshot& newest);
    void forget() { waiting_.clear(); }
    bool empty() const { return waiting_.empty(); }

    /// Lets so much simulated time (s) pass, as far as snapshots reach.
    void pass(double seconds);
    /// Whether less than `part` (s) is left to show.
    bool wants(double part) const { return empty() || waiting_.back().time - time_ < part; }
    void show(Snapshot& into) const;  // of now; not where it is empty

private:
    std::deque<Snapshot> waiting_;  // the first is now or earlier
    double time_ = 0.0;             // s
};

}  // namespace drapeau
