// Pace: how long flights take on this machine, and what of them is worth keeping.
#pragma once

#include "scene/scene.hpp"

#include <string>

namespace drapeau::lab {

/// What one unit of step_cost takes here and now (s on the wall), in double, with rk4.
double measured_unit(const Model& model);

/// A sample every so many batches: more would take memory and tell no more.
long long sampling(const Grid& grid, long long batches);

bool has_free_masses(const Model& model);

/// The scene as its reference is flown: in double, by rk4, at its automatic step.
Scene as_reference(Scene scene);

/// "about 40 s" or "about 12 min", without the "about".
std::string duration(double seconds);

}  // namespace drapeau::lab
