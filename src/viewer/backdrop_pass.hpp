// Sky, ground, the slab that carries the pole and the shadow upon them, behind everything else. The shadow is first
// drawn into a small texture laid on the ground; its mipmaps make the edges soft.
#pragma once

#include "gl_objects.hpp"
#include "picture.hpp"
#include "shader.hpp"

namespace drapeau {

class BackdropPass {
public:
    BackdropPass();

    void begin_shadow() const;  // what is drawn until end_shadow falls on the ground
    void end_shadow() const;
    void draw(const Stage& stage) const;
    void draw_standing(const Stage& stage) const;  // slab and shadow alone, upon ground that is there already

private:
    void draw_ground(const Stage& stage) const;
    void draw_slab(const Base& base, float share, glm::vec3 color, float nearer) const;

    Shader sky_{"sky"};
    Shader ground_{"ground"};
    Shader slab_{"slab"};
    Shader ground_shadow_{"ground_shadow"};
    GlVertexArray nothing_;
    GlTexture shadow_;
    GlFramebuffer target_;
};

}  // namespace drapeau
