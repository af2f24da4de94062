// ClothSurface: the smooth surface through the masses. Between them it is a cubic along the fly and along the hoist
// (Catmull and Rom 1974; one-sided at borders), so that every mass is on it and neighbouring cells share their
// tangents. Places and normals of its points are drawn into two textures once a frame; shaders fetch them as they do
// masses.
#pragma once

#include "gl_objects.hpp"
#include "grid_textures.hpp"
#include "grid_triangles.hpp"
#include "shader.hpp"

#include <glm/vec2.hpp>

namespace drapeau {

/// What of the cloth is drawn: the masses themselves, or the points of the smooth surface.
struct ClothMesh {
    GLuint triangles = 0;  // a vertex array whose elements are row * columns + column
    int index_count = 0;
    glm::ivec2 points{0};  // columns and rows
    bool smooth = false;   // points are those of the surface's textures
};

class ClothSurface {
public:
    ClothSurface();

    /// Follows the masses, which are bound, and gives what to draw: the masses themselves where `bare`, or where they
    /// are close enough by themselves. `cell`: m. Leaves another framebuffer bound.
    ClothMesh follow(const GridTextures& grid, glm::vec2 cell, bool bare);

private:
    void allocate(glm::ivec2 points);

    Shader shader_{"whole_target", "cloth_surface"};
    GlTexture places_, normals_;
    GlFramebuffer target_;
    GridTriangles triangles_;
    GlVertexArray nothing_;
    int most_points_;  // along the longer side
    glm::ivec2 points_{0};
};

}  // namespace drapeau
