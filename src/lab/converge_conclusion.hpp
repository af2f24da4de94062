// Converge conclusion: what a user may act on, in a sentence on grids and one on steps.
#pragma once

#include "converge_sweep.hpp"

#include <string>

namespace drapeau::lab {

std::string conclusion(const ConvergeFindings& found);

/// What a method comes to: the flag of its best rung, or "left out".
std::string verdict_on(const MethodConvergence& method);

/// "pre-asymptotic"
const char* name_of(StepRung::Flag flag);

}  // namespace drapeau::lab
