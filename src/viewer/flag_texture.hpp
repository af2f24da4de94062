// FlagTexture: the image on the flag, sRGB with mipmaps. Where the image is transparent the cloth shows.
#pragma once

#include "gl_objects.hpp"
#include "image/image.hpp"

namespace drapeau {

class FlagTexture {
public:
    void load(const Image& image);
    void clear() { texture_ = GlTexture(); }
    explicit operator bool() const { return bool(texture_); }
    GLuint id() const { return texture_.id(); }

private:
    GlTexture texture_;
};

}  // namespace drapeau
