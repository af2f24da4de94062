// A cloth's start state set, its result hashed and measured: what subjects that own a cloth share.
#pragma once

#include "subjects.hpp"

#include "drapeau/energy.hpp"

#include <bit>
#include <cmath>
#include <limits>

namespace drapeau::bench {

template <class Real>
void set_masses(Cloth<Real>& cloth, const Masses& masses, Attach attach) {
    const Grid& grid = cloth.grid();
    std::size_t n = 0;
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i, ++n) {
            cloth.set_position(i, j, masses.x[n]);
            cloth.set_velocity(i, j, is_attached(attach, grid, i, j) ? glm::dvec3(0.0) : masses.v[n]);
        }
}

template <class Real>
void copy_cloth(const Cloth<Real>& from, Cloth<Real>& to) {
    for (int c = 0; c < 6; ++c) std::copy(from.component(c).begin(), from.component(c).end(), to.component(c).begin());
}

inline std::uint64_t hash_of(std::uint64_t hash, const glm::dvec3& v) {
    for (int k = 0; k < 3; ++k) hash = mix(hash ^ std::bit_cast<std::uint64_t>(v[k]));
    return hash;
}

/// Of anything that tells position(i, j) and velocity(i, j).
template <class Flag>
std::uint64_t hash_of(const Flag& flag, const Grid& grid) {
    std::uint64_t hash = 0;
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) hash = hash_of(hash_of(hash, flag.position(i, j)), flag.velocity(i, j));
    return hash;
}

inline double stretch_if_finite(const Energy& energy) {
    return std::isfinite(energy.total()) ? energy.greatest_stretch : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace drapeau::bench
