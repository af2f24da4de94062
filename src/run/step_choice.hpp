// Step choice: the step and the precision that a scene's time settings come to.
#pragma once

#include "scene/scene.hpp"

#include <string>

namespace drapeau {

/// The step a scene asks for, or a share of the largest that the closed bound allows, `lowered` further; a numeric one
/// as given if `exact`, else a whole number of them in a batch. Throws InputError where the method has no stable step,
/// or needs shorter ones than any machine could follow.
double chosen_step(const Scene& scene, const Model& model, bool exact, double lowered);

/// Throws InputError where an automatic step of dt (s) is shorter than a scene's step may be.
void check_automatic_step(Method method, double dt);

/// What the usual automatic step is as large as: "stiffness of the springs", "1/60 s".
std::string limit_of_step(Method method, const Model& model);

/// The precision a run begins in: the scene's, or double where float could not honour an automatic step. Throws
/// InputError where a given step leaves nothing of the motion in float.
Precision chosen_precision(const Scene& scene, const Model& model, double dt);

/// Throws InputError where steps of dt (s) leave nothing of a motion for which `honest` (s) is the smallest that float
/// honours; `given` (s) is the step as the scene says it.
void check_float_step(double dt, double honest, double given);

}  // namespace drapeau
