// Playback: how fast simulated time passes in the window, and which moment of the flight is looked at, as plain data.
#pragma once

#include "timeline.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace drapeau {

/// A speed of the ladder: simulated seconds in a second of the clock.
struct Speed {
    double factor;
    const char* name;
};
inline constexpr std::array speeds{Speed{0.01, "1/100"}, Speed{0.02, "1/50"}, Speed{0.05, "1/20"},
                                   Speed{0.1, "1/10"},   Speed{0.25, "1/4"},  Speed{0.5, "1/2"},
                                   Speed{1.0, "1"},      Speed{2.0, "2"},     Speed{4.0, "4"}};
inline constexpr int real_time = 6;  // of them

struct Playback {
    int rung = real_time;         // of the ladder
    bool backwards = false;       // what is kept passes backwards; the run is paused
    std::optional<double> shown;  // s, a kept moment that is looked at; none: the newest there is
    bool plots = false;           // open

    // What there is to look at.
    double from = 0.0, to = 0.0;  // s
    std::size_t moments = 0, bytes = 0;
    std::vector<Sample> samples;  // to be plotted, while plots are open

    const Speed& speed() const { return speeds[std::size_t(rung)]; }
    void faster(int rungs) { rung = std::clamp(rung + rungs, 0, int(speeds.size()) - 1); }
};

/// What panels and keys ask of time in a frame, all presses together.
struct Travel {
    int frames = 0, seconds = 0;  // of simulated time; negative: back
    bool backwards = false;       // begin to play backwards, or end it
    std::optional<double> to;     // s, the moment to look at
};

}  // namespace drapeau
