// Image: a picture as 8-bit RGBA rows, top row first, whatever the file held (grey, 16 bits, a palette, no alpha).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace drapeau {

struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;  // width * height * 4, sRGB, alpha not premultiplied

    std::uint8_t* pixel(int column, int row) {
        return rgba.data() + (std::size_t(row) * std::size_t(width) + std::size_t(column)) * 4;
    }
    const std::uint8_t* pixel(int column, int row) const { return const_cast<Image*>(this)->pixel(column, row); }
};

/// Every pixel transparent black. Throws std::bad_alloc.
Image blank_image(int width, int height);

/// The image averaged over whole blocks until no side is longer than `side`. Colours count by their alpha: what is
/// transparent has no colour to give.
Image shrunk_to(Image image, int side);

/// Whether some pixel is more transparent than opaque.
bool has_holes(const Image& image);

/// The image as it is meant to be seen, by its EXIF orientation: 1 to 8; anything else leaves it as it is.
Image turned(Image image, int orientation);

/// Writes a PNG, whole or not at all. Throws InputError if it cannot be written.
void write_png(const std::filesystem::path& file, const Image& image);

}  // namespace drapeau
