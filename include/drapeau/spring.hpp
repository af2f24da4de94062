// Spring: the pull of one spring on the mass it starts at; the mass it ends at feels the opposite.
//
//   f = [k (l - L) + c (v_j - v_i) . e] e        d = x_j - x_i, l = |d|, e = d / l     (report, eqs. 5 and 6)
//
// Damping acts on the relative velocity along the spring: the only form whose reaction is opposite and that leaves a
// rotating flag alone.
#pragma once

#include "drapeau/lanes.hpp"

namespace drapeau {

/// Springs that run alike from every mass of a row, as row-long arrays: element i is the spring that starts at column
/// i. All three are zero where there is none (past the last column).
template <class Real>
struct SpringRow {
    const Real* k;         // N/m
    const Real* k_length;  // k L, N: the stiffness times the rest length
    const Real* c;         // N s/m; not read without damping
};

/// A spring this short (m) has no direction: its force fades to zero there instead of becoming NaN.
inline constexpr double shortest_length = 1e-15;

/// The pair operation of the sweep. With r = 1/l the force is  f = [k + r (c r (dv . d) - k L)] d.
template <bool damped>
struct SpringForce {
    static constexpr bool uses_velocity = damped;

    template <class V, class RelativeVelocity>
    DRAPEAU_INLINE static Triple<V> pull(const SpringRow<typename Lanes<V>::Real>& spring, int i, const Triple<V>& d,
                                         [[maybe_unused]] const RelativeVelocity& dv) {
        using L = Lanes<V>;
        constexpr auto floor = static_cast<typename L::Real>(shortest_length * shortest_length);

        const V r = inverse_sqrt<V>(d.x * d.x + (d.y * d.y + (d.z * d.z + floor)));
        V tension_over_r = L::broadcast(0);
        if constexpr (damped) tension_over_r = (L::load(spring.c + i) * r) * dot(dv, d);
        tension_over_r = tension_over_r - L::load(spring.k_length + i);
        return (L::load(spring.k + i) + r * tension_over_r) * d;
    }
};

}  // namespace drapeau
