// Settle: a flag let hang until it rests, in gravity alone.
//
// Dynamic relaxation with kinetic damping (Barnes 1999): the masses move, and whenever their kinetic energy falls all
// of it is taken out. That takes some swings of the slowest kind, for which a coarse grid of the same weight and
// stiffness needs far fewer steps: each grid starts from what the next coarser one settled to.
#pragma once

#include "drapeau/state.hpp"
#include "scene/scene.hpp"

#include <atomic>

namespace drapeau {

/// How well a flag rests: let go, it moves no faster than this (m/s, root mean square) for a tenth of a second. Where
/// it swings with a period of 2 s that is a tenth of a millimetre from rest.
inline constexpr double still_speed = 1e-4;

/// Thrown where nobody waits for the flag any more.
struct SettlingAbandoned {};

struct Settled {
    State<double> state;  // at rest
    bool reached = true;  // the accuracy above, within the work allowed: one to three seconds of one core
    double speed = 0.0;   // m/s, root mean square, how fast it still was
};

/// `start` is where it is let go. Throws SettlingAbandoned within a few hundredths of a second after `abandon` is set.
Settled settle(const Scene& scene, const State<double>& start, const std::atomic<bool>* abandon = nullptr);

}  // namespace drapeau
