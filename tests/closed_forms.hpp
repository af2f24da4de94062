// The methods' own motion of one oscillator, in closed form: of a mass on a spring, and of every mode of a chain or a
// sheet that moves little.
#pragma once

#include "physics_sheet.hpp"

#include <cmath>
#include <complex>

namespace drapeau::testing {

/// x_n of x_{n+1} = T x_n - D x_{n-1}: D^(n/2) (x0 cos(n theta) + B sin(n theta)).
inline double recurrence(double T, double D, double x0, double x1, int n) {
    const double mu = std::sqrt(D), cosine = T / (2.0 * mu), theta = std::acos(cosine);
    const double B = (x1 / mu - x0 * cosine) / std::sin(theta);
    return std::pow(mu, n) * (x0 * std::cos(n * theta) + B * std::sin(n * theta));
}
/// One-step methods multiply each of the two solutions exp(s t) by R(s dt) a step.
template <class Factor>
inline double multiplied(double m, double k, double c, double x0, double dt, int n, Factor&& R) {
    const double gamma = c / (2.0 * m), omega = std::sqrt(k / m - gamma * gamma);
    const std::complex<double> s{-gamma, omega}, share{0.5 * x0, -0.5 * gamma * x0 / omega};
    return 2.0 * (share * std::pow(R(s * dt), n)).real();
}

/// A method's own motion of an oscillator released at x0 after n steps, in closed form, with a = k dt^2/m and
/// b = c dt/m. `drag`: whether c brakes the mass instead of the spring, which makes a difference to leapfrog only.
inline double motion(ForwardEuler, double m, double k, double c, bool, double x0, double dt, int n) {
    return multiplied(m, k, c, x0, dt, n, [](std::complex<double> z) { return 1.0 + z; });
}
inline double motion(Rk4, double m, double k, double c, bool, double x0, double dt, int n) {
    return multiplied(m, k, c, x0, dt, n, [](std::complex<double> z) {
        return 1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)));
    });
}
inline double motion(SemiImplicitEuler, double m, double k, double c, bool, double x0, double dt, int n) {
    const double a = k * dt * dt / m, b = c * dt / m;
    return recurrence(2.0 - a - b, 1.0 - b, x0, (1.0 - a) * x0, n);
}
inline double motion(Leapfrog, double m, double k, double c, bool drag, double x0, double dt, int n) {
    const double a = k * dt * dt / m, b = c * dt / m;
    // Centred: (1 + b/2) x_{n+1} = (2 - a) x_n - (1 - b/2) x_{n-1}, started with the velocity zero at x0.
    if (drag || c == 0.0)
        return recurrence((2.0 - a) / (1.0 + 0.5 * b), (1.0 - 0.5 * b) / (1.0 + 0.5 * b), x0, (1.0 - 0.5 * a) * x0, n);
    // The damper sees v_{n-1/2} + dt/2 a_{n-1}: a third root; the recurrence is run as it stands. `u`: dt v.
    double x = x0, u = 0.5 * a * x0, seen = 0.0;
    for (; n > 0; --n) {
        const double kick = -a * x - b * seen;
        u += kick, x += u, seen = u + 0.5 * kick;
    }
    return x;
}

inline double motion(ImplicitEuler, double m, double k, double c, bool, double x0, double dt, int n) {
    return multiplied(m, k, c, x0, dt, n, [](std::complex<double> z) { return 1.0 / (1.0 - z); });
}
/// One spring that moves one mass is solved by one correction.
inline double motion(Xpbd, double m, double k, double c, bool drag, double x0, double dt, int n) {
    return motion(ImplicitEuler{}, m, k, c, drag, x0, dt, n);
}

}  // namespace drapeau::testing
