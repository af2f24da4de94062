// Forward Euler, the classic explicit method: x(t+dt) = x(t) + dt v(t), v(t+dt) = v(t) + dt a(t).
//
// Order 1. It acts like semi-implicit Euler with the damping of every spring lowered by k dt, so an undamped spring
// gains energy at any step: it needs dt lambda < beta for every mode (stability.hpp).
#pragma once

#include "drapeau/lanes.hpp"

namespace drapeau {

struct ForwardEuler {
    static constexpr int order = 1;

    template <class V, class Real>
    DRAPEAU_INLINE static void move(Triple<V>& x, Triple<V>& v, const Triple<V>& a, Real dt) {
        x = x + dt * v;
        v = v + dt * a;
    }
};

}  // namespace drapeau
