// Forces on a single mass (report, eqs. 2, 3, 4 and 6). Each is a term: a type that a flag lists or does not have.
//
//   m a = m g - d v + d v_wind(t) - c_f v + springs        =>  a = [g + d/m v_wind(t)] - [(d + c_f)/m] v + springs/m
//
// The two brackets are the same for every mass, so whatever is listed folds to one acceleration and one rate a step.
#pragma once

#include "drapeau/lanes.hpp"
#include "drapeau/terms/wind.hpp"

#include <glm/vec3.hpp>

#include <concepts>

namespace drapeau {

struct Gravity {
    glm::dvec3 acceleration{0.0, -9.8, 0.0};  // m/s2
};
struct AirDrag {
    double d = 0.0;  // N s/m; with semi-implicit Euler stable while d dt / m < 2
};
struct Friction {
    double c_f = 0.0;  // N s/m, on the mass itself: eq. 6 read literally
};
struct UniformWind {
    Wind wind;  // the same for every mass; needs AirDrag to be felt
};

/// The fold at one moment. Without an acceleration or without a rate, the member, its loads and its arithmetic are
/// gone.
template <class Real, bool has_acceleration, bool has_rate>
struct Uniform;

template <class Real>
struct Uniform<Real, false, false> {
    template <class V>
    DRAPEAU_INLINE Triple<V> add_to(const Triple<V>& a, const Triple<V>&) const {
        return a;
    }
};

template <class Real>
struct Uniform<Real, true, false> {
    Real acceleration[3];  // m/s2

    template <class V>
    DRAPEAU_INLINE Triple<V> add_to(const Triple<V>& a, const Triple<V>&) const {
        return {a.x + acceleration[0], a.y + acceleration[1], a.z + acceleration[2]};
    }
};

template <class Real>
struct Uniform<Real, false, true> {
    Real rate;  // 1/s

    template <class V>
    DRAPEAU_INLINE Triple<V> add_to(const Triple<V>& a, const Triple<V>& v) const {
        return a - rate * v;
    }
};

template <class Real>
struct Uniform<Real, true, true> {
    Real acceleration[3];  // m/s2
    Real rate;             // 1/s

    template <class V>
    DRAPEAU_INLINE Triple<V> add_to(const Triple<V>& a, const Triple<V>& v) const {
        return {(a.x + acceleration[0]) - rate * v.x, (a.y + acceleration[1]) - rate * v.y,
                (a.z + acceleration[2]) - rate * v.z};
    }
};

/// What the listed terms amount to at time t (s) for masses of `mass` kg each.
template <class Real, class... Terms>
auto fold(const double mass, const double t, const Terms&... terms) {
    constexpr bool has_drag = (std::same_as<Terms, AirDrag> || ...);
    constexpr bool has_wind = (std::same_as<Terms, UniformWind> || ...);
    constexpr bool has_rate = has_drag || (std::same_as<Terms, Friction> || ...);
    constexpr bool has_acceleration = has_wind || (std::same_as<Terms, Gravity> || ...);
    static_assert(has_drag || !has_wind, "wind is felt through drag: list AirDrag too");

    [[maybe_unused]] glm::dvec3 acceleration{0.0}, wind{0.0};
    [[maybe_unused]] double drag = 0.0, friction = 0.0;
    [[maybe_unused]] const auto take = [&]<class Term>(const Term& term) {
        if constexpr (std::same_as<Term, Gravity>) acceleration = term.acceleration;
        if constexpr (std::same_as<Term, AirDrag>) drag = term.d;
        if constexpr (std::same_as<Term, Friction>) friction = term.c_f;
        if constexpr (std::same_as<Term, UniformWind>) wind = term.wind.velocity(t);
    };
    (take(terms), ...);

    Uniform<Real, has_acceleration, has_rate> uniform{};
    if constexpr (has_acceleration) {
        acceleration += drag / mass * wind;
        for (int k = 0; k < 3; ++k) uniform.acceleration[k] = static_cast<Real>(acceleration[k]);
    }
    if constexpr (has_rate) uniform.rate = static_cast<Real>((drag + friction) / mass);
    return uniform;
}

}  // namespace drapeau
