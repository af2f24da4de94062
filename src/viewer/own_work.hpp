// OwnWork: the processor time that a frame costs the window itself: input, settings, what the picture is made from and
// panels. Not counted: the graphics driver, waiting, and the simulation, which has threads of its own.
#pragma once

#include "measure/clocks.hpp"

#include <algorithm>

namespace drapeau {

class OwnWork {
public:
    using Clock = double (*)();  // s

    explicit OwnWork(Clock clock = thread_seconds) : clock_(clock) {}

    void begin() { begun_ = clock_(); }
    /// Until the next begin, time is not counted.
    void pause() { spent_ += clock_() - begun_; }
    /// After the last pause of a frame. The first frame does not count: it makes what all others use.
    void end_frame() {
        constexpr double newest = 0.05;  // of the average: about the last 20 frames
        if (frames_ > 0) seconds_ += (spent_ - seconds_) * std::max(newest, 1.0 / double(frames_));
        ++frames_;
        spent_ = 0.0;
    }

    /// s a frame, averaged; 0 before the second has ended.
    double seconds() const { return seconds_; }

private:
    Clock clock_;
    double begun_ = 0.0, spent_ = 0.0, seconds_ = 0.0;  // s
    long long frames_ = 0;
};

}  // namespace drapeau
