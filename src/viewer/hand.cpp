#include "hand.hpp"

#include <algorithm>

namespace drapeau {

namespace {

/// The free mass that is nearest to the one picked, on the flag at rest.
std::optional<Hand::Held> hold_of(const Picked& picked, const FieldBuffer<float>& position, const FlagSettings& flag) {
    const Grid grid = spread(position.columns(), position.rows(), flag.width, flag.height);
    const auto share = [](int n, int count) { return count > 1 ? double(n) / (count - 1) : 0.0; };
    const double across = share(picked.column, grid.columns), down = share(picked.row, grid.rows);
    const auto held = [&](int i, int j) { return is_attached(flag.attach, grid, i, j); };
    const auto free = nearest_free(grid, across, down, held);
    if (!free) return {};
    const auto [column, row] = *free;
    const glm::vec3 place(position.at(column, row));
    return Hand::Held{.column = column,
                      .row = row,
                      .across = share(column, grid.columns),
                      .down = share(row, grid.rows),
                      .plane = place,
                      .target = place};
}

}  // namespace

void Hand::follow(const FieldBuffer<float>& position, const FlagSettings& flag, const Lens& lens, glm::vec3 forward) {
    if (!wants_hold_) return;
    if (!held_) {
        const auto picked = pick(position, lens, mouse_, reach);
        if (picked) held_ = hold_of(*picked, position, flag);
        if (!held_) return let_go();  // it closed on nothing
    }
    if (position.columns() <= held_->column || position.rows() <= held_->row) return let_go();  // another grid
    held_->place = glm::vec3(position.at(held_->column, held_->row));
    held_->target = on_plane(ray_through(lens, mouse_), held_->plane, forward);
}

std::optional<Pull> Hand::pull() const {
    if (!held_) return {};
    return Pull{.across = held_->across, .down = held_->down, .target = glm::dvec3(held_->target)};
}

}  // namespace drapeau
