// GridTextures: the masses' positions on the GPU, the component arrays as the core stores them, and the triangles
// between them. Shaders fetch a mass (column, row) from three single-channel float textures as wide as a padded row.
#pragma once

#include "gl_objects.hpp"
#include "grid_triangles.hpp"
#include "drapeau/state.hpp"

namespace drapeau {

class GridTextures {
public:
    GridTextures();

    void upload(const FieldBuffer<float>& position);
    void bind() const;  // units 0, 1, 2

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    const GridTriangles& triangles() const { return triangles_; }

private:
    void allocate(const FieldBuffer<float>& position);

    GlTexture x_, y_, z_;
    GridTriangles triangles_;
    int columns_ = 0, rows_ = 0, stride_ = 0;
};

}  // namespace drapeau
