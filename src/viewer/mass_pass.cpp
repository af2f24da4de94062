#include "mass_pass.hpp"

#include <algorithm>

namespace drapeau {

void MassPass::draw(const GridTextures& grid, const Picture& picture) const {
    const bool chain = grid.columns() == 1 || grid.rows() == 1;
    const float fly = picture.kinds.fly.rest, hoist = picture.kinds.hoist.rest;
    const float cell = chain ? std::max(fly, hoist) : std::min(fly, hoist);
    shader_.use();
    shader_.set("columns", grid.columns());
    shader_.set("radius", (chain ? 0.16f : 0.13f) * cell);
    shader_.set("max_pixels", chain ? 12.0f : 7.0f);
    shader_.set("lift", 0.2f * cell);
    glBindVertexArray(nothing_.id());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, grid.columns() * grid.rows());
}

}  // namespace drapeau
