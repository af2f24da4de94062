#include "run/carry_over.hpp"

#include <algorithm>

namespace drapeau {
namespace {

/// Bilinear in the flag's own coordinates: column and row as shares of the way along and down.
glm::dvec3 sample(const FieldBuffer<double>& field, double along, double down) {
    const auto split = [](double share, int count, int& n) {
        const double place = share * (count - 1);
        n = std::clamp(static_cast<int>(place), 0, std::max(count - 2, 0));
        return count > 1 ? place - n : 0.0;
    };
    int i = 0, j = 0;
    const double a = split(along, field.columns(), i), b = split(down, field.rows(), j);
    const int i2 = std::min(i + 1, field.columns() - 1), j2 = std::min(j + 1, field.rows() - 1);
    return (1.0 - b) * ((1.0 - a) * field.at(i, j) + a * field.at(i2, j)) +
           b * ((1.0 - a) * field.at(i, j2) + a * field.at(i2, j2));
}

double share(int n, int count) {
    return count > 1 ? static_cast<double>(n) / (count - 1) : 0.0;
}

}  // namespace

State<double> carried_over(const State<double>& old, const Scene& scene) {
    const Model model = model_of(scene);
    const Grid& grid = model.grid;
    State<double> state(grid.columns, grid.rows);
    // Every attachment holds the upper corner, which a halyard may have moved.
    const glm::dvec3 hauled(0.0, scene.flag.halyard ? old.position.at(0, 0).y : 0.0, 0.0);
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            const bool held = model.held(i, j);
            const double along = share(i, grid.columns), down = share(j, grid.rows);
            state.position.set(
                i, j,
                held ? (1.0 + scene.flag.prestretch) * grid.rest(i, j) + hauled : sample(old.position, along, down));
            if (!held) state.velocity.set(i, j, sample(old.velocity, along, down));
        }
    return state;
}

}  // namespace drapeau
