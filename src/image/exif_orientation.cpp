#include "image/exif_orientation.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace drapeau {

namespace {

struct Tiff {
    std::span<const std::uint8_t> bytes;
    bool little_endian = false;

    // Zero beyond the end, which no field looked for here may be.
    std::uint32_t number(std::uint64_t at, unsigned size) const {
        if (at + size > bytes.size()) return 0;
        std::uint32_t value = 0;
        for (unsigned i = 0; i < size; ++i)
            value = value << 8 | bytes[std::size_t(at + (little_endian ? size - 1 - i : i))];
        return value;
    }
};

}  // namespace

int exif_orientation(std::span<const std::uint8_t> segment) {
    constexpr std::string_view exif("Exif\0\0", 6);
    if (segment.size() < exif.size() || !std::equal(exif.begin(), exif.end(), segment.begin())) return 1;
    Tiff tiff{.bytes = segment.subspan(exif.size())};
    tiff.little_endian = tiff.number(0, 2) == 0x4949;  // "II"; else "MM"
    if (tiff.number(2, 2) != 42) return 1;

    // The first directory: a count and entries of 12 bytes: tag, type, number of values, value.
    constexpr std::uint32_t orientation_tag = 0x0112, short_type = 3;
    const std::uint64_t directory = tiff.number(4, 4);
    const std::uint32_t count = tiff.number(directory, 2);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint64_t entry = directory + 2 + 12 * std::uint64_t(i);
        if (tiff.number(entry, 2) != orientation_tag || tiff.number(entry + 2, 2) != short_type) continue;
        const std::uint32_t value = tiff.number(entry + 8, 2);
        return value >= 1 && value <= 8 ? int(value) : 1;
    }
    return 1;
}

}  // namespace drapeau
