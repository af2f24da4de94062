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
    double light_difference = NAN;  // the same from the grid before, borders being light on both; where it was asked
    double error_in_time = NAN;     // m, of the coarsest grid's motion
    bool is_limit_active = false;   // the stretch limit held masses back
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
        by_limit,     // at a lower order, whatever the borders, and the stretch limit acts
        slowly,       // at a lower order, for no cause that was looked for
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
    bool is_border_apt = false;
    bool is_bent = false;  // something resists bending
    double floor = 0.0;    // m, what rounding leaves of a position: no smaller difference is resolved
    Verdict verdict = Verdict::unknown;

    bool does_converge() const { return verdict <= Verdict::no_matter; }
    bool is_limit_active() const { return !levels.empty() && levels.back().is_limit_active; }
    double order() const { return levels.empty() ? NAN : levels.back().order; }
    /// All that differences above the floor show, the coarsest grids' first.
    std::vector<double> orders() const;
    /// Whether some of them are more than half an order apart.
    bool do_orders_disagree() const;
    double error_in_time() const { return levels.empty() ? NAN : levels.front().error_in_time; }
    /// The last ones with light borders.
    double light_difference() const { return levels.empty() ? NAN : levels.back().light_difference; }  // m
    double light_order() const;
    /// By how much halving the cells once more would change positions (m), if that goes on as it did last.
    double next_difference() const;
    /// How far the coarsest grid is from the limit (m), at most, if that goes on for ever.
    double error_of_coarsest() const;
};

struct GridRequest {
    Scene scene;
    std::vector<std::pair<int, int>> grids;  // each with half the cells of the one before
    long long settle = 0, batches = 30;      // of 1/60 s: before comparing, and compared
    double unit = 0.0;                       // s, of step_cost: as measured, or as work is counted
    double seconds = 0.0;                    // of time on the wall, or of counted work, that all may take
};

/// What one flight on each grid takes, about (s).
std::vector<double> seconds_of_flights(const GridRequest& request);

/// Flies grid after grid while time is expected to last. `tick` is called after every batch.
GridConvergence converge_in_grid(const GridRequest& request, const std::function<void()>& tick);

// The same grid by grid, each by itself, where work is counted: the results are the same wherever they are made.

/// How many of the grids are flown.
std::size_t affordable_grids(const GridRequest& request);
/// One of them; its order is not known yet. Nothing if a value was not finite.
std::optional<GridLevel> converge_at(const GridRequest& request, std::size_t n, const std::function<void()>& tick);
/// Whether the difference by light borders is of use: it may tell why the order of so many grids is low.
bool wants_light_borders(const GridRequest& request, std::size_t n);
/// That difference (m) from the grid before.
double light_difference_at(const GridRequest& request, std::size_t n, const std::function<void()>& tick);
/// What all of them show.
GridConvergence converge_from(const GridRequest& request, std::vector<GridLevel> levels);

}  // namespace drapeau::lab
