// Step choice: the step and the precision that a scene's time settings come to.
#pragma once

#include "scene/scene.hpp"

namespace drapeau {

/// The step a scene asks for, or a share of the largest that the closed bound allows, `lowered` further; a numeric one
/// as given if `exact`, else a whole number of them in a batch. Throws InputError where the method has no stable step.
double chosen_step(const Scene& scene, const Model& model, bool exact, double lowered);

/// The precision a run begins in: the scene's, or double where float could not honour an automatic step. Throws
/// InputError where a given step leaves nothing of the motion in float.
Precision chosen_precision(const Scene& scene, const Model& model, double dt);

}  // namespace drapeau
