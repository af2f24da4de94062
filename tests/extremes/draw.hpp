// Draw: numbers drawn from a seed, in order; the same on every machine.
#pragma once

#include "drapeau/terms/wind.hpp"

#include <algorithm>
#include <cmath>

namespace drapeau::extremes {

struct Draw {
    std::uint64_t seed;
    std::uint64_t stream;
    int n = 0;

    double share() { return 0.5 * (1.0 + random_at(seed, stream, n++)); }  // from 0 to 1
    bool chance(double of) { return share() < of; }
    int one_of(int count) { return std::min(count - 1, static_cast<int>(count * share())); }
    /// A factor of at most so many decades up or down.
    double decades(double most) { return std::pow(10.0, most * (2.0 * share() - 1.0)); }
};

}  // namespace drapeau::extremes
