#include "cloth_pass.hpp"

namespace drapeau {

namespace {

void draw_triangles(const GridTextures& grid) {
    glBindVertexArray(grid.triangles());
    glDrawElements(GL_TRIANGLES, grid.index_count(), GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
}

void bind(const FlagTexture& texture) {
    glActiveTexture(GL_TEXTURE3);
    glBindTexture(GL_TEXTURE_2D, texture.id());
}

bool is_cut_out(const Picture& picture, const FlagTexture& texture) {
    return picture.texture && picture.cut_out && texture && texture.has_holes();
}

}  // namespace

void ClothPass::draw(const GridTextures& grid, const Picture& picture, const FlagTexture& texture) const {
    if (grid.index_count() == 0) return;
    const bool textured = picture.texture && texture, cut_out = is_cut_out(picture, texture);
    const Shader& shader = cut_out ? cut_out_ : cloth_;
    shader.use();
    shader.set("grid", glm::ivec2(grid.columns(), grid.rows()));
    shader.set("textured", textured ? 1 : 0);
    shader.set("dimmed", picture.forces ? 1.0f : 0.0f);
    if (textured) bind(texture);
    // Of a pixel's samples as many as the outline leaves of it; those are opaque.
    if (cut_out) glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE), glEnable(GL_SAMPLE_ALPHA_TO_ONE);
    draw_triangles(grid);
    glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glDisable(GL_SAMPLE_ALPHA_TO_ONE);
}

void ClothPass::draw_shadow(const GridTextures& grid, const Picture& picture, const FlagTexture& texture) const {
    if (grid.index_count() == 0) return;
    const bool cut_out = is_cut_out(picture, texture);
    const Shader& shader = cut_out ? cut_out_shadow_ : shadow_;
    shader.use();
    shader.set("grid", glm::ivec2(grid.columns(), grid.rows()));
    if (cut_out) bind(texture);
    draw_triangles(grid);
}

}  // namespace drapeau
