#include "line_pass.hpp"

#include <cstddef>

namespace drapeau {

LinePass::LinePass() : buffer_(make_buffer()), array_(make_vertex_array()) {
    glBindVertexArray(array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
    GLuint place = 0;
    const auto add = [&](GLint count, std::size_t offset) {
        glEnableVertexAttribArray(place);
        glVertexAttribPointer(place, count, GL_FLOAT, GL_FALSE, sizeof(Streak),
                              reinterpret_cast<const void*>(offset));  // so OpenGL names a place in a buffer
        glVertexAttribDivisor(place++, 1);
    };
    add(3, offsetof(Streak, from));
    add(3, offsetof(Streak, to));
    add(1, offsetof(Streak, strength));
    glBindVertexArray(0);
}

void LinePass::draw(std::span<const Streak> lines, const LineLook& look) const {
    if (lines.empty()) return;
    shader_.use();
    shader_.set("color", look.color);
    shader_.set("widths", look.widths);
    shader_.set("opacities", look.opacities);
    shader_.set("casing", look.casing);
    shader_.set("lift", look.lift);
    glBindVertexArray(array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(lines.size_bytes()), lines.data(), GL_STREAM_DRAW);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(lines.size()));
    glBindVertexArray(0);
}

}  // namespace drapeau
