// Image: a picture as 8-bit RGBA rows, top row first, whatever the file held (grey, 16 bits, a palette, no alpha).
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace drapeau {

struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;  // width * height * 4, sRGB, alpha not premultiplied
};

inline constexpr int largest_image_side = 16384;  // pixels; larger files are refused before anything is decoded
inline constexpr int largest_kept_side = 4096;    // pixels; larger images are averaged down, a flag shows no more

/// Reads a PNG, JPEG, BMP or GIF. Throws InputError naming the file and what is wrong with it.
Image load_image(const std::filesystem::path& file);

/// The image averaged over whole blocks until no side is longer than `side`.
Image shrunk_to(Image image, int side);

/// Writes a PNG, whole or not at all. Throws InputError if it cannot be written.
void write_png(const std::filesystem::path& file, const Image& image);

}  // namespace drapeau
