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
    static constexpr bool staggered = true;

    template <int pass, bool damped, class V, class Rate, class Real>
    DRAPEAU_INLINE static Motion<V> move(const Masses<V>& masses, const Vec3<V>& a, const Rate& rate, Real dt) {
        const auto v = masses.get(1);
        const auto all = resisted(a, rate, v), v_next = v + dt * all;
        masses.set(0, masses.get(0) + dt * v_next);
        masses.set(1, v_next);
        return {all, Real(0.5) * (v + v_next)};
    }

    static StableStep stable_step(const Oscillator& o) {
        return step_where(o.stiffness, 2.0 * (o.damping + o.on_mass), 4.0 * o.mass);
    }
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
