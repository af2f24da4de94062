#include "gl_errors.hpp"

#include "io/terminal.hpp"

#include <GL/glew.h>

#include <fmt/format.h>
#include <string>

namespace drapeau {

namespace {

void GLAPIENTRY on_message(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message, const void* user) {
    if (type != GL_DEBUG_TYPE_ERROR && type != GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR) return;
    static_cast<GlErrors*>(const_cast<void*>(user))->add(message);
}

}  // namespace

GlErrors::GlErrors(bool debug) {
    while (glGetError() != GL_NO_ERROR) {
    }  // loading the functions may leave one behind
    if (!debug || !GLEW_KHR_debug) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(on_message, this);
}

void GlErrors::poll() {
    for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError()) {
        add(fmt::format("glGetError 0x{:04x}", error).c_str());
    }
}

void GlErrors::add(const char* message) {
    ++count_;
    complain("drapeau", std::string("OpenGL: ") + message);
}

}  // namespace drapeau
