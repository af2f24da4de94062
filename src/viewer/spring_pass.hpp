// Springs as lines of constant width on the screen, a quad each, coloured by their force if wished.
#pragma once

#include "flag_texture.hpp"
#include "gl_objects.hpp"
#include "grid_textures.hpp"
#include "picture.hpp"
#include "shader.hpp"

namespace drapeau {

class SpringPass {
public:
    SpringPass() : nothing_(make_vertex_array()) {}

    void draw(const GridTextures& grid, const Picture& picture, const FlagTexture& texture) const;
    /// Springs along the fly and the hoist, in one colour, in front of what is as far away; thin dashes where other
    /// lines or colours are to be read too, which are drawn over it.
    void draw_wireframe(const GridTextures& grid, const Picture& picture) const;

private:
    void draw_kind(const GridTextures& grid, glm::ivec2 offset, const SpringKind& kind) const;

    Shader shader_{"spring"};
    GlVertexArray nothing_;
};

}  // namespace drapeau
