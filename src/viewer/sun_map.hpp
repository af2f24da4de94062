// SunMap: how far the sun's light comes, a depth map that shaders look up (shaders/sun_reach.glsl). It is fitted to the
// cloth as it is now; what stands between it and the sun casts its shadow too.
#pragma once

#include "gl_objects.hpp"

#include "drapeau/state.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace drapeau {

/// Towards the sun.
extern const glm::vec3 to_sun;

/// The square around the cloth as the sun sees it.
struct SunView {
    glm::mat4 to_map{1.0f};  // clip coordinates of the map
    float side = 1.0f;       // m
};

SunView sun_view_of(const FieldBuffer<float>& position);

class SunMap {
public:
    SunMap();

    void begin() const;  // what is drawn until end casts shadows on what is drawn later
    void end() const;

    int side() const { return side_; }  // pixels

private:
    GlTexture depth_;
    GlFramebuffer target_;
    int side_;
};

}  // namespace drapeau
