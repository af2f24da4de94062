// StretchMap: the stretch at every mass as a texture, drawn from the positions (see stretch.hpp), that the cloth is
// coloured by: linear between masses.
#pragma once

#include "gl_objects.hpp"
#include "grid_textures.hpp"
#include "picture.hpp"
#include "shader.hpp"

#include <glm/vec2.hpp>

namespace drapeau {

class StretchMap {
public:
    StretchMap();

    /// Follows the masses, which are bound, and binds itself for the shaders of the cloth. Leaves another framebuffer
    /// bound.
    void follow(const GridTextures& grid, const SpringKinds& kinds);

private:
    void allocate(glm::ivec2 masses);

    Shader shader_{"whole_target", "stretch"};
    GlTexture stretch_;
    GlFramebuffer target_;
    GlVertexArray nothing_;
    glm::ivec2 masses_{0};
};

}  // namespace drapeau
