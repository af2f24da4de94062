#include "grid_triangles.hpp"

#include "cloth_mesh.hpp"

namespace drapeau {

void GridTriangles::span(int columns, int rows) {
    const auto indices = triangles_between(columns, rows);
    index_count_ = int(indices.size());
    glBindVertexArray(array_.id());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size() * sizeof(indices[0])), indices.data(),
                 GL_STATIC_DRAW);
    glBindVertexArray(0);
}

}  // namespace drapeau
