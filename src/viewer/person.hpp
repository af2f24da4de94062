// A figure as tall as a person, as a scale.
#pragma once

#include "picture.hpp"

namespace drapeau {

inline constexpr float person_height = 1.75f;  // m

/// Puts it on the ground at `place` (x and z), facing the viewer.
void add_person(Stage& stage, glm::vec2 place);

}  // namespace drapeau
