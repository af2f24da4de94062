#include "cloth_pass.hpp"

#include "colour_scale.hpp"

namespace drapeau {

namespace {

void draw_triangles(const Shader& shader, const ClothMesh& mesh) {
    shader.set("points", mesh.points);
    shader.set("smooth_surface", mesh.smooth ? 1 : 0);
    glBindVertexArray(mesh.triangles);
    glDrawElements(GL_TRIANGLES, mesh.index_count, GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
}

void bind(const FlagTexture& texture) {
    glActiveTexture(GL_TEXTURE3);
    glBindTexture(GL_TEXTURE_2D, texture.id());
}

bool is_cut_out(const Picture& picture, const FlagTexture& texture) {
    return picture.texture && picture.cut_out && texture && texture.has_holes();
}

void draw_outline(const Shader& shader, const ClothMesh& mesh, bool cut_out, const FlagTexture& texture) {
    if (mesh.index_count == 0) return;
    shader.use();
    if (cut_out) bind(texture);
    draw_triangles(shader, mesh);
}

}  // namespace

void ClothPass::draw(const ClothMesh& mesh, const Picture& picture, const FlagTexture& texture) const {
    if (mesh.index_count == 0) return;
    const bool textured = picture.texture && texture, cut_out = is_cut_out(picture, texture);
    const Shader& shader = cut_out ? cut_out_ : cloth_;
    shader.use();
    shader.set("textured", textured ? 1 : 0);
    shader.set("dimmed", picture.forces && !picture.stretch ? 1.0f : 0.0f);
    shader.set("by_stretch", picture.stretch ? 1 : 0);
    if (picture.stretch) {
        shader.set("stretch_scale", picture.stretch_scale);
        shader.set("scale_colours", stretch_colours(picture.colours));
    }
    shader.set("cloth_size", picture.cloth_size);
    shader.set("sewn", cut_out || picture.forces || picture.stretch ? 0 : picture.header ? 2 : 1);
    if (textured) bind(texture);
    // Of a pixel's samples as many as the outline leaves of it; those are opaque.
    if (cut_out) glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE), glEnable(GL_SAMPLE_ALPHA_TO_ONE);
    draw_triangles(shader, mesh);
    glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glDisable(GL_SAMPLE_ALPHA_TO_ONE);
}

void ClothPass::draw_shadow(const ClothMesh& mesh, const Picture& picture, const FlagTexture& texture) const {
    const bool cut_out = is_cut_out(picture, texture);
    draw_outline(cut_out ? cut_out_shadow_ : shadow_, mesh, cut_out, texture);
}

void ClothPass::draw_towards_sun(const ClothMesh& mesh, const Picture& picture, const FlagTexture& texture) const {
    const bool cut_out = is_cut_out(picture, texture);
    draw_outline(cut_out ? cut_out_sun_ : sun_, mesh, cut_out, texture);
}

}  // namespace drapeau
