// Energy, stretch and sanity of a cloth, in double whatever the cloth's precision.
#pragma once

#include "drapeau/fabric.hpp"

#include <cmath>

namespace drapeau {

/// Calls visit(i, j, i2, j2, k, L) for every spring, once: ends (i, j) and (i2, j2), stiffness N/m, rest length m.
template <class Visit>
void for_each_spring(const Grid& grid, const Material& material, Visit&& visit) {
    const double k = material.stiffness;
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            const bool right = i + 1 < grid.columns, down = j + 1 < grid.rows;
            if (right) visit(i, j, i + 1, j, k, grid.pitch_x);
            if (down) visit(i, j, i, j + 1, k, grid.pitch_y);
            if (right && down && material.diagonal_stiffness) {
                visit(i, j, i + 1, j + 1, *material.diagonal_stiffness, grid.pitch_diagonal());
                visit(i + 1, j, i, j + 1, *material.diagonal_stiffness, grid.pitch_diagonal());
            }
        }
}

/// What a cloth holds at one instant. Attached masses do not move and count for nothing in kinetic energy.
struct Energy {
    double kinetic = 0.0;           // J, sum of m v^2 / 2
    double spring = 0.0;            // J, sum of k (l - L)^2 / 2
    double greatest_stretch = 0.0;  // share, max (l - L) / L; negative where every spring is compressed
    double mean_stretch = 0.0;      // share, mean |l - L| / L
    double greatest_force = 0.0;    // N, max |k (l - L)|

    double total() const { return kinetic + spring; }
};

template <class Real>
Energy measure(const Cloth<Real>& cloth, const Material& material) {
    Energy energy;
    const Grid& grid = cloth.grid();
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            const auto v = cloth.velocity(i, j);
            energy.kinetic += 0.5 * material.mass * (v.x * v.x + v.y * v.y + v.z * v.z);
        }
    long long springs = 0;
    double stretch = -1.0;
    for_each_spring(grid, material, [&](int i, int j, int i2, int j2, double k, double length) {
        const auto d = cloth.position(i2, j2) - cloth.position(i, j);
        const double longer = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z) - length;
        energy.spring += 0.5 * k * longer * longer;
        energy.greatest_force = std::max(energy.greatest_force, std::abs(k * longer));
        energy.mean_stretch += std::abs(longer) / length;
        stretch = std::max(stretch, longer / length);
        ++springs;
    });
    energy.greatest_stretch = springs ? stretch : 0.0;
    if (springs) energy.mean_stretch /= static_cast<double>(springs);
    return energy;
}

/// Sum of k L^2 over the springs (J): the scale of the elastic energy there is room for.
inline double elastic_scale(const Grid& grid, const Material& material) {
    double sum = 0.0;
    for_each_spring(grid, material, [&](int, int, int, int, double k, double length) { sum += k * length * length; });
    return sum;
}

/// A run has diverged when a value is not finite or its energy exceeds 100 times all it could have.
inline bool has_diverged(const Energy& now, double energy_it_could_have) {
    return !(now.total() <= 100.0 * energy_it_could_have);  // also true for NaN
}

}  // namespace drapeau
