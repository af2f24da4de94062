// Move-only owners of OpenGL names: what is made is deleted, on failure paths too.
#pragma once

#include <GL/glew.h>

#include <utility>

namespace drapeau {

template <void (*destroy)(GLuint)>
class GlObject {
public:
    GlObject() = default;
    explicit GlObject(GLuint id) : id_(id) {}
    ~GlObject() {
        if (id_ != 0) destroy(id_);
    }
    GlObject(GlObject&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }

    GLuint id() const { return id_; }
    explicit operator bool() const { return id_ != 0; }

private:
    GLuint id_ = 0;
};

inline void destroy_buffer(GLuint id) {
    glDeleteBuffers(1, &id);
}
inline void destroy_vertex_array(GLuint id) {
    glDeleteVertexArrays(1, &id);
}
inline void destroy_texture(GLuint id) {
    glDeleteTextures(1, &id);
}
inline void destroy_framebuffer(GLuint id) {
    glDeleteFramebuffers(1, &id);
}
inline void destroy_renderbuffer(GLuint id) {
    glDeleteRenderbuffers(1, &id);
}
inline void destroy_shader(GLuint id) {
    glDeleteShader(id);
}
inline void destroy_program(GLuint id) {
    glDeleteProgram(id);
}

using GlBuffer = GlObject<destroy_buffer>;
using GlVertexArray = GlObject<destroy_vertex_array>;
using GlTexture = GlObject<destroy_texture>;
using GlFramebuffer = GlObject<destroy_framebuffer>;
using GlRenderbuffer = GlObject<destroy_renderbuffer>;
using GlShader = GlObject<destroy_shader>;
using GlProgram = GlObject<destroy_program>;

inline GlBuffer make_buffer() {
    GLuint id = 0;
    glGenBuffers(1, &id);
    return GlBuffer(id);
}
inline GlVertexArray make_vertex_array() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return GlVertexArray(id);
}
inline GlTexture make_texture() {
    GLuint id = 0;
    glGenTextures(1, &id);
    return GlTexture(id);
}
inline GlFramebuffer make_framebuffer() {
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    return GlFramebuffer(id);
}
inline GlRenderbuffer make_renderbuffer() {
    GLuint id = 0;
    glGenRenderbuffers(1, &id);
    return GlRenderbuffer(id);
}

}  // namespace drapeau
