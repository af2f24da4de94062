// Compare: two files this benchmark wrote, case by case.
#pragma once

#include <string>

namespace drapeau::bench {

/// Prints the ratio of the minima of every case that both files have, and their geometric mean. Throws InputError.
void compare_files(const std::string& a, const std::string& b);

}  // namespace drapeau::bench
