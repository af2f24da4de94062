// Lengths: distances and errors as the tables show them.
#pragma once

#include "io/text.hpp"

#include <cmath>
#include <string>

namespace drapeau::lab {

/// "1.2 mm"; "-" for what is not known.
inline std::string metres(double value) {
    constexpr double least = 1e-12;  // no unit is smaller
    if (value > 0.0 && value < least) return "< 0.001 nm";
    return std::isfinite(value) ? quantity(value, "m") : "-";
}

}  // namespace drapeau::lab
