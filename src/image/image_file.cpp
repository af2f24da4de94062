#include "image_file.hpp"

#include <cstddef>
#include <initializer_list>

namespace drapeau {

namespace {

using Bytes = std::span<const std::uint8_t>;

bool begins_with(Bytes bytes, std::initializer_list<int> magic) {
    if (bytes.size() < magic.size()) return false;
    std::size_t at = 0;
    for (const int value : magic)
        if (bytes[at++] != value) return false;
    return true;
}

std::uint32_t little_endian(Bytes bytes, std::size_t at, int count) {
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i) value |= std::uint32_t(bytes[at + std::size_t(i)]) << (8 * i);
    return value;
}

// Within the coded data of a JPEG neither the marker that starts a scan nor the one that ends the image can occur.
bool jpeg_ends(Bytes bytes) {
    for (std::size_t i = bytes.size() - 1; i-- > 0;) {
        if (bytes[i] != 0xff) continue;
        if (bytes[i + 1] == 0xd9) return true;
        if (bytes[i + 1] == 0xda) return false;
    }
    return false;
}

// Rows of an uncompressed BMP are padded to four bytes.
bool bmp_rows_fit(Bytes bytes) {
    if (bytes.size() < 34) return false;
    if (little_endian(bytes, 14, 4) < 40) return true;  // the oldest headers: left to the decoder
    const auto width = std::int64_t(std::int32_t(little_endian(bytes, 18, 4)));
    auto height = std::int64_t(std::int32_t(little_endian(bytes, 22, 4)));
    if (height < 0) height = -height;
    const std::int64_t bits = little_endian(bytes, 28, 2);
    const std::int64_t rows_at = little_endian(bytes, 10, 4);
    return rows_at + (width * bits + 31) / 32 * 4 * height <= std::int64_t(bytes.size());
}

bool gif_ends(Bytes bytes) {
    std::size_t end = bytes.size();
    while (end > 0 && bytes[end - 1] == 0) --end;
    return end > 0 && bytes[end - 1] == 0x3b;
}

}  // namespace

ImageFormat image_format(Bytes bytes) {
    if (begins_with(bytes, {0x89, 'P', 'N', 'G', 0x0d, 0x0a, 0x1a, 0x0a})) return ImageFormat::png;
    if (begins_with(bytes, {0xff, 0xd8, 0xff})) return ImageFormat::jpeg;
    if (begins_with(bytes, {'B', 'M'})) return ImageFormat::bmp;
    if (begins_with(bytes, {'G', 'I', 'F', '8'})) return ImageFormat::gif;
    return ImageFormat::unknown;
}

bool looks_whole(ImageFormat format, Bytes bytes) {
    switch (format) {
        case ImageFormat::jpeg:
            return jpeg_ends(bytes);
        case ImageFormat::bmp:
            return bmp_rows_fit(bytes);
        case ImageFormat::gif:
            return gif_ends(bytes);
        case ImageFormat::png:
        case ImageFormat::unknown:
            return true;
    }
    return true;
}

}  // namespace drapeau
