// The classical Runge-Kutta method: four evaluations a step, order 4. The reference, in double.
//
//   k1 = f(t, y)   k2 = f(t + dt/2, y + dt/2 k1)   k3 = f(t + dt/2, y + dt/2 k2)   k4 = f(t + dt, y + dt k3)
//   y(t+dt) = y + dt/6 (k1 + 2 k2 + 2 k3 + k4)          y = (x, v), f = (v, a)
//
// Stable while dt z stays where |1 + z + z^2/2 + z^3/6 + z^4/24| <= 1 for both roots z of z^2 + beta z + lambda = 0. In
// the left half plane that holds wherever |z| <= 2.6155 (the boundary is nearest 122.7 degrees from the positive axis;
// 2.8284 on the imaginary axis, 2.7853 on the real one).
#pragma once

#include "drapeau/method.hpp"

#include <complex>

namespace drapeau {
inline namespace DRAPEAU_ISA {

struct Rk4 {
    static constexpr const char* name = "rk4";
    static constexpr int order = 4;
    using Looks = OneKick;  // at the beginning of a step
    static constexpr bool staggered = false, starts_with_forces = false;
    static constexpr bool creates_energy = false, dissipates_energy = true, counts_work = true, solves = false;
    static constexpr double coarsest_step = 1.0 / 60.0;  // s
    static constexpr bool bound_is_safe_only = true;
    // A mode loses the share y^6/72 of its energy a step, y = omega dt: at 0.3 of the limit the fastest 0.5 %.
    static constexpr double automatic = 0.4;
    static constexpr int passes = 4;
    static constexpr double stage_time[] = {0.0, 0.5, 0.5, 1.0};
    static constexpr double weight[] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    // Fields 2 and 3 are the stage's position and velocity, 4 and 5 the sums of what was evaluated.
    template <bool damped>
    static constexpr int fields = 6;
    template <bool damped>
    static constexpr int seen_position = 2;
    template <bool damped>
    static constexpr int seen_velocity = 3;

    template <class V, class Rate, class Real>
    DRAPEAU_INLINE static Vec3<V> total(const Vec3<V>& a, const Rate& rate, const Vec3<V>& v, Real) {
        return resisted(a, rate, v);
    }

    template <int pass, bool damped, class V, class Rate, class Real>
    DRAPEAU_INLINE static Motion<V> move(const Masses<V>& masses, const Vec3<V>& a, const Rate& rate, Real dt) {
        const auto v = masses.get(3);
        const auto all = resisted(a, rate, v);
        if constexpr (pass == 3) {
            const auto x_next = masses.get(0) + (dt / Real(6)) * (masses.get(4) + v);
            const auto v_next = masses.get(1) + (dt / Real(6)) * (masses.get(5) + all);
            masses.set(0, x_next), masses.set(1, v_next);
            masses.set(2, x_next), masses.set(3, v_next);
        } else {
            if constexpr (pass == 0)
                masses.set(4, v), masses.set(5, all);
            else
                masses.set(4, masses.get(4) + Real(2) * v), masses.set(5, masses.get(5) + Real(2) * all);
            const Real ahead = pass == 2 ? dt : Real(0.5) * dt;
            masses.set(2, masses.get(0) + ahead * v);
            masses.set(3, masses.get(1) + ahead * all);
        }
        return {all, v};
    }

    template <bool damped, class Real>
    static void start(const Field<Real>* fields, std::ptrdiff_t n, const Vec3<Real>&, Real, Real) {
        const Masses<Real> mass{fields, n};
        mass.set(2, mass.get(0)), mass.set(3, mass.get(1));
    }
    template <bool damped, class Real>
    static Vec3<Real> synchronised(const Field<Real>* fields, std::ptrdiff_t n, const Vec3<Real>&, Real, Real) {
        return fields[1].template at<Real>(n);
    }
    template <bool damped, class Real>
    static void follow(const Field<Real>* fields, std::ptrdiff_t n, const Vec3<Real>& dx, const Vec3<Real>& dv) {
        OneKick::follow<damped>(fields, n, dx, dv);
        start<damped>(fields, n, dx, Real(0), Real(0));
    }

    /// A root that is not real has |z|^2 = lambda of its mode; a real one is at most beta.
    static StableStep stable_step(const Oscillator& o) {
        const double fastest = std::sqrt(o.restoring() / o.mass), beta = (o.braking() + o.on_mass) / o.mass;
        if (fastest == 0.0 && beta == 0.0) return StableStep::unlimited();
        const double ringing = (beta == 0.0 ? 2.8284 : 2.6155) / fastest;  // infinite without springs
        return StableStep::of_seconds(std::fmin(ringing, 2.7853 / beta));
    }

    /// |1 + z + z^2/2 + z^3/6 + z^4/24|, z = dt times either root of z^2 + beta z + lambda.
    static double growth(const Oscillator& o, double dt) {
        const double beta = (o.braking() + o.on_mass) / o.mass;
        const std::complex<double> spread =
            std::sqrt(std::complex<double>(0.25 * beta * beta - o.restoring() / o.mass));
        double most = 0.0;
        for (const double sign : {-1.0, 1.0}) {
            const auto z = dt * (-0.5 * beta + sign * spread);
            most = std::fmax(most, std::abs(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)))));
        }
        return most;
    }
    // Which mode is the fastest depends little on damping.
    static constexpr double damping_weight = 0.0, on_mass_weight = 0.0;
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
