// Carry over: the masses of a running flag seen on another grid.
#pragma once

#include "drapeau/state.hpp"
#include "scene/scene.hpp"

namespace drapeau {

/// The masses of `old` seen on the scene's grid, by interpolation in the flag's own coordinates. Held masses stand
/// exactly where the start state has them.
State<double> carried_over(const State<double>& old, const Scene& scene);

}  // namespace drapeau
