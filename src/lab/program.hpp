// The program's name, as its messages begin with it.
#pragma once

namespace drapeau::lab {

inline constexpr const char* program = "drapeau-lab";

}  // namespace drapeau::lab
