#include "cloth_surface.hpp"

#include "cloth_mesh.hpp"
#include "software_renderer.hpp"

namespace drapeau {

ClothSurface::ClothSurface()
    : places_(make_texture()),
      normals_(make_texture()),
      target_(make_framebuffer()),
      nothing_(make_vertex_array()),
      most_points_(drawn_by_llvmpipe() ? 120 : 240) {
    for (const GLuint id : {places_.id(), normals_.id()}) {
        glBindTexture(GL_TEXTURE_2D, id);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    }
}

ClothMesh ClothSurface::follow(const GridTextures& grid, glm::vec2 cell, bool bare) {
    const glm::ivec2 masses(grid.columns(), grid.rows());
    const glm::ivec2 pieces = pieces_of_cell(masses, cell, most_points_);
    if (bare || grid.triangles().index_count() == 0 || pieces == glm::ivec2(1))
        return {.triangles = grid.triangles().array(),
                .index_count = grid.triangles().index_count(),
                .points = masses,
                .smooth = false};

    glActiveTexture(GL_TEXTURE5);
    const glm::ivec2 points = (masses - 1) * pieces + 1;
    if (points != points_) allocate(points);
    glBindTexture(GL_TEXTURE_2D, 0);  // never read where it is written
    glBindFramebuffer(GL_FRAMEBUFFER, target_.id());
    glViewport(0, 0, points.x, points.y);
    glDisable(GL_FRAMEBUFFER_SRGB);
    shader_.use();
    shader_.set("masses", masses);
    shader_.set("pieces", pieces);
    glBindVertexArray(nothing_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);

    GLenum unit = GL_TEXTURE5;
    for (const GLuint id : {places_.id(), normals_.id()}) {
        glActiveTexture(unit++);
        glBindTexture(GL_TEXTURE_2D, id);
    }
    return {.triangles = triangles_.array(), .index_count = triangles_.index_count(), .points = points, .smooth = true};
}

void ClothSurface::allocate(glm::ivec2 points) {
    points_ = points;
    glBindFramebuffer(GL_FRAMEBUFFER, target_.id());
    GLenum attachment = GL_COLOR_ATTACHMENT0;
    for (const GLuint id : {places_.id(), normals_.id()}) {
        glBindTexture(GL_TEXTURE_2D, id);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, points.x, points.y, 0, GL_RGBA, GL_FLOAT, nullptr);
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment++, GL_TEXTURE_2D, id, 0);
    }
    const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(2, both);

    triangles_.span(points.x, points.y);
}

}  // namespace drapeau
