// Swing in: how a comparison of motions begins: the scene moves for a while, and from where it is then a stretch of
// time is compared that is no longer than its motion can be foretold.
#pragma once

#include "measure/flight.hpp"

#include <functional>
#include <optional>
#include <string>

namespace drapeau {

/// The scene as its reference is flown: in double, by rk4, at its automatic step.
Scene as_reference(Scene scene);

/// Where a scene is after so many seconds.
struct SwungIn {
    State<double> state{1, 1};
    double time = 0.0;                    // s
    std::optional<std::string> diverged;  // why it did not get there
};
SwungIn swing_in(const Scene& scene, double seconds, const std::function<void()>& tick);

/// Batches that are compared of a motion with that horizon (s): half of it, so that what is apart grows by half as many
/// powers of ten.
long long trusted_batches(double horizon);

/// A sample of a flight is taken every so many batches: more would take memory and tell no more.
long long sampling(const Grid& grid, long long batches);

/// m, root mean square: in double rounding leaves no more of a position.
double finest_goal(const Model& model);

/// Throws InputError where no mass is free.
void check_that_it_moves(const Model& model);

/// What one unit of step_cost takes here and now (s on the wall), in double, with rk4.
double measured_unit(const Model& model);

}  // namespace drapeau
