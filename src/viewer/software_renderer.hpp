// Whether OpenGL is drawn by the processor, which the picture's finest detail would keep too busy.
#pragma once

#include <GL/glew.h>

#include <string_view>

namespace drapeau {

inline bool drawn_by_llvmpipe() {
    const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return renderer && std::string_view(renderer).starts_with("llvmpipe");
}

}  // namespace drapeau
