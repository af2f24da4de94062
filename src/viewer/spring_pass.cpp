#include "spring_pass.hpp"

#include "colour_scale.hpp"

#include <algorithm>
#include <cstdlib>

namespace drapeau {

namespace {

const glm::vec3 dark(0.012f, 0.015f, 0.022f), light(0.93f, 0.92f, 0.88f);  // linear
const glm::vec3 ghostly(0.0f, 0.62f, 0.36f);

/// How much slack springs stand back, so that those that pull stand out: white ones before dark cloth most, a chain,
/// which has no others, not at all.
float slack_presence(const Picture& picture, bool on_cloth, bool chain) {
    if (chain) return 1.0f;
    return on_cloth && picture.colours == Colours::red ? 0.35f : 0.6f;
}

}  // namespace

void SpringPass::draw(const GridTextures& grid, const Picture& picture, const FlagTexture& texture) const {
    const bool chain = grid.columns() == 1 || grid.rows() == 1;
    const bool on_picture = picture.cloth && picture.texture && texture && !picture.forces && !chain;
    const bool on_cloth = picture.cloth && !chain;
    shader_.use();
    glBindVertexArray(nothing_.id());
    shader_.set("grid", glm::ivec2(grid.columns(), grid.rows()));
    shader_.set("on_picture", on_picture ? 1 : 0);
    shader_.set("by_force", picture.forces ? 1 : 0);
    shader_.set("force_scale", picture.force_scale);
    shader_.set("scale_colours", force_colours(picture.colours));
    shader_.set("dashed", 0);
    shader_.set("casing", picture.forces && (!on_cloth || picture.stretch) ? 0.7f : 0.0f);
    shader_.set("slack_presence", slack_presence(picture, on_cloth, chain));
    shader_.set("lift", 0.12f * std::min(picture.kinds.fly.rest, picture.kinds.hoist.rest));
    shader_.set("color", on_cloth ? light : dark);
    if (on_picture) {
        glActiveTexture(GL_TEXTURE3);
        glBindTexture(GL_TEXTURE_2D, texture.id());
    }

    // Diagonals first, thinner: the structure stays readable on top.
    if (picture.kinds.diagonal.exists()) {
        shader_.set("width", picture.forces ? 1.5f : 1.2f);
        shader_.set("opacity", picture.forces ? 0.6f : 0.5f);
        draw_kind(grid, {1, 1}, picture.kinds.diagonal);
        draw_kind(grid, {-1, 1}, picture.kinds.diagonal);
    }
    shader_.set("width", chain ? 2.6f : 2.0f);
    shader_.set("opacity", on_picture ? 0.8f : 1.0f);
    draw_kind(grid, {1, 0}, picture.kinds.fly);
    draw_kind(grid, {0, 1}, picture.kinds.hoist);
}

void SpringPass::draw_wireframe(const GridTextures& grid, const Picture& picture) const {
    shader_.use();
    glBindVertexArray(nothing_.id());
    shader_.set("grid", glm::ivec2(grid.columns(), grid.rows()));
    shader_.set("on_picture", 0);
    shader_.set("by_force", 0);
    const bool others = picture.springs || picture.forces || (picture.stretch && picture.cloth);
    shader_.set("dashed", others ? 1 : 0);
    shader_.set("casing", 0.0f);
    shader_.set("lift", 0.24f * std::min(picture.kinds.fly.rest, picture.kinds.hoist.rest));
    shader_.set("color", ghostly);
    shader_.set("width", others ? 1.2f : 1.6f);
    shader_.set("opacity", picture.reference);
    draw_kind(grid, {1, 0}, picture.kinds.fly);
    draw_kind(grid, {0, 1}, picture.kinds.hoist);
}

/// Every spring from a mass to the one `offset` columns and rows further.
void SpringPass::draw_kind(const GridTextures& grid, glm::ivec2 offset, const SpringKind& kind) const {
    const int per_row = grid.columns() - std::abs(offset.x);
    const int rows = grid.rows() - offset.y;
    if (per_row <= 0 || rows <= 0) return;
    shader_.set("offset", offset);
    shader_.set("per_row", per_row);
    shader_.set("rest", kind.rest);
    shader_.set("stiffness", kind.stiffness);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, per_row * rows);
}

}  // namespace drapeau
