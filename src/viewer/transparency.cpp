#include "transparency.hpp"

#include <algorithm>
#include <cmath>

namespace drapeau {

namespace {

double linear(double srgb) {
    return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}
double srgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

}  // namespace

Image unpremultiplied(Image picture) {
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
        const std::uint8_t alpha = picture.rgba[i + 3];
        if (alpha == 255) continue;
        for (std::size_t c = i; c < i + 3; ++c) {
            const double light = alpha == 0 ? 0.0 : linear(picture.rgba[c] / 255.0) * 255.0 / alpha;
            picture.rgba[c] = std::uint8_t(std::lround(255.0 * srgb(std::min(1.0, light))));
        }
    }
    return picture;
}

}  // namespace drapeau
