// Pole: an upright rod of any height beside the hoist (its surface is where the hoist rests), that the flag wraps
// around.
//
// Only masses are kept out, and a thread between two of them is straight. They are kept as far out as lets a thread one
// cell long just touch the pole: hypot(radius, half of the cell's longer side) from its axis.
#pragma once

#include "drapeau/limits/contact.hpp"

#include <algorithm>

namespace drapeau {
inline namespace DRAPEAU_ISA {

struct Pole {
    static constexpr const char* name = "pole";
    static constexpr const char* table = "pole";
    static constexpr bool is_contact = true;

    double radius = 0.021;  // m
    double friction = 0.3;  // mu, of cloth on it

    /// How far from the axis masses are kept (m).
    double reach(const Grid& grid) const {
        const double fly = grid.columns > 1 ? grid.pitch_x : 0.0, hoist = grid.rows > 1 ? grid.pitch_y : 0.0;
        return std::hypot(radius, 0.5 * std::max(fly, hoist));
    }
    template <class Real>
    auto inside(const Grid& grid) const {
        const auto axis = static_cast<Real>(radius), square = static_cast<Real>(reach(grid) * reach(grid));
        return [axis, square]<class V>(const Vec3<V>& x) {
            const V across = x.x + axis;
            return square - (across * across + x.z * x.z);
        };
    }
    Surface surface(const Grid& grid, const Vec3<double>& x) const {
        const double across = x.x + radius, distance = std::hypot(across, x.z);
        if (distance == 0.0) return {{1.0, 0.0, 0.0}, reach(grid)};
        return {{across / distance, 0.0, x.z / distance}, reach(grid) - distance};
    }

    bool operator==(const Pole&) const = default;
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
