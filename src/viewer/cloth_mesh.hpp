// ClothMesh: how finely the cloth is drawn, and the triangles of a grid of points.
#pragma once

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace drapeau {

inline constexpr int most_pieces = 24;  // of a cell along either side

/// Into how many pieces each cell is cut along the fly and along the hoist, so that the drawn points are as far apart
/// in both directions, about `most` along the longer side. `masses`: columns and rows; `cell`: m. A grid as fine as
/// that by itself stays as it is.
inline glm::ivec2 pieces_of_cell(glm::ivec2 masses, glm::vec2 cell, int most) {
    const glm::vec2 sides = cell * glm::vec2(masses - 1);
    const float apart = std::max(sides.x, sides.y) / float(most);
    const auto pieces = [&](int count, float side) {
        const int fitting = most / std::max(1, count - 1);  // never more points than these
        if (count < 2 || !(apart > 0.0f)) return 1;
        return std::clamp(int(std::lround(side / apart)), 1, std::clamp(fitting, 1, most_pieces));
    };
    return {pieces(masses.x, cell.x), pieces(masses.y, cell.y)};
}

/// Two triangles a cell of a grid of points numbered row by row, the cut alternating, so that no direction is favoured.
inline std::vector<std::uint32_t> triangles_between(int columns, int rows) {
    std::vector<std::uint32_t> indices;
    indices.reserve(std::size_t(columns) * std::size_t(rows) * 6);
    for (int row = 0; row + 1 < rows; ++row)
        for (int column = 0; column + 1 < columns; ++column) {
            const auto a = std::uint32_t(row * columns + column), b = a + 1;
            const auto c = a + std::uint32_t(columns), d = c + 1;
            if ((row + column) % 2 == 0)
                indices.insert(indices.end(), {a, c, b, b, c, d});
            else
                indices.insert(indices.end(), {a, c, d, a, d, b});
        }
    return indices;
}

}  // namespace drapeau
