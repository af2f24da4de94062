#include "backdrop_pass.hpp"

namespace drapeau {

namespace {

constexpr int shadow_side = 512;  // pixels

}  // namespace

BackdropPass::BackdropPass() : nothing_(make_vertex_array()), shadow_(make_texture()), target_(make_framebuffer()) {
    glActiveTexture(GL_TEXTURE4);
    glBindTexture(GL_TEXTURE_2D, shadow_.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, shadow_side, shadow_side, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 5);
    glGenerateMipmap(GL_TEXTURE_2D);
    glBindFramebuffer(GL_FRAMEBUFFER, target_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, shadow_.id(), 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    shader_.use();
    shader_.set("shadow_map", 4);
}

void BackdropPass::begin_shadow() const {
    glBindFramebuffer(GL_FRAMEBUFFER, target_.id());
    glViewport(0, 0, shadow_side, shadow_side);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT);
}

void BackdropPass::end_shadow() const {
    glActiveTexture(GL_TEXTURE4);
    glBindTexture(GL_TEXTURE_2D, shadow_.id());
    glGenerateMipmap(GL_TEXTURE_2D);
}

void BackdropPass::draw() const {
    shader_.use();
    glActiveTexture(GL_TEXTURE4);
    glBindTexture(GL_TEXTURE_2D, shadow_.id());
    glBindVertexArray(nothing_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace drapeau
