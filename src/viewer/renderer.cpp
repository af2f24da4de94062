#include "renderer.hpp"

#include <algorithm>
#include <utility>

namespace drapeau {

namespace {

bool same(const FieldBuffer<float>& a, const FieldBuffer<float>& b) {
    if (a.columns() != b.columns() || a.rows() != b.rows()) return false;
    for (int c = 0; c < 3; ++c)
        if (!std::equal(a.component(c).begin(), a.component(c).end(), b.component(c).begin())) return false;
    return true;
}

const LineLook streak_look{.widths = {0.9f, 1.7f}, .opacities = {0.05f, 0.4f}};
const LineLook velocity_look{.color = {1.0f, 0.72f, 0.05f}, .widths = {3.2f, 1.0f}, .casing = 0.8f};
constexpr float behind_cloth = 0.3f;  // of its opacity

}  // namespace

Renderer::Renderer() : block_(make_buffer()) {
    glBindBuffer(GL_UNIFORM_BUFFER, block_.id());
    glBufferData(GL_UNIFORM_BUFFER, sizeof(FrameBlock), nullptr, GL_DYNAMIC_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, block_.id());
}

void Renderer::send(const FrameBlock& block) {
    glBindBuffer(GL_UNIFORM_BUFFER, block_.id());
    glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof block, &block);
}

void Renderer::upload(const Snapshot& snapshot) {
    if (same(position_, snapshot.position)) return;
    position_ = snapshot.position;
    is_uploaded_ = false;
    sun_view_ = sun_view_of(snapshot.position);
    ++shapes_;
}

void Renderer::upload_reference(const Snapshot& snapshot) {
    reference_.upload(snapshot.position);
    ++shapes_;
}

bool Renderer::wear(std::optional<Image> image) {
    image ? texture_.load(std::move(*image)) : texture_.clear();
    ++shapes_;
    return texture_.has_holes();
}

void Renderer::draw(const Picture& picture, RenderTarget& target) {
    const RenderTarget::Contents contents{picture, shapes_};
    if (target.holds(contents)) return;
    if (!std::exchange(is_uploaded_, true)) grid_.upload(position_);
    send(frame_block(picture, {target.width(), target.height()}, sun_view_, sun_map_.side()));
    draw_shadow(picture);
    target.begin_scene(contents);
    draw_scene(picture);
}

void Renderer::draw_shadow(const Picture& picture) {
    grid_.bind();
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_DEPTH_TEST);
    mesh_ = surface_.follow(grid_, {picture.kinds.fly.rest, picture.kinds.hoist.rest}, picture.bare_grid);
    if (picture.stretch && mesh_.index_count > 0) stretch_.follow(grid_, picture.kinds);
    sun_map_.begin();
    if (picture.cloth) cloth_.draw_towards_sun(mesh_, picture, texture_);
    solids_.draw_towards_sun(picture.stage);
    sun_map_.end();
    backdrop_.begin_shadow();
    if (picture.cloth) cloth_.draw_shadow(mesh_, picture, texture_);
    solids_.draw_shadow(picture.stage);
    backdrop_.end_shadow();
}

void Renderer::draw_scene(const Picture& picture) {
    grid_.bind();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_TRUE);
    glClearDepth(1.0);
    glClear(GL_DEPTH_BUFFER_BIT);
    if (picture.background == Background::transparent) {
        glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
        glClear(GL_COLOR_BUFFER_BIT);
    }

    // Nothing is nearer than 0: what the panel covers costs nothing.
    if (picture.hidden.z > 0 && picture.hidden.w > 0) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(picture.hidden.x, picture.hidden.y, picture.hidden.z, picture.hidden.w);
        glClearDepth(0.0);
        glClear(GL_DEPTH_BUFFER_BIT);
        glDisable(GL_SCISSOR_TEST);
    }

    // Opaque things first, so that the backdrop is computed only where it shows.
    if (picture.cloth) cloth_.draw(mesh_, picture, texture_);
    solids_.draw(picture.stage);
    person_.draw(picture.stage);
    draw_background(picture);

    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    draw_lines(picture);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
}

// What is behind comes first: none of these hides another by its depth.
void Renderer::draw_lines(const Picture& picture) {
    const bool chain = grid_.columns() == 1 || grid_.rows() == 1;
    lines_.draw(picture.streaks, streak_look);
    if (picture.reference > 0.0f) {
        reference_.bind();
        springs_.draw_wireframe(reference_, picture);
        grid_.bind();
    }
    if (picture.springs || picture.forces || chain) springs_.draw(grid_, picture, texture_);
    if (picture.masses || chain) masses_.draw(grid_, picture);
    if (picture.velocities.empty()) return;
    LineLook look = velocity_look;
    look.lift = 0.25f * std::min(picture.kinds.fly.rest, picture.kinds.hoist.rest);
    lines_.draw(picture.velocities, look);
    glDepthFunc(GL_GREATER);
    look.opacities *= behind_cloth;
    lines_.draw(picture.velocities, look);
    glDepthFunc(GL_LEQUAL);
}

void Renderer::draw_background(const Picture& picture) const {
    if (picture.background == Background::sky) backdrop_.draw(picture.stage);
    if (picture.background != Background::studio) return;
    studio_.draw();
    if (picture.stage.ground) backdrop_.draw_standing(picture.stage);
}

}  // namespace drapeau
