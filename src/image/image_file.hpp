// What an image file claims to be and whether it is whole: decoders fill the missing part of a short file with grey.
#pragma once

#include <cstdint>
#include <span>

namespace drapeau {

enum class ImageFormat { unknown, png, jpeg, bmp, gif };

ImageFormat image_format(std::span<const std::uint8_t> bytes);

/// False if the file plainly ends before its picture does. PNG needs no such look: its decoder notices.
bool looks_whole(ImageFormat format, std::span<const std::uint8_t> bytes);

}  // namespace drapeau
