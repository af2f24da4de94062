// Spring: what one spring does to the mass it starts at; the mass it ends at feels the opposite.
//
//   f = [k (l - L) + c (v_j - v_i) . e] e        d = x_j - x_i, l = |d|, e = d / l     (report, eqs. 5 and 6)
//
// Damping acts on the relative velocity along the spring: the only form whose reaction is opposite and that leaves a
// rotating flag alone.
//
// These are the operations of the sweep: an operation says what it reads at either end (Row, End), what it makes of a
// spring (Value), what that means to its other end (react) and how many rows away it looks (reach).
#pragma once

#include "drapeau/field.hpp"
#include "drapeau/isa.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// A spring this short (m) has no direction: its force fades to zero there instead of becoming NaN.
inline constexpr double shortest_length = 1e-15;

/// l^2 from d, never below the shortest.
template <class V>
DRAPEAU_INLINE V squared_length(const Vec3<V>& d) {
    constexpr auto floor = static_cast<typename Lanes<V>::Real>(shortest_length * shortest_length);
    return d.x * d.x + (d.y * d.y + (d.z * d.z + floor));
}
/// 1/l from d, and the force over d without damping: with r = 1/l it is k - r k L.
template <class V>
DRAPEAU_INLINE V inverse_length(const Vec3<V>& d) {
    return inverse_sqrt<V>(squared_length(d));
}

/// What a row of masses shows to its springs.
template <class Real>
struct SeenRow {
    Field<const Real> position, velocity;
};

/// One end of a spring. Without damping no velocity is read.
template <class V, bool damped>
struct SpringEnd {
    Vec3<V> x, v;
    DRAPEAU_INLINE static SpringEnd load(const SeenRow<typename Lanes<V>::Real>& row, int i) {
        return {row.position.template at<V>(i), row.velocity.template at<V>(i)};
    }
};
template <class V>
struct SpringEnd<V, false> {
    Vec3<V> x;
    DRAPEAU_INLINE static SpringEnd load(const SeenRow<typename Lanes<V>::Real>& row, int i) {
        return {row.position.template at<V>(i)};
    }
};

/// The force, as one sum: f = [k + r (c r (dv . d) - k L)] d.
template <class V, bool damped>
struct SpringForce {
    using Real = typename Lanes<V>::Real;
    using Row = SeenRow<Real>;
    using End = SpringEnd<V, damped>;
    using Value = Vec3<V>;
    static constexpr int reach = 1;
    /// The sum of what a mass has so far and what a spring does to it that pulls its other end with `value`.
    DRAPEAU_INLINE static Value react(const Value& sum, const Value& value) { return sum - value; }

    DRAPEAU_INLINE Value pull(const SpringRow<Real>& spring, int i, const End& a, const End& b) {
        using L = Lanes<V>;
        const auto d = b.x - a.x;
        const V r = inverse_length(d);
        V tension_over_r = L::broadcast(0);
        if constexpr (damped) tension_over_r = (L::load(spring.c + i) * r) * dot(b.v - a.v, d);
        tension_over_r = tension_over_r - L::load(spring.k_length + i);
        return (L::load(spring.k + i) + r * tension_over_r) * d;
    }
};

/// A force in its two parts, so that the work of each can be told.
template <class V>
struct Parts {
    Vec3<V> elastic, damping;
};
template <class V>
DRAPEAU_INLINE Parts<V> operator+(const Parts<V>& a, const Parts<V>& b) {
    return {a.elastic + b.elastic, a.damping + b.damping};
}
template <class V>
DRAPEAU_INLINE Parts<V> operator-(const Parts<V>& a, const Parts<V>& b) {
    return {a.elastic - b.elastic, a.damping - b.damping};
}
template <class V>
DRAPEAU_INLINE Parts<V> shifted(const Parts<V>& left, const Parts<V>& here) {
    return {shifted(left.elastic, here.elastic), shifted(left.damping, here.damping)};
}

/// The force in parts.
template <class V, bool damped>
struct SpringForceParts : SpringForce<V, damped> {
    using typename SpringForce<V, damped>::Real;
    using typename SpringForce<V, damped>::End;
    using Value = Parts<V>;
    DRAPEAU_INLINE static Value react(const Value& sum, const Value& value) { return sum - value; }

    DRAPEAU_INLINE Value pull(const SpringRow<Real>& spring, int i, const End& a, const End& b) {
        const auto d = b.x - a.x;
        return parts(spring, i, a, b, d, inverse_length(d));
    }

protected:
    DRAPEAU_INLINE static Value parts(const SpringRow<Real>& spring, int i, const End& a, const End& b,
                                      const Vec3<V>& d, V r) {
        using L = Lanes<V>;
        Value f{(L::load(spring.k + i) - r * L::load(spring.k_length + i)) * d, {}};
        if constexpr (damped) f.damping = (r * ((L::load(spring.c + i) * r) * dot(b.v - a.v, d))) * d;
        return f;
    }
};

/// The force in parts, and what a row of springs holds, summed in lanes.
template <class V, bool damped>
struct SpringGauge : SpringForceParts<V, damped> {
    using typename SpringForceParts<V, damped>::Real;
    using typename SpringForceParts<V, damped>::End;
    using typename SpringForceParts<V, damped>::Value;
    V elastic{}, stretch{}, max_stretch = Lanes<V>::broadcast(-1), max_force{}, force_squares{};

    DRAPEAU_INLINE Value pull(const SpringRow<Real>& spring, int i, const End& a, const End& b) {
        using L = Lanes<V>;
        const auto d = b.x - a.x;
        const V k = L::load(spring.k + i), square = squared_length(d), r = inverse_sqrt<V>(square);
        const V longer = L::where_positive(k, square * r - spring.length);
        const V size = L::greater(longer, V{} - longer), inverse = L::broadcast(Real(1) / spring.length);
        elastic = elastic + (Real(0.5) * k) * (longer * longer);
        stretch = stretch + size * inverse;
        max_force = L::greater(max_force, k * size);
        force_squares = force_squares + (k * size) * (k * size);
        // Where there is no spring the share is that of the shortest one, -1.
        max_stretch = L::greater(max_stretch, L::where_positive(k, longer * inverse + Real(1)) - Real(1));
        return SpringForceParts<V, damped>::parts(spring, i, a, b, d, r);
    }
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
