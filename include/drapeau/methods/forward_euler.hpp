// Forward Euler, the classic explicit method: x(t+dt) = x(t) + dt v(t), v(t+dt) = v(t) + dt a(t).
//
// Order 1. It acts like semi-implicit Euler with the damping of every spring lowered by k dt, so an undamped spring
// gains energy at any step: for one mode with a = k dt^2/m and b = c dt/m it needs a < b and 4 - 2b + a > 0.
#pragma once

#include "drapeau/method.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

struct ForwardEuler : OneKick {
    static constexpr const char* name = "forward-euler";
    static constexpr int order = 1;
    static constexpr bool creates_energy = true;

    template <int pass, bool damped, class V, class Rate, class Real>
    DRAPEAU_INLINE static Motion<V> move(const Masses<V>& masses, const Vec3<V>& a, const Rate& rate, Real dt) {
        const auto v = masses.get(1);
        const auto all = resisted(a, rate, v), v_next = v + dt * all;
        masses.set(0, masses.get(0) + dt * v);
        masses.set(1, v_next);
        return {all, Real(0.5) * (v + v_next)};
    }

    /// Wherever no spring is compressed (a compressed one lets the cloth buckle at any step). A spring that is
    /// stretched also resists sideways, where its damper does nothing: only drag and friction hold that, so dt k <
    /// on_mass; and dt (c + on_mass + air) < 2m, bending being counted in k and c. (The air may be still, so it holds
    /// nothing.)
    static StableStep stable_step(const Oscillator& o) {
        const double damping = o.braking() + o.on_mass;
        if (o.restoring() == 0.0 && damping == 0.0) return StableStep::unlimited();
        const double against_growth = o.restoring() > 0.0 ? o.on_mass / o.restoring() : INFINITY;
        return StableStep::of_seconds(std::fmin(against_growth, 2.0 * o.mass / damping));
    }

    /// The drag + friction (N s/m) that gives the step dt (s).
    static double damping_needed(const Oscillator& o, double dt) { return dt * o.restoring(); }
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
