// Measure: one case, timed in turns with what it is compared with. Smoke: the same case checked, not timed.
#pragma once

#include "record.hpp"

#include <string>

namespace drapeau::bench {

/// Times a case for about `budget` seconds, and as long each of its rivals.
Record measure_case(const Case& c, const Peaks& peaks, double budget);

/// Runs a case for a few steps. Empty if all is well; otherwise one line that says what is wrong: a value is not
/// finite, or the result depends on the number of threads or on how many steps are asked for at once.
std::string smoke_case(const Case& c);

}  // namespace drapeau::bench
