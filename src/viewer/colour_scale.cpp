#include "colour_scale.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace drapeau {

namespace {

using Table = std::array<std::uint32_t, std::tuple_size_v<ColourScale>>;  // sRGB

constexpr Table viridis{0x440154, 0x470d60, 0x48186a, 0x482374, 0x472d7b, 0x453681, 0x424086, 0x3f4989, 0x3b528b,
                        0x375a8d, 0x33638d, 0x2f6a8e, 0x2c728e, 0x297a8e, 0x26818e, 0x23898e, 0x21908c, 0x1f988b,
                        0x1f9f88, 0x21a685, 0x28ae80, 0x31b57b, 0x3ebc74, 0x4cc26c, 0x5dc963, 0x6ece58, 0x82d34c,
                        0x96d83f, 0xabdc32, 0xc0df24, 0xd5e21a, 0xeae51a, 0xfde725};
constexpr Table cool_to_warm{0x3b4cc0, 0x445acc, 0x4e68d7, 0x5875e1, 0x6282ea, 0x6c8ef1, 0x779af7, 0x82a5fb, 0x8db0fe,
                             0x98b9ff, 0xa3c2fe, 0xaec9fd, 0xb8d0f9, 0xc2d5f4, 0xccd9ee, 0xd5dbe6, 0xdddddd, 0xe5d8d1,
                             0xecd3c6, 0xf1ccb9, 0xf5c4ad, 0xf7bba0, 0xf7b194, 0xf7a687, 0xf49a7b, 0xf18d6f, 0xec7f63,
                             0xe57057, 0xde614c, 0xd55042, 0xcb3e38, 0xc0282f, 0xb40426};
constexpr glm::vec3 white(1.0f), red(0.80f, 0.0f, 0.015f);  // linear light

ColourScale read(const Table& table) {
    ColourScale scale{};
    std::transform(table.begin(), table.end(), scale.begin(), [](std::uint32_t color) {
        const auto channel = [&](int shift) { return as_linear(float((color >> shift) & 0xff) / 255.0f); };
        return glm::vec3(channel(16), channel(8), channel(0));
    });
    return scale;
}

ColourScale white_to_red() {
    ColourScale scale{};
    for (std::size_t i = 0; i < scale.size(); ++i) scale[i] = glm::mix(white, red, float(i) / float(scale.size() - 1));
    return scale;
}

}  // namespace

float as_srgb(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float as_linear(float srgb) {
    return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

const ColourScale& force_colours(Colours colours) {
    static const ColourScale plain = white_to_red(), safe = read(viridis);
    return colours == Colours::red ? plain : safe;
}

const ColourScale& stretch_colours(Colours colours) {
    static const ColourScale plain = read(cool_to_warm);
    return colours == Colours::red ? plain : force_colours(colours);
}

glm::vec3 colour_at(const ColourScale& scale, float share) {
    const float at = std::clamp(share, 0.0f, 1.0f) * float(scale.size() - 1);
    const auto below = std::min(std::size_t(at), scale.size() - 2);
    return glm::mix(scale[below], scale[below + 1], at - float(below));
}

}  // namespace drapeau
