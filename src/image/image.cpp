#include "image/image.hpp"

#include "io/error.hpp"
#include "io/output_file.hpp"

#include <stb_image_write.h>

#include <algorithm>
#include <array>
#include <string>

namespace drapeau {

namespace {

void append_bytes(void* into, void* data, int size) {
    auto& bytes = *static_cast<std::vector<char>*>(into);
    bytes.insert(bytes.end(), static_cast<char*>(data), static_cast<char*>(data) + size);
}

// Block sums of alpha and of colour times alpha; blocks are at most 2^16 pixels a side, so 64 bits suffice.
void average(const Image& image, int x0, int y0, int x1, int y1, std::uint8_t* to) {
    std::uint64_t alpha = 0;
    std::array<std::uint64_t, 3> colour{};
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
            const std::uint8_t* const from = image.pixel(x, y);
            alpha += from[3];
            for (std::size_t channel = 0; channel < 3; ++channel)
                colour[channel] += std::uint64_t(from[channel]) * from[3];
        }
    if (alpha == 0) return;
    const auto count = std::uint64_t(x1 - x0) * std::uint64_t(y1 - y0);
    for (std::size_t channel = 0; channel < 3; ++channel)
        to[channel] = std::uint8_t((colour[channel] + alpha / 2) / alpha);
    to[3] = std::uint8_t((alpha + count / 2) / count);
}

}  // namespace

Image blank_image(int width, int height) {
    Image image{.width = width, .height = height, .rgba = {}};
    image.rgba.resize(std::size_t(width) * std::size_t(height) * 4);
    return image;
}

Image shrunk_to(Image image, int side) {
    const int factor = (std::max(image.width, image.height) - 1) / side + 1;
    if (factor <= 1) return image;
    Image small = blank_image(std::max(1, image.width / factor), std::max(1, image.height / factor));
    for (int row = 0; row < small.height; ++row)
        for (int column = 0; column < small.width; ++column) {
            const int x = column * factor, y = row * factor;
            average(image, x, y, std::min(image.width, x + factor), std::min(image.height, y + factor),
                    small.pixel(column, row));
        }
    return small;
}

bool has_holes(const Image& image) {
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
        if (image.rgba[i] < 128) return true;
    return false;
}

Image turned(Image image, int orientation) {
    if (orientation < 2 || orientation > 8) return image;
    const bool transposed = orientation >= 5;
    const bool from_right = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool from_below = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    Image upright = transposed ? blank_image(image.height, image.width) : blank_image(image.width, image.height);
    for (int row = 0; row < upright.height; ++row)
        for (int column = 0; column < upright.width; ++column) {
            const int x = transposed ? row : column, y = transposed ? column : row;
            const std::uint8_t* const from =
                image.pixel(from_right ? image.width - 1 - x : x, from_below ? image.height - 1 - y : y);
            std::copy_n(from, 4, upright.pixel(column, row));
        }
    return upright;
}

void write_png(const std::filesystem::path& file, const Image& image) {
    std::vector<char> bytes;
    if (!stbi_write_png_to_func(append_bytes, &bytes, image.width, image.height, 4, image.rgba.data(), image.width * 4))
        throw InputError(file.string() + ": the picture could not be encoded");
    write_file(file.string(), [&](const Append& append) { append({bytes.data(), bytes.size()}); });
}

}  // namespace drapeau
