// Streak: a line in the scene, as of drifting air or along a velocity.
#pragma once

#include <glm/vec3.hpp>

namespace drapeau {

struct Streak {
    glm::vec3 from{0.0f}, to{0.0f};  // m
    float strength = 0.0f;           // of its opacity, 0 to 1

    bool operator==(const Streak&) const = default;
};

}  // namespace drapeau
