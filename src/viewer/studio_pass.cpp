#include "studio_pass.hpp"

namespace drapeau {

StudioPass::StudioPass() : nothing_(make_vertex_array()) {}

void StudioPass::draw() const {
    glBindVertexArray(nothing_.id());
    studio_.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void StudioPass::draw_checkerboard(float side) const {
    glBindVertexArray(nothing_.id());
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    checkerboard_.use();
    checkerboard_.set("side", side);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
}

}  // namespace drapeau
