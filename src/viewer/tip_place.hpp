// Where a tooltip stands: beside the box whose control it explains, never over it, and within the window.
#pragma once

#include "camera.hpp"

#include <glm/vec2.hpp>

namespace drapeau {

/// The upper left corner of a tip of this size, `gap` away from the `box` that holds the control: right of it, else
/// left, below or above; where none of them has the room, below or above the control itself.
glm::vec2 tip_corner(const Area& box, const Area& control, glm::vec2 size, glm::vec2 window, float gap);

/// How wide a tip beside the box may be: `wanted`, or what there is if that is at least `least`.
float tip_width(const Area& box, glm::vec2 window, float gap, float wanted, float least);

}  // namespace drapeau
