// Start: where the masses begin (m), in double. Velocities begin at zero.
#pragma once

#include "drapeau/model.hpp"

#include <cmath>

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// Flat in its own plane, `prestretch` (share) longer than rest.
inline State<double> flat_start(const Grid& grid, double prestretch = 0.0) {
    State<double> state(grid.columns, grid.rows);
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) state.position.set(i, j, (1.0 + prestretch) * grid.rest(i, j));
    return state;
}

/// Folded at random like a flag out of a pocket: every row keeps its length along the fly but turns to and fro, by an
/// angle that is smooth noise of the place. Held masses stay where the flat flag has them.
inline State<double> crumpled_start(const Model& model, double prestretch, std::uint64_t seed) {
    constexpr double folds_per_metre = 6.0, max_angle = 1.1;  // rad, before the noise's own size
    constexpr double slant = 1.5;                             // folds drift along the fly, per metre down
    const Grid& grid = model.grid;
    auto state = flat_start(grid, prestretch);
    for (int j = 0; j < grid.rows; ++j) {
        glm::dvec3 place = state.position.at(0, j);
        const double down = j * grid.pitch_y;
        for (int i = 0; i < grid.columns; ++i) {
            if (i > 0) {
                const double along = (i - 0.5) * grid.pitch_x;
                const double turn = max_angle * smooth_noise(seed, 100, folds_per_metre * along + slant * down) +
                                    0.4 * smooth_noise(seed, 101, 3.0 * folds_per_metre * along - slant * down);
                const double step = (1.0 + prestretch) * grid.pitch_x;
                place += step * glm::dvec3{std::cos(turn), 0.0, std::sin(turn)};
            }
            if (!model.held(i, j)) state.position.set(i, j, place);
        }
    }
    if (grid.columns == 1)  // a hanging chain folds sideways instead
        for (int j = 1; j < grid.rows; ++j)
            if (!model.held(0, j))
                state.position.set(0, j,
                                   state.position.at(0, j) +
                                       glm::dvec3(0.0, 0.0, 0.3 * grid.pitch_y * smooth_noise(seed, 102, 0.7 * j)));
    return state;
}

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
