// Poles, bars and finials: one cylinder and one ball, drawn once for each with its place.
#pragma once

#include "gl_objects.hpp"
#include "picture.hpp"
#include "shader.hpp"

namespace drapeau {

class SolidPass {
public:
    SolidPass() : nothing_(make_vertex_array()) {}

    void draw(const Stage& stage) const { draw_with(solid_, stage); }
    void draw_towards_sun(const Stage& stage) const { draw_with(sun_, stage); }
    void draw_shadow(const Stage& stage) const { draw_with(shadow_, stage); }

private:
    void draw_with(const Shader& shader, const Stage& stage) const;

    Shader solid_{"solid"};
    Shader shadow_{"solid_shadow", "shadow"};
    Shader sun_{"solid_sun", "shadow"};
    GlVertexArray nothing_;
};

}  // namespace drapeau
