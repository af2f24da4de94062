// Start state: the masses of a scene at time zero, and those of a running flag carried over to another grid.
#pragma once

#include "run/engine.hpp"

namespace drapeau {

/// Flat, hanging (settled without wind) or crumpled, as the scene says; at rest.
State<double> start_state(const Scene& scene);

/// The masses of `old` seen on the scene's grid, by interpolation in the flag's own coordinates. Held masses stand
/// exactly where the start state has them.
State<double> carried_over(const State<double>& old, const Scene& scene);

}  // namespace drapeau
