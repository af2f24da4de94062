// Batch track: where the masses of a run are at any time, not only at the ends of its batches.
//
// Films are not bound to batches of 1/60 s: at 24 frames/s a frame lies between two of them. Rounding to a batch would
// make the motion stutter, rounding to a step too where steps are long. Between two ends t0 and t1 = t0 + h, places
// follow the cubic with the places and velocities of both (Hermite):
//
//   x(t0 + s h) = (2 s^3 - 3 s^2 + 1) x0 + (s^3 - 2 s^2 + s) h v0 + (3 s^2 - 2 s^3) x1 + (s^3 - s^2) h v1
//
// off by at most h^4/384 |x''''|: 0.3 % of the amplitude of a motion at 10 Hz. At the end of a batch it is the run's
// own snapshot.
#pragma once

#include "run/simulation.hpp"

#include <atomic>
#include <optional>

namespace drapeau {

/// Both ends at their times; the result is at `time` between them (s).
void between(const State<double>& before, double t0, const State<double>& after, double t1, double time,
             FieldBuffer<float>& into);

/// Velocities (m/s) mixed linearly, into a field of as many masses.
void velocity_between(const State<double>& before, double t0, const State<double>& after, double t1, double time,
                      FieldBuffer<float>& into);

class BatchTrack {
public:
    /// The run, from where it is.
    explicit BatchTrack(Simulation& run);

    /// Goes on until `time` (s, of the run) and gives the masses there; times never go back by more than a batch. Stops
    /// early, with what diverged, if the run diverges; with nothing that is of use if `abandon` is set meanwhile.
    std::optional<Divergence> follow(double time, Snapshot& into, const std::atomic<bool>& abandon);

private:
    Simulation& run_;
    std::optional<State<double>> before_, after_;  // the ends of the newest batch, where they were asked for
    double before_time_ = 0.0, after_time_ = 0.0;  // s
};

}  // namespace drapeau
