#include "velocity_lines.hpp"

#include "usual_size.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace drapeau {

namespace {

constexpr float along_side = 18.0f;  // lines
constexpr double longest = 3.0;      // of the length asked for
constexpr double shortest = 0.01;    // of the length asked for; what is shorter is left out

}  // namespace

double usual_speed(const FieldBuffer<float>& velocity) {
    return usual_size(velocity.columns(), velocity.rows(),
                      [&](int column, int row) { return glm::length(velocity.at(column, row)); });
}

glm::ivec2 lines_apart(int columns, int rows, glm::vec2 cell) {
    const glm::vec2 sides = cell * glm::vec2(glm::max(glm::ivec2(columns, rows) - 1, 1));
    const float apart = std::max(sides.x, sides.y) / (along_side - 1.0f);
    const auto masses = [&](float pitch) { return pitch > 0.0f ? std::max(1, int(std::lround(apart / pitch))) : 1; };
    return {masses(cell.x), masses(cell.y)};
}

std::vector<Streak> velocity_lines(const Snapshot& snapshot, glm::vec2 cell, double speed, double length) {
    const auto& [position, velocity, time, steps] = snapshot;
    const int columns = position.columns(), rows = position.rows();
    std::vector<Streak> lines;
    if (velocity.columns() != columns || velocity.rows() != rows || !(speed > 0.0)) return lines;
    const glm::ivec2 apart = lines_apart(columns, rows, cell);
    // The fly end, which moves most, has its lines; rows are taken from the middle.
    for (int row = (rows - 1) % apart.y / 2; row < rows; row += apart.y)
        for (int column = (columns - 1) % apart.x; column < columns; column += apart.x) {
            glm::dvec3 along = length / speed * velocity.at(column, row);
            const glm::dvec3 from = position.at(column, row);
            const double size = glm::length(along);
            if (!(size >= shortest * length)) continue;
            along *= std::min(1.0, longest * length / size);
            lines.push_back({glm::vec3(from), glm::vec3(from + along), 1.0f});
        }
    return lines;
}

std::vector<Streak> velocities_of(const Snapshot& snapshot, const FlagSettings& flag, double speed) {
    const int columns = snapshot.position.columns(), rows = snapshot.position.rows();
    const glm::vec2 size(columns > 1 ? flag.width : 0.0, rows > 1 ? flag.height : 0.0);
    const glm::vec2 cell = size / glm::vec2(std::max(1, columns - 1), std::max(1, rows - 1));
    return velocity_lines(snapshot, cell, speed, double(std::max(size.x, size.y)) / 6.0);
}

}  // namespace drapeau
