// The list of passes after the move, in the order they are made.
#pragma once

#include "drapeau/limits/ground.hpp"
#include "drapeau/limits/pole.hpp"
#include "drapeau/limits/stretch.hpp"
#include "drapeau/term.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

using Limits = ListOf<StretchLimit, Ground, Pole>;

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
