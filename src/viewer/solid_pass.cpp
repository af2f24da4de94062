#include "solid_pass.hpp"

namespace drapeau {

namespace {

constexpr int around = 28;      // facets around a rod, as shaders/solid.glsl has them
constexpr int ball_rings = 14;  // facets from pole to pole of a ball

}  // namespace

void SolidPass::draw_with(const Shader& shader, const Stage& stage) const {
    shader.use();
    glBindVertexArray(nothing_.id());
    shader.set("ball", 0);
    for (const Rod& rod : stage.rods) {
        shader.set("from", rod.from);
        shader.set("to", rod.to);
        shader.set("radius", rod.radius);
        shader.set("color", rod.color);
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 2 * (around + 1));
    }
    shader.set("ball", 1);
    for (const Ball& ball : stage.balls) {
        shader.set("from", ball.centre);
        shader.set("to", ball.centre);
        shader.set("radius", ball.radius);
        shader.set("color", ball.color);
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 2 * (around + 1), ball_rings);
    }
}

}  // namespace drapeau
