// Leapfrog: positions at whole steps, velocities half a step off; one force evaluation a step.
//
//   v+ = [(1 - b/2) v- + dt a(x)] / (1 + b/2),  x(t+dt) = x(t) + dt v+        b = (d + c_f) dt/m
//
// Order 2. Drag and friction are centred, so they do not lower the limit. Dampers of springs look at velocities of the
// position's own time, predicted as v- + dt/2 a of the step before, and so does the air on faces: one more stored
// vector keeps the order at 2 with them, and the limit is a + 4b < 4 with b of theirs alone. Without them nothing more
// is stored.
#pragma once

#include "drapeau/method.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

struct Leapfrog : OneKick {
    static constexpr const char* name = "leapfrog";
    static constexpr int order = 2;
    using Looks = Leapfrog;
    static constexpr bool staggered = true, starts_with_forces = true;
    static constexpr double damping_weight = 4.0, on_mass_weight = 0.0;  // in the limit a + weight b < 4
    template <bool damped>
    static constexpr int fields = damped ? 3 : 2;
    template <bool damped>
    static constexpr int seen_velocity = damped ? 2 : 1;

    /// (v+ - v-) / dt = (a - rate v-) / (1 + b/2).
    template <class V, class Rate, class Real>
    DRAPEAU_INLINE static Vec3<V> total(const Vec3<V>& a, const Rate& rate, const Vec3<V>& v, Real dt) {
        if constexpr (std::is_same_v<Rate, NoRate>)
            return a;
        else
            return (Real(1) / (Real(1) + (Real(0.5) * dt) * rate)) * (a - rate * v);
    }

    template <int pass, bool damped, class V, class Rate, class Real>
    DRAPEAU_INLINE static Motion<V> move(const Masses<V>& masses, const Vec3<V>& a, const Rate& rate, Real dt) {
        const auto v = masses.get(1);
        const auto all = total(a, rate, v, dt), v_next = v + dt * all;
        masses.set(0, masses.get(0) + dt * v_next);
        masses.set(1, v_next);
        if constexpr (damped) masses.set(2, v_next + (Real(0.5) * dt) * all);
        return {all, Real(0.5) * (v + v_next)};
    }

    /// v- = (1 + b/2) v - dt/2 a, from the velocity at the position's time.
    template <bool damped, class Real>
    static void start(const Field<Real>* fields, std::ptrdiff_t n, const Vec3<Real>& a, Real rate, Real dt) {
        const Masses<Real> mass{fields, n};
        const auto v = mass.get(1);
        if constexpr (damped) mass.set(2, v);
        mass.set(1, (Real(1) + Real(0.5) * dt * rate) * v - (Real(0.5) * dt) * a);
    }
    /// v = (v- + v+) / 2.
    template <bool damped, class Real>
    static Vec3<Real> synchronised(const Field<Real>* fields, std::ptrdiff_t n, const Vec3<Real>& a, Real rate,
                                   Real dt) {
        const auto v = fields[1].template at<Real>(n);
        return v + (Real(0.5) * dt) * total(a, rate, v, dt);
    }
    template <bool damped, class Real>
    static void follow(const Field<Real>* fields, std::ptrdiff_t n, const Vec3<Real>& dx, const Vec3<Real>& dv) {
        OneKick::follow<damped>(fields, n, dx, dv);
        const Masses<Real> mass{fields, n};
        if constexpr (damped) mass.set(2, mass.get(2) + dv);
    }

    /// Beyond b = 2 drag and friction throw a velocity past the one that they carry it to, to and fro; half of that is
    /// smooth.
    static StableStep smooth_step(const Oscillator& o) {
        return o.on_mass > 0.0 ? StableStep::of_seconds(o.mass / o.on_mass) : StableStep::unlimited();
    }

    static StableStep stable_step(const Oscillator& o) {
        return step_where(o.restoring(), 4.0 * o.braking(), 4.0 * o.mass);
    }
    /// By taking steps: what is kept makes it a matrix of three rows.
    static double growth(const Oscillator& o, double dt) {
        constexpr int settling = 2000, steps = 500;
        const double lambda = o.restoring() / o.mass, beta = o.braking() / o.mass, half = 0.5 * dt * o.on_mass / o.mass;
        double x = 1.0, v = 0.3 * std::sqrt(lambda), seen = v, grown = 0.0;
        for (int n = 0; n < settling + steps; ++n) {
            const double next = ((1.0 - half) * v - dt * (lambda * x + beta * seen)) / (1.0 + half);
            x += dt * next;
            seen = 1.5 * next - 0.5 * v;
            v = next;
            const double size = std::sqrt(lambda * x * x + v * v);
            if (!(size > 0.0)) return 0.0;
            if (n >= settling) grown += std::log(size);
            x /= size, v /= size, seen /= size;
        }
        return std::exp(grown / steps);
    }
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
