// What holds the flag of a scene: a pole, a bar between two posts or a frame, and the ground below; and what the
// camera frames.
#pragma once

#include "camera.hpp"
#include "picture.hpp"
#include "scene/scene.hpp"

namespace drapeau {

Stage stage_of(const Scene& scene);

Framing framing_of(const FlagSettings& flag, const Stage& stage);

}  // namespace drapeau
