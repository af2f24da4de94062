#include "frame_block.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace drapeau {

namespace {

// The part of the ground where the shadow of the stage's box may lie.
glm::vec4 shadow_area(const Stage& stage) {
    glm::vec2 low(1e9f), high(-1e9f);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 p((corner & 1) ? stage.low.x : stage.high.x, (corner & 2) ? stage.low.y : stage.high.y,
                          (corner & 4) ? stage.low.z : stage.high.z);
        const glm::vec3 foot = p - to_sun * ((p.y - stage.ground_height) / to_sun.y);
        low = glm::min(low, glm::vec2(foot.x, foot.z));
        high = glm::max(high, glm::vec2(foot.x, foot.z));
    }
    return {low.x, low.y, 1.0f / (high.x - low.x), 1.0f / (high.y - low.y)};
}

}  // namespace

FrameBlock frame_block(const Picture& picture, glm::vec2 size, const SunView& sun, int sun_map_side) {
    const glm::mat4 to_clip = picture.projection * picture.view;
    const Stage& stage = picture.stage;
    return {.to_clip = to_clip,
            .to_world = glm::inverse(to_clip),
            .eye = glm::vec4(picture.eye, 1.0f),
            .sun = glm::vec4(to_sun, 0.0f),
            .picture = {size.x, size.y, picture.pixel_scale, 0.0f},
            .ground = {stage.ground_height, stage.ground ? 1.0f : 0.0f, 0.0f, 0.0f},
            .shadow = shadow_area(stage),
            .to_sun_map = sun.to_map,
            .sun_map = {sun.side / float(sun_map_side), 1.0f / float(sun_map_side), 0.0f, 0.0f}};
}

}  // namespace drapeau
