#include "flag_texture.hpp"

#include <algorithm>

namespace drapeau {

namespace {

constexpr int cloth_shade = 235;  // sRGB of undyed cloth, seen where the image is transparent
constexpr float wanted_anisotropy = 2.0f;

}  // namespace

void FlagTexture::load(const Image& image) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    Image opaque = shrunk_to(image, int(largest));
    for (std::size_t i = 0; i < opaque.rgba.size(); i += 4) {
        const int alpha = opaque.rgba[i + 3];
        for (std::size_t c = i; c < i + 3; ++c)
            opaque.rgba[c] = std::uint8_t((opaque.rgba[c] * alpha + cloth_shade * (255 - alpha) + 127) / 255);
        opaque.rgba[i + 3] = 255;
    }

    texture_ = make_texture();
    glActiveTexture(GL_TEXTURE3);
    glBindTexture(GL_TEXTURE_2D, texture_.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, opaque.width, opaque.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 opaque.rgba.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    if (GLEW_EXT_texture_filter_anisotropic) {
        GLfloat most = 1.0f;
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &most);
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, std::min(most, wanted_anisotropy));
    }
}

}  // namespace drapeau
