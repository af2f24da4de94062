// Semi-implicit Euler, the report's method: v(t+dt) = v(t) + dt a(t), then x(t+dt) = x(t) + dt v(t+dt)   (eqs. 8 and 9;
// eq. 9 is printed without the dt that is meant).
//
// Order 1. Its positions are those of the Stoermer-Verlet method started half a kick off; without damping it conserves
// a shadow energy and needs dt^2 lambda_max < 4. Damping evaluated at the old velocity makes that limit smaller: for
// one mode with a = k dt^2/m and b = c dt/m it is a + 2b < 4.
#pragma once

#include "drapeau/method.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

struct SemiImplicitEuler : OneKick {
    static constexpr const char* name = "semi-implicit-euler";
    static constexpr int order = 1;
    using Looks = SemiImplicitEuler;
    static constexpr bool staggered = true;
    static constexpr double damping_weight = 2.0, on_mass_weight = 2.0;  // in the limit a + weight b < 4

    template <int pass, bool damped, class V, class Rate, class Real>
    DRAPEAU_INLINE static Motion<V> move(const Masses<V>& masses, const Vec3<V>& a, const Rate& rate, Real dt) {
        const auto v = masses.get(1);
        const auto all = resisted(a, rate, v), v_next = v + dt * all;
        masses.set(0, masses.get(0) + dt * v_next);
        masses.set(1, v_next);
        return {all, Real(0.5) * (v + v_next)};
    }

    static StableStep stable_step(const Oscillator& o) {
        return step_where(o.restoring(), 2.0 * (o.braking() + o.on_mass), 4.0 * o.mass);
    }
    /// The roots of z^2 - (2 - a - b) z + 1 - b.
    static double growth(const Oscillator& o, double dt) {
        const double a = dt * dt * o.restoring() / o.mass, b = dt * (o.braking() + o.on_mass) / o.mass;
        return larger_root(2.0 - a - b, 1.0 - b);
    }
};

/// Semi-implicit Euler started half a kick back and read half a kick ahead: without damping that is the Stoermer-Verlet
/// method, of order 2, for nothing. Damping is still seen at the old velocity, so with it the order stays 1, with a
/// smaller error.
struct HalfKickStart : SemiImplicitEuler {
    static constexpr bool starts_with_forces = true;

    template <bool damped, class Real>
    static void start(const Field<Real>* fields, std::ptrdiff_t n, const Vec3<Real>& a, Real rate, Real dt) {
        const Masses<Real> mass{fields, n};
        const auto v = mass.get(1);
        mass.set(1, v - (Real(0.5) * dt) * resisted(a, rate, v));
    }
    template <bool damped, class Real>
    static Vec3<Real> synchronised(const Field<Real>* fields, std::ptrdiff_t n, const Vec3<Real>& a, Real rate,
                                   Real dt) {
        const auto v = fields[1].template at<Real>(n);
        return v + (Real(0.5) * dt) * resisted(a, rate, v);
    }
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
