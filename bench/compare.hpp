// Compare: two files this benchmark wrote, case by case.
#pragma once

#include <istream>
#include <string>
#include <vector>

namespace drapeau::bench {

struct Minimum {
    std::string name;  // of the case
    double ns;         // a mass and step
};

/// The minima among the numbers that this benchmark wrote. `source` names them in a message. Throws InputError.
std::vector<Minimum> minima_in(std::istream& results, const std::string& source);

/// Prints the ratio of the minima of every case that both files have, and their geometric mean. Throws InputError.
void compare_files(const std::string& a, const std::string& b);

}  // namespace drapeau::bench
