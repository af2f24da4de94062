// Semi-implicit Euler, the report's method: v(t+dt) = v(t) + dt a(t), then x(t+dt) = x(t) + dt v(t+dt)   (eqs. 8 and 9;
// eq. 9 is printed without the dt that is meant).
//
// Order 1. Its positions are those of the Stoermer-Verlet method started half a kick off; without damping it conserves
// a shadow energy and needs dt^2 lambda_max < 4. Damping evaluated at the old velocity makes that limit smaller.
#pragma once

#include "drapeau/lanes.hpp"

namespace drapeau {

struct SemiImplicitEuler {
    static constexpr int order = 1;

    template <class V, class Real>
    DRAPEAU_INLINE static void move(Triple<V>& x, Triple<V>& v, const Triple<V>& a, Real dt) {
        v = v + dt * a;
        x = x + dt * v;
    }
};

}  // namespace drapeau
