// Masses as round points that grow with nearness, within bounds.
#pragma once

#include "gl_objects.hpp"
#include "grid_textures.hpp"
#include "picture.hpp"
#include "shader.hpp"

namespace drapeau {

class MassPass {
public:
    MassPass() : nothing_(make_vertex_array()) {}

    void draw(const GridTextures& grid, const Picture& picture) const;

private:
    Shader shader_{"mass"};
    GlVertexArray nothing_;
};

}  // namespace drapeau
