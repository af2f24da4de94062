// Quality: how good a run is, by what it is like on average against a run that is known to be right.
//
// Good: mean energy and mean 99th percentile of stretch stay within 20 %. Garbage: they are off by more than a factor
// of two, or not finite. In between is neither. Motion is chaotic, so means over the run are compared, and energies
// only above a floor.
#pragma once

#include "drapeau/state.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace drapeau::testing {

struct Means {
    double energy = 0.0, stretch = 0.0;  // J; share, of the 99th percentile

    bool is_finite() const { return std::isfinite(energy) && std::isfinite(stretch); }
};

/// The 99th percentile of l/L over the structural springs.
inline double percentile_99(const State<double>& state, const Grid& grid) {
    std::vector<double> all;
    const auto look = [&](int i, int j, int i2, int j2, double rest) {
        const auto d = state.position.at(i2, j2) - state.position.at(i, j);
        all.push_back(std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z) / rest);
    };
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            if (i + 1 < grid.columns) look(i, j, i + 1, j, grid.pitch_x);
            if (j + 1 < grid.rows) look(i, j, i, j + 1, grid.pitch_y);
        }
    const auto at = all.begin() + static_cast<std::ptrdiff_t>(all.size() * 99 / 100);
    std::nth_element(all.begin(), at, all.end());
    return *at;
}

enum class Kind { good, between, garbage };

/// `floor` (J): energies below it tell nothing; `shortest`: nor do stretches below it (share).
inline Kind kind_of(const Means& run, const Means& reference, double floor, double shortest = 0.0) {
    if (!run.is_finite()) return Kind::garbage;
    const double energy = (run.energy + floor) / (reference.energy + floor),
                 stretch = (run.stretch + shortest) / (reference.stretch + shortest);
    const auto off_by = [](double ratio, double by) { return ratio > by || ratio < 1.0 / by; };
    if (off_by(energy, 2.0) || off_by(stretch, 2.0)) return Kind::garbage;
    return std::abs(energy - 1.0) < 0.2 && std::abs(stretch - 1.0) < 0.2 ? Kind::good : Kind::between;
}

}  // namespace drapeau::testing
