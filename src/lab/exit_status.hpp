// Exit statuses of the laboratory's commands.
#pragma once

namespace drapeau::lab {

inline constexpr int exit_good = 0;
inline constexpr int exit_not_met = 1;  // what was asked for does not hold, or its check failed
inline constexpr int exit_bad_input = 2;
inline constexpr int exit_diverged = 3;

}  // namespace drapeau::lab
