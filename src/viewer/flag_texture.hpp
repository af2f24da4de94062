// FlagTexture: the image on the flag, sRGB with mipmaps, its colours multiplied by its alpha, so that what is
// transparent gives its neighbours no colour. The shaders lay it on cloth or cut it out (shaders/image.glsl).
#pragma once

#include "gl_objects.hpp"
#include "image/image.hpp"

namespace drapeau {

class FlagTexture {
public:
    void load(Image image);
    void clear();
    explicit operator bool() const { return bool(texture_); }
    GLuint id() const { return texture_.id(); }
    bool has_holes() const { return has_holes_; }

private:
    GlTexture texture_;
    bool has_holes_ = false;
};

}  // namespace drapeau
