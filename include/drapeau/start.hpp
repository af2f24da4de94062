// Start: where the masses begin (m), in double, row by row. Velocities begin at zero.
#pragma once

#include "drapeau/model.hpp"
#include "drapeau/terms/wind.hpp"

#include <cmath>
#include <vector>

namespace drapeau {

/// Flat in its own plane, `prestretch` (share) longer than rest.
inline std::vector<glm::dvec3> flat_start(const Grid& grid, double prestretch) {
    std::vector<glm::dvec3> x;
    x.reserve(static_cast<std::size_t>(grid.masses()));
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) x.push_back((1.0 + prestretch) * grid.rest(i, j));
    return x;
}

/// Folded at random like a flag out of a pocket: every row keeps its length along the fly but turns to and fro, by an
/// angle that is smooth noise of the place. Attached masses stay where the flat flag has them.
inline std::vector<glm::dvec3> crumpled_start(const Grid& grid, double prestretch, Attach attach, std::uint64_t seed) {
    constexpr double folds_per_metre = 6.0, greatest_angle = 1.1;  // rad, before the noise's own size
    constexpr double slant = 1.5;                                  // folds drift along the fly, per metre down
    auto x = flat_start(grid, prestretch);
    for (int j = 0; j < grid.rows; ++j) {
        glm::dvec3 place = x[static_cast<std::size_t>(j) * grid.columns];
        const double down = j * grid.pitch_y;
        for (int i = 0; i < grid.columns; ++i) {
            if (i > 0) {
                const double along = (i - 0.5) * grid.pitch_x;
                const double turn = greatest_angle * smooth_noise(seed, 100, folds_per_metre * along + slant * down) +
                                    0.4 * smooth_noise(seed, 101, 3.0 * folds_per_metre * along - slant * down);
                const double step = (1.0 + prestretch) * grid.pitch_x;
                place += step * glm::dvec3{std::cos(turn), 0.0, std::sin(turn)};
            }
            if (!is_attached(attach, grid, i, j)) x[static_cast<std::size_t>(j) * grid.columns + i] = place;
        }
    }
    if (grid.columns == 1)  // a hanging chain folds sideways instead
        for (int j = 1; j < grid.rows; ++j)
            if (!is_attached(attach, grid, 0, j)) x[j].z += 0.3 * grid.pitch_y * smooth_noise(seed, 102, 0.7 * j);
    return x;
}

}  // namespace drapeau
