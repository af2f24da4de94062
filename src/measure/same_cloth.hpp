// Same cloth: a scene's cloth on another grid, and its start there. What is inside it keeps its mass, drag and friction
// per area, and its stiffness; on ever finer grids that is one piece of cloth.
//
// With the report's own springs masses on borders are as heavy as those inside, and springs along borders as stiff: a
// hem half a cell wide that finer grids make narrower. Its weight is of the order of the distance between masses.
#pragma once

#include "drapeau/state.hpp"
#include "scene/scene.hpp"

namespace drapeau {

/// Throws InputError where it is impossible.
Scene same_cloth(const Scene& scene, int columns, int rows);

/// Its model; light borders have no hem.
Model model_with(const Scene& scene, Borders borders);

/// The state on a grid with so many times the cells (a power of two), as the smooth surface that natural cubic splines
/// lay through its masses: every finer grid begins on the same surface.
State<double> on_finer_grid(const State<double>& coarse, int times);

/// Sets held masses to where the scene has them, at rest.
void hold_fast(State<double>& state, const Model& model, double prestretch);

}  // namespace drapeau
