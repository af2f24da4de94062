// Grid convergence: one cloth on grids of ever smaller cells, from one smooth start, and by how much each grid's motion
// differs from the one before; with what is known to prevent convergence measured on every grid.
#pragma once

#include "measure/reference_flight.hpp"
#include "scene/scene.hpp"

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace drapeau::lab {

struct GridLevel {
    int columns = 0, rows = 0;
    double difference = NAN;  // m, root mean square over time and the coarsest grid's masses, from the grid before
    double order = NAN;       // log2 of the ratio of the difference before and this one (Richardson)
    double compressed_share = 0.0;  // of springs
    double fold_wavelength = NAN;   // m; of what is flat NAN
    double fold_cells = NAN;        // the same in distances between masses
    std::optional<Growth> growth;   // of a push of a nanometre on this grid, if there was time

    /// Whether the cloth is compressed and its folds are as fine as the grid.
    bool is_folded_by_compression() const;
    /// Whether its difference is that much smaller than the one before.
    bool is_converging() const;
};

struct GridConvergence {
    enum class Verdict {
        converges,
        by_borders,   // at a lower order, which borders as light as their share of the cloth raise
        slowly,       // at a lower order, whatever the borders, as far as was tried
        no_matter,    // the differences are rounding's
        compression,  // not: compressed cloth folds as finely as the grid lets it
        chaos,        // not: neighbouring motions part
        too_coarse,   // not: for no cause that was looked for
        unknown,      // fewer than three grids
    };

    std::vector<GridLevel> levels;  // the coarsest first
    struct LeftOut {
        int columns, rows;
        double seconds;  // that one flight takes, about
    };
    std::vector<LeftOut> left_out;
    double error_in_time = NAN;  // m, of the coarsest grid's motion
    bool is_border_held = false;
    double order_by_light_borders = NAN;       // the last one, of the same grids
    double difference_by_light_borders = NAN;  // m, the last one
    Verdict verdict = Verdict::unknown;

    bool does_converge() const { return verdict <= Verdict::no_matter; }
    double order() const { return levels.empty() ? NAN : levels.back().order; }
    /// By how much halving the cells once more would change positions (m), if that goes on as it did.
    double next_difference() const;
    /// How far the coarsest grid is from the limit (m), at most, if that goes on for ever.
    double error_of_coarsest() const;
};

struct GridRequest {
    Scene scene;
    std::vector<std::pair<int, int>> grids;  // each with half the cells of the one before
    long long settle = 0, batches = 30;      // of 1/60 s: before comparing, and compared
};

/// What one flight on each grid takes, about (s), `unit` being that of step_cost.
std::vector<double> seconds_of_flights(const GridRequest& request, double unit);

/// Flies grid after grid while `seconds` (on the wall) are expected to last. `tick` is called after every batch.
GridConvergence converge_in_grid(const GridRequest& request, double unit, double seconds,
                                 const std::function<void()>& tick);

}  // namespace drapeau::lab
