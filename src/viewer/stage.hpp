// What holds the flag of a scene: a pole, a bar between two posts or a frame, and the ground below; and what the
// camera frames.
#pragma once

#include "camera.hpp"
#include "picture.hpp"
#include "scene/scene.hpp"

namespace drapeau {

/// Whether a tape with grommets runs along the hoist.
bool has_header(const FlagSettings& flag);

/// `with_person`: a person stands to the left of it, as a scale.
Stage stage_of(const Scene& scene, bool with_person = false);

Framing framing_of(const FlagSettings& flag, const Stage& stage);

}  // namespace drapeau
