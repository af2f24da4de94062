// A result hashed and measured: what subjects of this program and those compiled for this machine share.
#pragma once

#include "drapeau/energy.hpp"
#include "drapeau/state.hpp"
#include "drapeau/terms/wind.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace drapeau::bench {
inline namespace DRAPEAU_ISA {

template <class Real>
std::uint64_t hash_of(std::uint64_t hash, const FieldBuffer<Real>& field) {
    for (int j = 0; j < field.rows(); ++j)
        for (int i = 0; i < field.columns(); ++i) {
            const glm::dvec3 value = field.at(i, j);
            for (int c = 0; c < 3; ++c) hash = mix(hash ^ std::bit_cast<std::uint64_t>(value[c]));
        }
    return hash;
}
template <class Real>
std::uint64_t hash_of(const State<Real>& state) {
    return hash_of(hash_of(0, state.position), state.velocity);
}

inline double stretch_if_finite(const Measurement& here) {
    return std::isfinite(here.total()) ? here.max_stretch : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace DRAPEAU_ISA
}  // namespace drapeau::bench
