// Gravity: m g on every mass (report, eq. 2).
#pragma once

#include "drapeau/term.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

struct Gravity {
    static constexpr const char* name = "gravity";
    static constexpr const char* table = "gravity";

    glm::dvec3 acceleration{0.0, -9.8, 0.0};  // m/s2

    template <class Real>
    void accelerate(const PushedRow<Real>& row, double, const Field<Real>& a) const {
        const auto add = [&](Real* to, double g) {
            for (int i = 0; i < row.width; ++i) to[i] += static_cast<Real>(g);
        };
        add(a.x, acceleration.x), add(a.y, acceleration.y), add(a.z, acceleration.z);
    }

    double potential(const glm::dvec3& moment) const {
        return -(acceleration.x * moment.x + acceleration.y * moment.y + acceleration.z * moment.z);
    }

    bool operator==(const Gravity&) const = default;
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
