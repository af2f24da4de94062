// Air drag: -d v on every mass (report, eq. 3). Wind is felt through it.
#pragma once

#include "drapeau/term.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

struct AirDrag {
    static constexpr const char* name = "air drag";
    static constexpr bool is_air = true;

    double d = 0.0;  // N s/m; larger needs a smaller step with the Euler methods

    double damping(double share) const { return d * share; }

    bool operator==(const AirDrag&) const = default;
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
