// Start state: the masses of a scene at time zero, and those of a running flag carried over to another grid.
#pragma once

#include "engine.hpp"

namespace drapeau {

/// Flat, hanging (settled without wind) or crumpled, as the scene says; at rest.
Masses start_masses(const Scene& scene);

/// The masses of `old` (on old_grid) seen on the scene's grid, by interpolation in the flag's own coordinates.
/// Attached masses stand exactly where the start state has them.
Masses carried_over(const Masses& old, const Grid& old_grid, const Scene& scene);

}  // namespace drapeau
