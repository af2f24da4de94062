// Grid flights: the motion of one cloth on each of ever finer grids, from one smooth start, by rk4 at far smaller steps
// than it needs; seen at the coarsest grid's masses.
#pragma once

#include "cloth_shape.hpp"
#include "grid_convergence.hpp"
#include "measure/clocks.hpp"

#include <functional>
#include <optional>

namespace drapeau::lab {

/// The step, as a number of steps in a batch: its error is nothing beside the grid's.
long long steps_a_batch(const Model& model);

/// What a grid showed, of which only positions at the coarsest grid's masses are kept.
struct Seen {
    Flight flight;
    ClothShape shape;
    bool is_limit_active = false;
};

class Grids {
public:
    /// `seconds`: on the wall, when flights are given up.
    Grids(const GridRequest& request, double seconds, const std::function<void()>& tick);

    const Model& coarsest_model() const { return coarsest_model_; }
    double spent() const { return wall_seconds() - began_; }

    Scene on_grid(std::size_t n) const;
    /// The motion of grid n from the common start, or a nanometre aside, compared after it swung in.
    std::optional<Seen> seen(std::size_t n, Borders borders, bool aside, int finer_steps = 1) const;

    /// m, root mean square over time and the coarsest grid's masses.
    double difference(const Flight& one, const Flight& other) const;
    Growth growth(const Flight& one, const Flight& other) const;

private:
    const GridRequest& request_;
    double seconds_;
    const std::function<void()>& tick_;
    double began_ = wall_seconds();
    Scene coarsest_;
    Model coarsest_model_;
    State<double> start_;
    long long every_;
};

}  // namespace drapeau::lab
