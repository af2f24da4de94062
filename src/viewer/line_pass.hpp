// Lines in the scene, hidden by what is nearer: streaks of the wind, velocities.
#pragma once

#include "gl_objects.hpp"
#include "shader.hpp"
#include "streak.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <span>

namespace drapeau {

struct LineLook {
    glm::vec3 color{1.0f};   // linear
    glm::vec2 widths{1.0f};  // where a line begins and ends, in units of line width
    glm::vec2 opacities{1.0f};
    float casing = 0.0f;  // a dark line on either side, in units of line width
    float lift = 0.0f;    // m towards the eye
};

class LinePass {
public:
    LinePass();

    void draw(std::span<const Streak> lines, const LineLook& look) const;

private:
    Shader shader_{"line"};
    GlBuffer buffer_;
    GlVertexArray array_;
};

}  // namespace drapeau
