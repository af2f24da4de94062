// Wind: a pure function of (seed, absolute time): mean + gusts on each axis.
//
// A gust is smooth noise: random values at knots, joined by the quintic 6 s^5 - 15 s^4 + 10 s^3, whose first and second
// derivatives vanish at the knots, so the wind is twice continuously differentiable and does not hurt any method's
// order. Nothing is drawn per step: any two runs see the same wind whatever their step, method or precision.
#pragma once

#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>

namespace drapeau {

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

/// Smooth noise of mean 0 and variance 1 at position s (in knots), twice continuously differentiable, bounded by 2.
inline double smooth_noise(std::uint64_t seed, std::uint64_t stream, double s) {
    const double knot = std::floor(s);
    const double u = s - knot;
    const double w = u * u * u * (u * (6.0 * u - 15.0) + 10.0);
    const auto index = static_cast<std::int64_t>(knot);
    const double value = (1.0 - w) * random_at(seed, stream, index) + w * random_at(seed, stream, index + 1);
    // A knot's variance is 1/3; between knots (1-w)^2 + w^2 of it is left, on average 1 - 2 (1/2 - 181/462) = 181/231.
    constexpr double scale = 1.9567138988027746;  // 1 / sqrt(1/3 * 181/231)
    return scale * value;
}

struct Wind {
    glm::dvec3 mean{0.0};   // m/s
    glm::dvec3 gusts{0.0};  // m/s, rms on each axis
    double period = 1.5;    // s, the time scale of the slow gusts; larger is slower
    std::uint64_t seed = 1;

    /// The wind at absolute time t (s), in m/s. Slow gusts carry 80 % of the variance, four times faster ones the rest.
    glm::dvec3 velocity(double t) const {
        constexpr double slow = 0.8944271909999159, fast = 0.4472135954999579;  // square roots of 0.8 and 0.2
        glm::dvec3 w = mean;
        for (int axis = 0; axis < 3; ++axis) {
            if (gusts[axis] == 0.0) continue;
            const auto stream = static_cast<std::uint64_t>(2 * axis);
            const double s = 2.0 * t / period;  // a slow gust rises and falls in one period
            w[axis] +=
                gusts[axis] * (slow * smooth_noise(seed, stream, s) + fast * smooth_noise(seed, stream + 1, 4.0 * s));
        }
        return w;
    }
};

}  // namespace drapeau
