// Air: what it does to the faces of the cloth, each node standing for its share of the area. With u = wind - v, taken
// apart into u_n along the normal n and u_t along the face:
//
//   F = rho/2 C_d A |u_n| u_n n + rho/2 C_f A |u_t| u_t          pressure on the face, friction along the skin
//
// Pressure is the drag of a plate that the air meets at an angle (proportional to sin^2), friction that of a plate
// edge-on. n is the direction of (x_right - x_left) x (x_above - x_below), the grid's central differences, one-sided at
// borders. A is the area at rest; a border node's is half, a corner's a quarter, however heavy it is: the shares come
// to the whole cloth. A chain has no faces and feels nothing.
#pragma once

#include "drapeau/term.hpp"

#include <cmath>
#include <optional>

namespace drapeau {
inline namespace DRAPEAU_ISA {

struct Air {
    static constexpr const char* name = "air on faces";
    static constexpr const char* table = "air";

    double density = 1.2;                  // rho, kg/m3; denser air pushes and brakes more
    std::optional<double> pressure = 1.2;  // C_d; absent: no pressure
    std::optional<double> skin = 0.05;     // C_f; absent: no skin friction. More of it calms ripples
    bool added = false;                    // the air that moves along with the cloth (extra/added_air.hpp): flutter
    double cutoff = 0.15;                  // m; waves shorter than about twice this carry no air along

    template <class Real>
    AirStrength<Real> strength() const {
        const auto half = [&](const std::optional<double>& c) {
            return static_cast<Real>(0.5 * density * c.value_or(0.0));
        };
        return {half(pressure), half(skin)};
    }
    bool moves_along() const { return added && density > 0.0; }
    bool is_felt() const { return strength<double>().is_felt() || moves_along(); }

    /// The greatest rate (1/s) at which it brakes a node of `area` (m2/kg) that it passes at `speed` (m/s): the
    /// derivative of the force by the velocity, over the mass. Along the normal only pressure brakes, along the face
    /// only friction.
    double most_rate(double area, double speed) const {
        const auto s = strength<double>();
        return 2.0 * std::fmax(s.pressure, s.skin) * area * speed;
    }
    /// The greatest power (W) that it brings into a node of so much area (m2) in a wind w (m/s): |u| u (w - u) is
    /// greatest at u = 2w/3. Air that moves along may give back at once what it took.
    double most_power(double area, double wind) const {
        if (moves_along()) return INFINITY;
        const auto s = strength<double>();
        return (s.pressure + s.skin) * area * (4.0 / 27.0) * wind * wind * wind;
    }
    /// The acceleration (m/s2) of a node of `area` (m2/kg) that rests in the plane in which flat flags begin, in a wind
    /// (m/s).
    glm::dvec3 push_at_rest(double area, const glm::dvec3& wind) const {
        const auto s = strength<double>();
        const double along = std::hypot(wind.x, wind.y);
        return area *
               glm::dvec3(s.skin * along * wind.x, s.skin * along * wind.y, s.pressure * std::fabs(wind.z) * wind.z);
    }

    bool operator==(const Air&) const = default;
};

/// A face of less than this share of its area at rest has no direction: its normal fades to zero there, and with it the
/// pressure.
inline constexpr double smallest_face = 1e-8;

/// How the air passes a register of nodes.
template <class V>
struct AirFlow {
    Vec3<V> face, along;   // a normal of any length, and the velocity along the face, u_t (m/s)
    V across;              // u_n n is that much of the normal
    V speed, speed_along;  // |u_n| and |u_t|, m/s
};

/// From a difference along the fly and one up the hoist (m) and u (m/s); a normal of a square below `fading` (m4)
/// fades.
template <class V>
DRAPEAU_INLINE AirFlow<V> air_flow(const Vec3<V>& fly, const Vec3<V>& hoist, const Vec3<V>& u,
                                   typename Lanes<V>::Real fading) {
    AirFlow<V> flow;
    flow.face = cross(fly, hoist);
    const V r = inverse_sqrt<V>(dot(flow.face, flow.face) + fading), u_n = dot(u, flow.face) * r;
    flow.across = u_n * r;
    flow.speed = Lanes<V>::greater(u_n, V{} - u_n);
    flow.along = u - flow.across * flow.face;
    // |u_t| = |u x n|, which need not wait for the first square root.
    const auto w = cross(u, flow.face);
    const V square = dot(w, w);
    flow.speed_along = (square * inverse_sqrt<V>(square)) * r;
    return flow;
}

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
