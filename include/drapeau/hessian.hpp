// Hessian: how a spring's force changes with its ends, as further operations of the sweep: times a direction (for power
// iteration and conjugate gradients), and its own 3 x 3 block (for preconditioners).
//
//   -df = [A e e^T + B (I - e e^T)] (u_j - u_i)       elastic: A = k, B = k (1 - L/l); damper: A = c, B = 0
//
// B is negative where a spring is compressed: there the cloth buckles. Conjugate gradients need a positive matrix: made
// positive, B is |1 - L/l| k, but at most k times `stiffest_across`, which no configuration worth solving for exceeds.
// A damper's force also changes with e; that part is left out.
#pragma once

#include "drapeau/spring.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// Of a spring's stiffness, the most it is taken to resist sideways.
inline constexpr double stiffest_across = 10.0;

/// A direction instead of a velocity is read from the second field of a row.
template <class V>
struct SpringDirection {
    using Real = typename Lanes<V>::Real;
    using Row = SeenRow<Real>;
    using End = SpringEnd<V, true>;
    static constexpr int reach = 1;
};

/// The Hessian times a direction, its elastic and its damping part.
template <class V, bool damped>
struct SpringHessianParts : SpringDirection<V> {
    using typename SpringDirection<V>::Real;
    using typename SpringDirection<V>::End;
    using Value = Parts<V>;
    DRAPEAU_INLINE static Value react(const Value& sum, const Value& value) { return sum - value; }

    DRAPEAU_INLINE Value pull(const SpringRow<Real>& spring, int i, const End& a, const End& b) {
        using L = Lanes<V>;
        const auto d = b.x - a.x, u = b.v - a.v;
        const V r = inverse_length(d);
        const auto along = (r * (r * dot(d, u))) * d;
        const V across = L::load(spring.k + i) - r * L::load(spring.k_length + i);
        Value f{across * u + (r * L::load(spring.k_length + i)) * along, {}};
        if constexpr (damped) f.damping = L::load(spring.c + i) * along;
        return f;
    }
};

/// A and B of dt^2 times the elastic part and dt times the damper's, made positive or as they are.
template <class V, bool damped>
struct Weighted {
    using Real = typename Lanes<V>::Real;
    Real dt = 0;
    bool positive = true;

    DRAPEAU_INLINE void weigh(const SpringRow<Real>& spring, int i, V r, V& along, V& across) const {
        using L = Lanes<V>;
        const V k = (dt * dt) * L::load(spring.k + i);
        along = k;
        if constexpr (damped) along = along + dt * L::load(spring.c + i);
        across = k - r * ((dt * dt) * L::load(spring.k_length + i));
        if (positive) {
            const V most = static_cast<Real>(stiffest_across) * k;
            across = V{} - L::greater(V{} - most, V{} - L::greater(across, V{} - across));
        }
    }
};

/// The weighted Hessian times a direction.
template <class V, bool damped>
struct SpringHessian : SpringDirection<V>, Weighted<V, damped> {
    using Real = typename Lanes<V>::Real;
    using typename SpringDirection<V>::End;
    using Value = Vec3<V>;
    DRAPEAU_INLINE static Value react(const Value& sum, const Value& value) { return sum - value; }

    DRAPEAU_INLINE Value pull(const SpringRow<Real>& spring, int i, const End& a, const End& b) {
        const auto d = b.x - a.x, u = b.v - a.v;
        const V r = inverse_length(d);
        V along, across;
        this->weigh(spring, i, r, along, across);
        return across * u + ((along - across) * (r * (r * dot(d, u)))) * d;
    }
};

/// A symmetric 3 x 3 matrix of each mass: xx, yy, zz and yz, zx, xy.
template <class V>
struct Symmetric {
    Vec3<V> diagonal, off;

    DRAPEAU_INLINE Vec3<V> times(const Vec3<V>& u) const {
        return {diagonal.x * u.x + off.z * u.y + off.y * u.z, off.z * u.x + diagonal.y * u.y + off.x * u.z,
                off.y * u.x + off.x * u.y + diagonal.z * u.z};
    }
    /// By cofactors.
    DRAPEAU_INLINE Symmetric inverse() const {
        using Real = typename Lanes<V>::Real;
        const auto& d = diagonal;
        const auto& o = off;
        const Vec3<V> cd{d.y * d.z - o.x * o.x, d.x * d.z - o.y * o.y, d.x * d.y - o.z * o.z};
        const Vec3<V> co{o.y * o.z - o.x * d.x, o.x * o.z - o.y * d.y, o.x * o.y - o.z * d.z};
        const V inverse_determinant = Real(1) / (d.x * cd.x + o.z * co.z + o.y * co.y);
        return {inverse_determinant * cd, inverse_determinant * co};
    }
};
template <class V>
DRAPEAU_INLINE Symmetric<V> operator+(const Symmetric<V>& a, const Symmetric<V>& b) {
    return {a.diagonal + b.diagonal, a.off + b.off};
}
template <class V>
DRAPEAU_INLINE Symmetric<V> shifted(const Symmetric<V>& left, const Symmetric<V>& here) {
    return {shifted(left.diagonal, here.diagonal), shifted(left.off, here.off)};
}

/// The weighted Hessian's block of either end.
template <class V, bool damped>
struct SpringBlock : SpringDirection<V>, Weighted<V, damped> {
    using Real = typename Lanes<V>::Real;
    using End = SpringEnd<V, false>;
    using Value = Symmetric<V>;
    DRAPEAU_INLINE static Value react(const Value& sum, const Value& value) { return sum + value; }

    DRAPEAU_INLINE Value pull(const SpringRow<Real>& spring, int i, const End& a, const End& b) {
        const auto d = b.x - a.x;
        const V r = inverse_length(d);
        V along, across;
        this->weigh(spring, i, r, along, across);
        const Vec3<V> e = r * d;
        const V rest = along - across;
        return {{across + rest * (e.x * e.x), across + rest * (e.y * e.y), across + rest * (e.z * e.z)},
                {rest * (e.y * e.z), rest * (e.z * e.x), rest * (e.x * e.y)}};
    }
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
