// Stability: the largest step that is safe in every configuration, from closed bounds.
//
// For spring Hessians K, dampers C and masses M, semi-implicit Euler is stable if and only if 4M - dt^2 K - 2dt C is
// positive definite; forward Euler is stable if C - dt K and 4M - 2dt C + dt^2 K are. No spring's Hessian exceeds k I,
// folded or stretched, so K is at most the graph Laplacian of the springs, whose largest eigenvalue on a grid is
// max(8k, 4k + 8kd) (4k on a chain); C likewise, with c in place of k, plus drag and friction.
#pragma once

#include "drapeau/model.hpp"
#include "drapeau/methods/forward_euler.hpp"
#include "drapeau/methods/semi_implicit_euler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drapeau {

/// A fabric's rates as the bounds need them.
struct Rates {
    double mass;     // kg
    double k, kd;    // N/m; kd 0 without diagonals
    double c, cd;    // N s/m, of structural and diagonal springs
    double on_mass;  // d + c_f, N s/m
    int directions;  // 2 on a sheet, 1 on a chain

    static Rates of(const Grid& grid, const Material& material, double drag, double friction) {
        const bool sheet = grid.columns > 1 && grid.rows > 1;
        const bool diagonals = material.diagonal_stiffness && sheet;
        const double c = material.damping.value_or(0.0);
        return {.mass = material.mass,
                .k = material.stiffness,
                .kd = diagonals ? *material.diagonal_stiffness : 0.0,
                .c = c,
                .cd = diagonals ? c : 0.0,
                .on_mass = drag + friction,
                .directions = sheet ? 2 : 1};
    }

    /// Largest eigenvalue of the graph Laplacian whose structural edges weigh s and diagonal ones sd, at most.
    double laplacian(double s, double sd) const {
        return directions == 1 ? 4.0 * s : std::max(8.0 * s, 4.0 * s + 8.0 * sd);
    }
};

/// Largest stable dt (s) of semi-implicit Euler with explicit damping: with p = dt^2 k + 2 dt c and pd alike,
/// max(8p, 4p + 8pd) + 2 dt (d + c_f) < 4m. Each branch is a quadratic in dt.
inline double largest_step(SemiImplicitEuler, const Rates& r) {
    const auto root = [&](double stiffness, double damping) {
        const double b = 2.0 * (damping + r.on_mass), q = 16.0 * stiffness * r.mass;
        return 8.0 * r.mass / (b + std::sqrt(b * b + q));  // (-b + sqrt(b^2 + q)) / 2a without cancellation
    };
    if (r.directions == 1) return root(4.0 * r.k, 4.0 * r.c);
    return std::min(root(8.0 * r.k, 8.0 * r.c), root(4.0 * r.k + 8.0 * r.kd, 4.0 * r.c + 8.0 * r.cd));
}

/// Largest stable dt (s) of forward Euler, 0 if there is none, wherever no spring is compressed (a compressed one lets
/// the cloth buckle at any step). A spring that is stretched also
/// resists sideways, where its damper does nothing: only drag and friction hold that, d + c_f > dt max(8k, 4k + 8kd).
inline double largest_step(ForwardEuler, const Rates& r) {
    const double against_growth = r.on_mass / r.laplacian(r.k, r.kd);
    const double against_overdamping = 2.0 * r.mass / (r.laplacian(r.c, r.cd) + r.on_mass);
    return std::min(against_growth, against_overdamping);
}

/// The drag + friction (N s/m) that gives forward Euler the step dt (s).
inline double damping_needed(ForwardEuler, const Rates& r, double dt) {
    return dt * r.laplacian(r.k, r.kd);
}

}  // namespace drapeau
