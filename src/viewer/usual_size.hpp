// The usual size of something that each mass has: what 19 masses in 20 do not exceed. Colours and lengths scale with
// it, for one whipping tip would make all others small.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace drapeau {

/// `size(column, row)` is that of a mass, 0 or more; of large cloths about 4000 masses are asked. 0 of no masses.
template <class Size>
double usual_size(int columns, int rows, const Size& size) {
    constexpr double usual_part = 0.95;
    constexpr int asked_along_side = 64;  // masses, at most, along either side
    const int apart_x = 1 + columns / asked_along_side, apart_y = 1 + rows / asked_along_side;
    std::vector<double> sizes;
    for (int row = 0; row < rows; row += apart_y)
        for (int column = 0; column < columns; column += apart_x) sizes.push_back(size(column, row));
    if (sizes.empty()) return 0.0;
    const auto at = sizes.begin() + std::ptrdiff_t(usual_part * double(sizes.size() - 1));
    std::nth_element(sizes.begin(), at, sizes.end());
    return *at;
}

}  // namespace drapeau
