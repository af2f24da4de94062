// The orientation a camera noted in a JPEG's EXIF segment.
// Source: TIFF 6.0, section 2 (file structure); Exif 2.32, section 4.6 (tag 0x0112).
#pragma once

#include <cstdint>
#include <span>

namespace drapeau {

/// 1 to 8 as for turned(); 1 if the segment (which begins "Exif") states none or is damaged.
int exif_orientation(std::span<const std::uint8_t> segment);

}  // namespace drapeau
