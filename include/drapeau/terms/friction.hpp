// Friction: -c_f v on every mass, whatever the air does: the report's eq. 6 read literally.
#pragma once

#include "drapeau/term.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

struct Friction {
    static constexpr const char* name = "friction";

    double c_f = 0.0;  // N s/m; larger needs a smaller step with the Euler methods

    double damping(double share) const { return c_f * share; }

    bool operator==(const Friction&) const = default;
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
