#include "readout.hpp"

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace drapeau {

namespace {

bool on_grid(const Grid& grid, int column, int row) {
    return column >= 0 && row >= 0 && column < grid.columns && row < grid.rows;
}

/// The force (N) that a spring pulls its first mass with.
glm::dvec3 pull_of(const FieldBuffer<float>& position, const Model& model, const Selection& spring, double& force) {
    const glm::dvec3 a = position.at(spring.column, spring.row);
    const glm::dvec3 b = position.at(spring.column + spring.right, spring.row + spring.down);
    const double length = glm::length(b - a);
    force = spring_constant(model, spring) * (length - rest_length(model.grid, spring));
    return length > 0.0 ? force / length * (b - a) : glm::dvec3(0.0);
}

/// N, what all springs at a mass pull it with.
glm::dvec3 pull_at(const FieldBuffer<float>& position, const Model& model, int column, int row) {
    glm::dvec3 sum(0.0);
    for (int down = -1; down <= 1; ++down)
        for (int right = -1; right <= 1; ++right) {
            if ((right == 0 && down == 0) || !on_grid(model.grid, column + right, row + down)) continue;
            double force = 0.0;
            sum += pull_of(position, model, {column, row, right, down}, force);
        }
    return sum;
}

}  // namespace

double rest_length(const Grid& grid, const Selection& spring) {
    return std::hypot(spring.right * grid.pitch_x, spring.down * grid.pitch_y);
}

double spring_constant(const Model& model, const Selection& spring) {
    const int column = std::min(spring.column, spring.column + spring.right);
    const int row = std::min(spring.row, spring.row + spring.down);
    const auto& kind = model.kinds()[std::size_t(model.kind(row))];
    const double k = model.springs.stiffness;
    if (spring.down == 0) return k * kind.fly[std::size_t(column)];
    if (spring.right == 0) return k * model.springs.along_hoist * kind.hoist[std::size_t(column)];
    return model.springs.diagonal_stiffness.value_or(0.0);
}

void Readout::choose(const Selection& selection) {
    if (chosen_ == selection) return;
    chosen_ = selection;
    past_.clear();
}

void Readout::observe(const Snapshot& snapshot, const Scene& scene) {
    if (!chosen_) return;
    const Model model = model_of(scene);
    const Grid seen =
        spread(snapshot.position.columns(), snapshot.position.rows(), scene.flag.width, scene.flag.height);
    const Selection& part = *chosen_;
    const bool exists = model.grid == seen && on_grid(seen, part.column, part.row) &&
                        on_grid(seen, part.column + part.right, part.row + part.down) &&
                        (part.right == 0 || part.down == 0 || model.has_diagonals());
    if (!exists) return close();
    part.is_spring() ? read_spring(snapshot, model) : read_mass(snapshot, model);
    remember(snapshot.time);
}

void Readout::read_mass(const Snapshot& snapshot, const Model& model) {
    const auto [column, row, right, down] = *chosen_;
    place_ = snapshot.position.at(column, row);
    std::optional<double> speed;
    if (column < snapshot.velocity.columns() && row < snapshot.velocity.rows())
        speed = glm::length(snapshot.velocity.at(column, row));
    quantities_ = {{"Speed", "m/s", "Of the mass at this moment.", 2, speed},
                   {"Springs' pull", "N", "The sum of what all springs at the mass pull it with.", 3,
                    glm::length(pull_at(snapshot.position, model, column, row))},
                   {"Along the fly, x", "m", "From the upper corner of the hoist, away from the pole.", 3, place_.x},
                   {"Upwards, y", "m", "From the upper corner of the hoist.", 3, place_.y},
                   {"To the front, z", "m", "From the plane in which the flag began.", 3, place_.z}};
}

void Readout::read_spring(const Snapshot& snapshot, const Model& model) {
    const Selection& spring = *chosen_;
    const glm::dvec3 a = snapshot.position.at(spring.column, spring.row);
    const glm::dvec3 b = snapshot.position.at(spring.column + spring.right, spring.row + spring.down);
    place_ = 0.5 * (a + b);
    double force = 0.0;
    pull_of(snapshot.position, model, spring, force);
    const double length = glm::length(b - a), rest = rest_length(model.grid, spring);
    quantities_ = {{"Stretch", "%", "How much longer the spring is than at rest.", 2, 100.0 * (length - rest) / rest},
                   {"Force", "N", "What the spring pulls its two masses together with; negative: it pushes.", 3, force},
                   {"Length", "mm", "From mass to mass.", 2, 1e3 * length}};
}

void Readout::remember(double time) {
    while (!past_.empty() && past_.back().time >= time) past_.pop_back();
    past_.push_back({time, quantities_});
    while (past_.front().time < time - kept) past_.pop_front();
}

std::string Readout::title() const {
    if (!chosen_) return "";
    const auto [column, row, right, down] = *chosen_;
    if (!chosen_->is_spring()) return fmt::format("Mass: column {}, row {}", column, row);
    return fmt::format("Spring: {}, {} to {}, {}", column, row, column + right, row + down);
}

}  // namespace drapeau
