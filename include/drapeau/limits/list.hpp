// The list of passes after the move, in the order they are made.
#pragma once

#include "drapeau/limits/stretch.hpp"
#include "drapeau/term.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

using Limits = ListOf<StretchLimit>;

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
