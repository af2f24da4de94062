#include "stretch_map.hpp"

namespace drapeau {

StretchMap::StretchMap() : stretch_(make_texture()), target_(make_framebuffer()), nothing_(make_vertex_array()) {
    glBindTexture(GL_TEXTURE_2D, stretch_.id());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

void StretchMap::follow(const GridTextures& grid, const SpringKinds& kinds) {
    const glm::ivec2 masses(grid.columns(), grid.rows());
    glActiveTexture(GL_TEXTURE8);
    if (masses != masses_) allocate(masses);
    glBindTexture(GL_TEXTURE_2D, 0);  // never read where it is written
    glBindFramebuffer(GL_FRAMEBUFFER, target_.id());
    glViewport(0, 0, masses.x, masses.y);
    glDisable(GL_FRAMEBUFFER_SRGB);
    shader_.use();
    shader_.set("masses", masses);
    shader_.set("fly", kinds.fly.rest);
    shader_.set("hoist", kinds.hoist.rest);
    shader_.set("diagonal", kinds.diagonal.rest);
    glBindVertexArray(nothing_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindTexture(GL_TEXTURE_2D, stretch_.id());
}

void StretchMap::allocate(glm::ivec2 masses) {
    masses_ = masses;
    glBindTexture(GL_TEXTURE_2D, stretch_.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, masses.x, masses.y, 0, GL_RED, GL_FLOAT, nullptr);
    glBindFramebuffer(GL_FRAMEBUFFER, target_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, stretch_.id(), 0);
}

}  // namespace drapeau
