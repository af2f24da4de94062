// Small image files, as they are and made worse.
#pragma once

#include "catch.hpp"

#include "image/image_file.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace drapeau::testing {

using FileBytes = std::vector<std::uint8_t>;

/// A file of tests/inputs.
FileBytes sample(const std::string& name);
FileBytes bytes_of(std::string_view text);
FileBytes first(const FileBytes& bytes, std::size_t count);

/// The message of the InputError that `action` throws; empty if it throws none.
std::string message_of(const std::function<void()>& action);
inline std::string error_of(const FileBytes& bytes) {
    return message_of([&] { decode_image(bytes); });
}
inline bool says(const std::string& message, std::string_view part) {
    UNSCOPED_INFO(message);
    return message.find(part) != message.npos;
}

struct Rgba {
    int red, green, blue, alpha;
};

/// Whether that pixel is this colour, every channel to within `tolerance`.
bool is_like(const Image& image, int column, int row, Rgba colour, int tolerance);

// The quarters of the samples that are named so, and what lossy formats may make of a channel.
inline constexpr Rgba red{220, 20, 30, 255}, green{20, 200, 40, 255}, blue{10, 60, 160, 255}, white{250, 250, 250, 255};
inline constexpr int lossy = 12;

/// Whether the pixels in the corners have these colours.
bool has_corners(const Image& image, Rgba top_left, Rgba top_right, Rgba bottom_left, Rgba bottom_right, int tolerance);
inline bool has_quarters(const Image& image, int tolerance) {
    return has_corners(image, red, green, blue, white, tolerance);
}

}  // namespace drapeau::testing
