// Wind: d v_wind on every mass (report, eq. 4); a pure function of (seed, absolute time[, place]): mean + gusts on each
// axis.
//
// A gust is smooth noise: random values at knots, joined by the quintic 6 s^5 - 15 s^4 + 10 s^3, whose first and second
// derivatives vanish at the knots, so the wind is twice continuously differentiable and does not hurt any method's
// order. Nothing is drawn per step: any two runs see the same wind whatever their step, method or precision.
//
// Travelling gusts are carried along by the mean wind U (frozen turbulence): a mass whose rest place lies s metres
// along U feels gust(t - s / max(|U|, 1 m/s)).
#pragma once

#include "drapeau/term.hpp"

#include <cmath>
#include <cstdint>

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// A well-mixed 64-bit hash (the finaliser of SplitMix64, Steele et al. 2014).
constexpr std::uint64_t mix(std::uint64_t n) {
    n += 0x9e3779b97f4a7c15u;
    n = (n ^ (n >> 30)) * 0xbf58476d1ce4e5b9u;
    n = (n ^ (n >> 27)) * 0x94d049bb133111ebu;
    return n ^ (n >> 31);
}

/// Uniform in [-1, 1), a pure function of (seed, stream, index).
inline double random_at(std::uint64_t seed, std::uint64_t stream, std::int64_t index) {
    const auto bits = mix(mix(mix(seed) + stream) + static_cast<std::uint64_t>(index));
    return static_cast<double>(bits >> 11) * 0x1.0p-52 - 1.0;
}

/// How far a value has gone from one knot to the next: 6 u^5 - 15 u^4 + 10 u^3.
inline double eased(double u) {
    return u * u * u * (u * (6.0 * u - 15.0) + 10.0);
}

/// What brings the variance to 1. A knot's is 1/3; between knots (1-w)^2 + w^2 of it is left, on average
/// 1 - 2 (1/2 - 181/462) = 181/231.
inline constexpr double noise_scale = 1.9567138988027746;  // 1 / sqrt(1/3 * 181/231)

/// Smooth noise of mean 0 and variance 1 at position s (in knots), twice continuously differentiable, bounded by 2.
inline double smooth_noise(std::uint64_t seed, std::uint64_t stream, double s) {
    const double knot = std::floor(s);
    const double w = eased(s - knot);
    const auto index = static_cast<std::int64_t>(knot);
    const double value = (1.0 - w) * random_at(seed, stream, index) + w * random_at(seed, stream, index + 1);
    return noise_scale * value;
}

struct Wind {
    static constexpr const char* name = "wind";
    static constexpr const char* table = "wind";

    glm::dvec3 velocity{0.0};  // m/s, the mean
    glm::dvec3 gusts{0.0};     // m/s, rms on each axis
    double period = 1.5;       // s, the time scale of the slow gusts; larger is slower
    bool travelling = false;   // gusts run along the flag with the mean wind; otherwise they are the same everywhere
    std::uint64_t seed = 1;

    /// The wind (m/s) at absolute time t (s), where gusts have not been delayed. Slow gusts carry 80 % of the variance,
    /// four times faster ones the rest.
    glm::dvec3 at(double t) const {
        glm::dvec3 w = velocity;
        for (int axis = 0; axis < 3; ++axis) {
            if (gusts[axis] == 0.0) continue;
            const auto stream = static_cast<std::uint64_t>(2 * axis);
            const double s = slow_knots(t);
            w[axis] +=
                gusts[axis] * (slow * smooth_noise(seed, stream, s) + fast * smooth_noise(seed, stream + 1, 4.0 * s));
        }
        return w;
    }
    /// The wind at a mass whose rest place is `rest` (m).
    glm::dvec3 at(double t, const glm::dvec3& rest) const { return at(t - delay(slowness(), rest)); }

    /// It is never faster (m/s): noise stays within 2.
    double fastest() const { return std::sqrt(fastest_square()); }

    /// d (w - v) v is at most d w^2 / 4.
    double most_power(double d) const { return 0.25 * d * fastest_square(); }

    bool varies_by_row(const Grid&) const { return travelling && velocity.y != 0.0; }

    /// Felt through air drag: (d/m) w on every mass. (With rates of 1 it is the wind itself.)
    template <class Real>
    void accelerate(const PushedRow<Real>& row, double t, const Field<Real>& a) const {
        if (!row.drag_rate) return;
        if (travelling) return accelerate_travelling(row, t, a);
        const auto w = at(t);
        const auto add = [&](Real* to, double speed) {
            for (int i = 0; i < row.width; ++i) to[i] += row.drag_rate[i] * static_cast<Real>(speed);
        };
        add(a.x, w.x), add(a.y, w.y), add(a.z, w.z);
    }

    bool operator==(const Wind&) const = default;

private:
    double fastest_square() const {
        double square = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double w = std::fabs(velocity[axis]) + 2.0 * (slow + fast) * gusts[axis];
            square += w * w;
        }
        return square;
    }

    static constexpr double slow = 0.8944271909999159, fast = 0.4472135954999579;  // square roots of 0.8 and 0.2

    double slow_knots(double t) const { return 2.0 * t / period; }  // a slow gust rises and falls in one period
    /// How much later (s) a gust comes, for each metre along each axis.
    glm::dvec3 slowness() const {
        const double speed = std::hypot(velocity.x, velocity.y, velocity.z);
        if (!travelling || speed == 0.0) return glm::dvec3(0.0);
        return velocity / (speed * std::fmax(speed, 1.0));
    }
    static double delay(const glm::dvec3& slowness, const glm::dvec3& rest) {
        return slowness.x * rest.x + slowness.y * rest.y + slowness.z * rest.z;
    }

    /// The values of both scales' knots around one moment, kept while neighbours need the same.
    struct Knots {
        std::int64_t index = 0;
        bool known = false;
        double value[3][2];  // of each axis, before and after

        void fetch(std::uint64_t of_seed, int scale, std::int64_t wanted) {
            if (known && index == wanted) return;
            index = wanted, known = true;
            for (int axis = 0; axis < 3; ++axis)
                for (int n = 0; n < 2; ++n)
                    value[axis][n] =
                        noise_scale * random_at(of_seed, static_cast<std::uint64_t>(2 * axis + scale), wanted + n);
        }
    };

    template <class Real>
    void accelerate_travelling(const PushedRow<Real>& row, double t, const Field<Real>& a) const {
        Knots knots[2];
        const glm::dvec3 later = slowness();
        for (int i = 0; i < row.grid.columns; ++i) {
            const double s = slow_knots(t - delay(later, row.grid.rest(i, row.row)));
            double w[3] = {velocity.x, velocity.y, velocity.z};
            for (int scale = 0; scale < 2; ++scale) {
                const double place = scale == 0 ? s : 4.0 * s, knot = std::floor(place), share = eased(place - knot);
                knots[scale].fetch(seed, scale, static_cast<std::int64_t>(knot));
                for (int axis = 0; axis < 3; ++axis) {
                    const double* value = knots[scale].value[axis];
                    w[axis] += (scale == 0 ? slow : fast) * gusts[axis] * ((1.0 - share) * value[0] + share * value[1]);
                }
            }
            a.x[i] += row.drag_rate[i] * static_cast<Real>(w[0]);
            a.y[i] += row.drag_rate[i] * static_cast<Real>(w[1]);
            a.z[i] += row.drag_rate[i] * static_cast<Real>(w[2]);
        }
    }
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
