// FrameBlock: the constants every shader sees this frame, laid out as shaders/frame.glsl declares them (std140).
#pragma once

#include "picture.hpp"
#include "sun_map.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace drapeau {

struct FrameBlock {
    glm::mat4 to_clip;
    glm::mat4 to_world;
    glm::vec4 eye;
    glm::vec4 sun;      // towards the sun
    glm::vec4 picture;  // width and height in pixels, pixels per unit of line width
    glm::vec4 ground;   // height, 1 if there is ground
    glm::vec4 shadow;   // x, z of the shadow texture's corner on the ground and 1 / its sides
    glm::mat4 to_sun_map;
    glm::vec4 sun_map;  // a pixel of it in m, and as a share of its side
};

FrameBlock frame_block(const Picture& picture, glm::vec2 size, const SunView& sun, int sun_map_side);

}  // namespace drapeau
