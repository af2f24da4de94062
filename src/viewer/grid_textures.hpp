// GridTextures: the masses' positions on the GPU, the component arrays as the core stores them, and the triangles
// between them. Shaders fetch a mass (column, row) from three single-channel float textures as wide as a padded row.
#pragma once

#include "gl_objects.hpp"
#include "run/simulation.hpp"

namespace drapeau {

class GridTextures {
public:
    GridTextures();

    void upload(const Snapshot& snapshot);
    void bind() const;  // units 0, 1, 2

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    int index_count() const { return index_count_; }
    GLuint triangles() const { return triangles_.id(); }  // a vertex array whose elements are row * columns + column

private:
    void allocate(const Snapshot& snapshot);

    GlTexture x_, y_, z_;
    GlVertexArray triangles_;
    GlBuffer indices_;
    int columns_ = 0, rows_ = 0, stride_ = 0, index_count_ = 0;
};

}  // namespace drapeau
