// Sky, ground and the shadow upon it, in one pass behind everything else. The shadow is first drawn into a small
// texture laid on the ground; its mipmaps make the edges soft.
#pragma once

#include "gl_objects.hpp"
#include "shader.hpp"

namespace drapeau {

class BackdropPass {
public:
    BackdropPass();

    void begin_shadow() const;  // what is drawn until end_shadow falls on the ground
    void end_shadow() const;
    void draw() const;

private:
    Shader shader_{"backdrop"};
    GlVertexArray nothing_;
    GlTexture shadow_;
    GlFramebuffer target_;
};

}  // namespace drapeau
