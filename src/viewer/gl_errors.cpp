#include "gl_errors.hpp"

#include "io/terminal.hpp"

#include <GL/glew.h>

#include <fmt/format.h>

#include <cstdlib>
#include <string>

namespace drapeau {

namespace {

bool everything_wanted() {
    const char* debug = std::getenv("DRAPEAU_GL_DEBUG");
    return debug && std::string(debug) == "all";
}

void GLAPIENTRY on_message(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message, const void* user) {
    static const bool prints_notes = everything_wanted();
    if (type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR)
        static_cast<GlErrors*>(const_cast<void*>(user))->add(message);
    else if (prints_notes)
        complain("drapeau", std::string("OpenGL, a note: ") + message);
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
