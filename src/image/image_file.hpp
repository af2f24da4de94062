// Image files: PNG, JPEG, WebP, SVG, GIF and BMP, known by their content. Of a moving picture the first frame is read.
// What browsers show is read, also with its end marker missing or other data behind it.
#pragma once

#include "image/image.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stop_token>

namespace drapeau {

// What decoding takes, the file itself and the smaller image made of it not counted: what needs more is not begun.
inline constexpr std::size_t largest_decoding_memory = 512u << 20;  // bytes
inline constexpr std::uintmax_t largest_image_file = 256u << 20;    // bytes
inline constexpr int largest_kept_side = 4096;  // pixels; larger images are averaged down, a flag shows no more
inline constexpr int svg_longest_side = 2048;   // pixels; an SVG has no pixels of its own

/// Thrown where nobody wants the image any more.
struct Abandoned {};

/// Throws InputError naming the file and what is wrong with it, also when memory runs out. Throws Abandoned soon after
/// `stop` is asked to stop.
Image load_image(const std::filesystem::path& file, const std::stop_token& stop = {});

/// The same for a file's bytes; the error does not name the file. Throws std::bad_alloc too.
Image decode_image(std::span<const std::uint8_t> bytes, const std::stop_token& stop = {});

}  // namespace drapeau
