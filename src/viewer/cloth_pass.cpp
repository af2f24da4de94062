#include "cloth_pass.hpp"

namespace drapeau {

namespace {

void draw_triangles(const GridTextures& grid) {
    glBindVertexArray(grid.triangles());
    glDrawElements(GL_TRIANGLES, grid.index_count(), GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
}

}  // namespace

void ClothPass::draw(const GridTextures& grid, const Picture& picture, const FlagTexture& texture) const {
    if (grid.index_count() == 0) return;
    const bool textured = picture.texture && texture;
    cloth_.use();
    cloth_.set("grid", glm::ivec2(grid.columns(), grid.rows()));
    cloth_.set("textured", textured ? 1 : 0);
    cloth_.set("dimmed", picture.forces ? 1.0f : 0.0f);
    if (textured) {
        glActiveTexture(GL_TEXTURE3);
        glBindTexture(GL_TEXTURE_2D, texture.id());
    }
    draw_triangles(grid);
}

void ClothPass::draw_shadow(const GridTextures& grid) const {
    if (grid.index_count() == 0) return;
    shadow_.use();
    shadow_.set("grid", glm::ivec2(grid.columns(), grid.rows()));
    draw_triangles(grid);
}

}  // namespace drapeau
