// Real-time pacer: how many batches a frame asks for so that simulated time follows the wall clock, and how well it
// does. When the simulation cannot keep up, what could not be asked for is not caught up later: the flag slows down,
// and the real-time factor says by how much.
#pragma once

#include <deque>

namespace drapeau {

class Pacer {
public:
    /// Batches to ask for after `seconds`, with `backlog` batches not done yet. `speed`: simulated seconds in a second
    /// of wall-clock, of which a faster one has more under way.
    int batches(double seconds, int backlog, double speed = 1.0);

    /// Called once a frame with the wall clock and the simulated time, both in s.
    void observe(double wall, double simulated);

    /// Simulated seconds per second over the last second; 0 until known.
    double real_time_factor() const { return factor_; }
    double frame_seconds() const { return frame_; }  // averaged likewise

    void forget();  // after a pause or a new run

private:
    struct Sample {
        double wall, simulated;
    };
    double owed_ = 0.0;  // s of wall-clock not yet asked for
    double factor_ = 0.0, frame_ = 0.0;
    std::deque<Sample> samples_;
};

}  // namespace drapeau
