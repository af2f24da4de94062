#include "backdrop_pass.hpp"

namespace drapeau {

namespace {

constexpr int shadow_side = 512;    // pixels
constexpr int sky_cells = 24 * 24;  // as shaders/sky.vert has them
constexpr int ground_facets = 48;   // around a ring, as shaders/ground.vert has them
constexpr int ground_rings = 22;    // out to where the haze hides the last one's edge
constexpr int slab_facets = 64;
const glm::vec3 slab_rim(0.68f, 0.65f, 0.60f), slab_middle(0.58f, 0.55f, 0.51f);

}  // namespace

BackdropPass::BackdropPass() : nothing_(make_vertex_array()), shadow_(make_texture()), target_(make_framebuffer()) {
    glActiveTexture(GL_TEXTURE4);
    glBindTexture(GL_TEXTURE_2D, shadow_.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, shadow_side, shadow_side, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 5);
    glGenerateMipmap(GL_TEXTURE_2D);
    glBindFramebuffer(GL_FRAMEBUFFER, target_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, shadow_.id(), 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    ground_shadow_.use();
    ground_shadow_.set("shadow_map", 4);
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

void BackdropPass::draw(const Stage& stage) const {
    glBindVertexArray(nothing_.id());
    if (stage.ground) draw_ground(stage);
    sky_.use();
    glDrawArrays(GL_TRIANGLES, 0, 6 * sky_cells);
}

void BackdropPass::draw_ground(const Stage& stage) const {
    ground_.use();
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 2 * (ground_facets + 1), ground_rings);
    draw_standing(stage);
}

void BackdropPass::draw_standing(const Stage& stage) const {
    glBindVertexArray(nothing_.id());
    for (const Base& base : stage.bases) {
        draw_slab(base, 1.0f, slab_rim, 0.0f);
        draw_slab(base, 0.66f, slab_middle, 0.0001f);
    }
    glActiveTexture(GL_TEXTURE4);
    glBindTexture(GL_TEXTURE_2D, shadow_.id());
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    ground_shadow_.use();
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDisable(GL_BLEND);
}

void BackdropPass::draw_slab(const Base& base, float share, glm::vec3 color, float nearer) const {
    slab_.use();
    slab_.set("middle", base.place);
    slab_.set("radius", share * base.radius);
    slab_.set("color", color);
    slab_.set("nearer", nearer);
    glDrawArrays(GL_TRIANGLE_FAN, 0, slab_facets);
}

}  // namespace drapeau
