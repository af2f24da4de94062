// Peers: other programs' cloth flying the same flag, where their libraries were found when this was built.
//
// All fly the flag of scene_of from flat for two seconds of simulated time, in frames of 1/60 s. What is compared is
// the time a frame takes at equal greatest stretch: a solver that stops early is fast and lets the cloth grow long.
#pragma once

#include "cases.hpp"

namespace drapeau::bench {

inline constexpr int frames_flown = 120, frames_watched = 60;  // the last second is timed and measured

struct Flight {
    double ms_a_frame = 0.0;        // the shortest of the frames watched
    double greatest_stretch = 0.0;  // share, the greatest in the frames watched
};

/// Bullet's soft body: the flag's masses joined by its links, gravity, and drag towards the wind on every mass.
Flight fly_bullet(const Scene& scene, int substeps, int iterations);

/// Prints the comparison. Throws InputError if no peer was compiled in.
void run_peers();

}  // namespace drapeau::bench
