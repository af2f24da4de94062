// The list of terms: scenes, the model and the programs follow it.
#pragma once

#include "drapeau/terms/air.hpp"
#include "drapeau/terms/air_drag.hpp"
#include "drapeau/terms/bending.hpp"
#include "drapeau/terms/friction.hpp"
#include "drapeau/terms/gravity.hpp"
#include "drapeau/terms/wind.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

using Terms = ListOf<Gravity, AirDrag, Friction, Bending, Air, Wind>;

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
