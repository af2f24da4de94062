#include "flag_texture.hpp"

#include "software_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drapeau {

namespace {

constexpr float wanted_anisotropy = 8.0f;

double linear(double srgb) {
    return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}
double srgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

/// Light, not its sRGB code, is what alpha takes a share of.
Image multiplied_by_alpha(Image image) {
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        const std::uint8_t alpha = image.rgba[i + 3];
        for (std::size_t c = i; c < i + 3 && alpha < 255; ++c)
            image.rgba[c] = std::uint8_t(std::lround(255.0 * srgb(linear(image.rgba[c] / 255.0) * alpha / 255.0)));
    }
    return image;
}

}  // namespace

void FlagTexture::clear() {
    texture_ = GlTexture();
    has_holes_ = false;
}

void FlagTexture::load(Image image) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    const Image shown = multiplied_by_alpha(shrunk_to(std::move(image), int(largest)));
    has_holes_ = drapeau::has_holes(shown);

    texture_ = make_texture();
    glActiveTexture(GL_TEXTURE3);
    glBindTexture(GL_TEXTURE_2D, texture_.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, shown.width, shown.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 shown.rgba.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    // Mesa's software renderer (22.3) never ends the loop of its anisotropic filter where a triangle is seen almost
    // edge-on.
    if (GLEW_EXT_texture_filter_anisotropic && !drawn_by_llvmpipe()) {
        GLfloat most = 1.0f;
        glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &most);
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, std::min(most, wanted_anisotropy));
    }
}

}  // namespace drapeau
