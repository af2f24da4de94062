// Peaks: what one core of this machine can do at most, measured, in the widest registers the kernels are compiled for.
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace drapeau::bench {

/// A level of memory. Bandwidths count every byte read and every byte written, in bytes a nanosecond (GB/s).
struct Level {
    std::string name;
    std::size_t bytes;    // what it holds; the last level holds anything
    double load = 0.0;    // reading
    double update = 0.0;  // reading and writing the same place, as a step does with the state
    double copy = 0.0;    // memcpy
};

struct Peaks {
    double multiply_adds[2];    // a nanosecond, lanes counted one by one; float, double
    std::vector<Level> levels;  // nearest first

    double multiply_adds_of(Precision precision) const { return multiply_adds[static_cast<int>(precision)]; }
    /// Where in `levels` a state of so many bytes fits.
    std::size_t level_of(std::size_t bytes) const;
};

Peaks measure_peaks();

}  // namespace drapeau::bench
