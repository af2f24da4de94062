#include "person_pass.hpp"

namespace drapeau {

void PersonPass::draw(const Stage& stage) const {
    if (!stage.person) return;
    shader_.use();
    shader_.set("feet", *stage.person);
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glBindVertexArray(nothing_.id());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
}

}  // namespace drapeau
