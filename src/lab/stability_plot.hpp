// Stability plot: measured limits of every method over stiffness and damping, and the theory they are compared with.
#pragma once

#include "stability_records.hpp"

#include <string>

namespace drapeau::lab {

/// The script for gnuplot. Steps and stiffness are logarithmic, damping is not, for it may be none.
std::string stability_script(const StabilityMap& map);

}  // namespace drapeau::lab
