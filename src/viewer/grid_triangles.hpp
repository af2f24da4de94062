// GridTriangles: the triangles of a grid of points on the GPU.
#pragma once

#include "gl_objects.hpp"

namespace drapeau {

class GridTriangles {
public:
    GridTriangles() : array_(make_vertex_array()), indices_(make_buffer()) {}

    /// Between the points of so many columns and rows.
    void span(int columns, int rows);

    GLuint array() const { return array_.id(); }  // a vertex array whose elements are row * columns + column
    int index_count() const { return index_count_; }

private:
    GlVertexArray array_;
    GlBuffer indices_;
    int index_count_ = 0;
};

}  // namespace drapeau
