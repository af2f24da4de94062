// Ground: level, that the flag lies on.
#pragma once

#include "drapeau/limits/contact.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

struct Ground {
    static constexpr const char* name = "ground";
    static constexpr const char* table = "ground";
    static constexpr bool is_contact = true;

    double height = -2.5;   // m
    double friction = 0.4;  // mu, of cloth on it

    template <class Real>
    auto inside(const Grid&) const {
        return [level = static_cast<Real>(height)]<class V>(const Vec3<V>& x) { return level - x.y; };
    }
    Surface surface(const Grid&, const Vec3<double>& x) const { return {{0.0, 1.0, 0.0}, height - x.y}; }

    bool operator==(const Ground&) const = default;
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
