#include "grid_convergence.hpp"

#include "cloth_shape.hpp"
#include "io/error.hpp"
#include "io/text.hpp"
#include "measure/clocks.hpp"
#include "measure/same_cloth.hpp"
#include "measure/swing_in.hpp"
#include "run/start_state.hpp"

#include "drapeau/stability.hpp"

#include <algorithm>
#include <optional>

namespace drapeau::lab {

namespace {

constexpr Method rk4 = method_id<Rk4>;
constexpr double share_of_limit = 0.5;  // the step, of the largest stable one: its error is nothing beside the grid's

long long steps_a_batch(const Model& model) {
    const double dt = std::min(share_of_limit * stable_step(rk4, model).seconds(), batch_seconds / 4.0);
    return static_cast<long long>(std::ceil(batch_seconds / dt));
}

constexpr double long_enough = 0.05;  // s, that a flight lasts, to tell how fast it was

/// What a grid showed, of which only positions at the coarsest grid's masses are kept.
struct Seen {
    Flight flight;
    ClothShape shape;
};

class Grids {
public:
    Grids(const GridRequest& request, double seconds, const std::function<void()>& tick)
        : request_(request),
          seconds_(seconds),
          tick_(tick),
          coarsest_(on_grid(0)),
          coarsest_model_(model_of(coarsest_)),
          start_(start_state(coarsest_).state),
          every_(sampling(coarsest_model_.grid, request.batches)) {}

    const Model& coarsest_model() const { return coarsest_model_; }
    double spent() const { return wall_seconds() - began_; }

    Scene on_grid(std::size_t n) const {
        return same_cloth(request_.scene, request_.grids[n].first, request_.grids[n].second);
    }

    /// The motion of grid n from the common start, or a nanometre aside, compared after it swung in.
    std::optional<Seen> seen(std::size_t n, Borders borders, bool aside, int finer_steps = 1) const {
        const Scene scene = on_grid(n);
        const Model model = model_with(scene, borders);
        const int times = 1 << n;
        const long long steps = finer_steps * steps_a_batch(model);
        Yardstick yardstick(model);
        Stretch stretch{on_finer_grid(start_, times), 0.0, request_.settle, std::max(1LL, request_.settle), times};
        hold_fast(stretch.start, model, scene.flag.prestretch);
        const auto may_go_on = [this] {
            tick_();
            return spent() < 1.5 * seconds_;
        };
        if (request_.settle > 0) {
            auto before = fly(model, rk4, steps, stretch, yardstick, may_go_on);
            if (!before) return {};
            stretch.start = std::move(before->end);
            stretch.time = stretch.seconds();
        }
        stretch.batches = request_.batches;
        stretch.every = every_;
        if (aside) stretch.start = pushed_aside(model, std::move(stretch.start), Growth::first);
        ClothShape shape(model.grid, model.has_diagonals());
        auto flight = fly(model, rk4, steps, stretch, yardstick, may_go_on, Precision::double_precision,
                          [&](const State<double>& state) { shape.take(state); });
        if (!flight) return {};
        return Seen{std::move(*flight), shape};
    }

    /// m, root mean square over time and the coarsest grid's masses.
    double difference(const Flight& one, const Flight& other) const {
        return apart(coarsest_model_, one, other).over_time;
    }

    Growth growth(const Flight& one, const Flight& other) const {
        const Stretch stretch{State<double>(1, 1), 0.0, request_.batches, every_};
        return growth_of(coarsest_model_, stretch, one, other);
    }

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

/// Below this a lower order is not the grid's own, which is 2.
constexpr double second_order = 1.7, any_order = 0.5;

/// Whether no mass on a border moves, so that it does not matter how heavy they are.
bool is_border_held(const Model& model) {
    const Grid& grid = model.grid;
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            const bool ends_row = grid.columns > 1 && (i == 0 || i == grid.columns - 1);
            const bool ends_column = grid.rows > 1 && (j == 0 || j == grid.rows - 1);
            if ((ends_row || ends_column) && !model.held(i, j)) return false;
        }
    return true;
}

/// Light borders on the last three of the grids: whether borders are what makes the order low.
void try_light_borders(const Grids& grids, GridConvergence& found) {
    std::optional<Seen> before;
    double last = NAN;
    for (std::size_t n = found.levels.size() - 3; n < found.levels.size(); ++n) {
        auto now = grids.seen(n, Borders::light, false);
        if (!now) return;
        if (before) {
            found.difference_by_light_borders = grids.difference(now->flight, before->flight);
            found.order_by_light_borders = std::log2(last / found.difference_by_light_borders);
            last = found.difference_by_light_borders;
        }
        before = std::move(now);
    }
}

/// What rounding, which the motion makes grow, leaves of a position (m).
double floor_of(const Grid& grid, const Growth& growth) {
    constexpr double digits = 1e-14;
    const double size = std::hypot(grid.columns * grid.pitch_x, grid.rows * grid.pitch_y);
    return digits * size * std::max(1.0, growth.last / Growth::first);
}

/// The growth on the finest grid that it was measured on.
Growth finest_growth(const GridConvergence& found) {
    for (auto level = found.levels.rbegin(); level != found.levels.rend(); ++level)
        if (level->growth) return *level->growth;
    return {};
}

GridConvergence::Verdict verdict_on(const Grids& grids, GridConvergence& found, bool has_time) {
    using Verdict = GridConvergence::Verdict;
    if (found.levels.size() < 3) return Verdict::unknown;
    const GridLevel& finest = found.levels.back();
    const Growth growth = finest_growth(found);
    if (finest.difference <= floor_of(grids.coarsest_model().grid, growth)) return Verdict::no_matter;
    // One order that is right by chance is none where motions part.
    const bool is_steady =
        !growth.is_seen() || (found.levels.size() > 3 && found.levels[found.levels.size() - 2].is_converging());
    if (finest.is_converging() && is_steady) {
        if (finest.order >= second_order) return Verdict::converges;
        found.is_border_held = is_border_held(grids.coarsest_model());
        if (has_time && !found.is_border_held) try_light_borders(grids, found);
        const bool is_better = found.order_by_light_borders >= finest.order + 0.3 ||
                               found.difference_by_light_borders <= 0.1 * finest.difference;
        return is_better ? Verdict::by_borders : Verdict::slowly;
    }
    if (finest.is_folded_by_compression()) return Verdict::compression;
    return growth.is_seen() ? Verdict::chaos : Verdict::too_coarse;
}

GridLevel level_of(const std::pair<int, int>& grid, const ClothShape& shape) {
    GridLevel level;
    level.columns = grid.first, level.rows = grid.second;
    level.compressed_share = shape.compressed_share();
    level.fold_wavelength = shape.fold_wavelength();
    level.fold_cells = shape.fold_cells();
    return level;
}

}  // namespace

bool GridLevel::is_folded_by_compression() const {
    constexpr double compressed = 0.05, of_the_grid = 8.0;
    return compressed_share >= compressed && fold_cells <= of_the_grid;
}

bool GridLevel::is_converging() const {
    return order >= any_order;
}

double GridConvergence::error_of_coarsest() const {
    double sum = next_difference() / (1.0 - std::pow(2.0, -order()));
    for (const GridLevel& level : levels)
        if (std::isfinite(level.difference)) sum += level.difference;
    return sum;
}

double GridConvergence::next_difference() const {
    return levels.empty() ? NAN : levels.back().difference * std::pow(2.0, -order());
}

std::vector<double> seconds_of_flights(const GridRequest& request, double unit) {
    std::vector<double> seconds;
    for (const auto& [columns, rows] : request.grids) {
        const Model model = model_of(same_cloth(request.scene, columns, rows));
        const double steps = static_cast<double>(steps_a_batch(model) * (request.settle + request.batches));
        seconds.push_back(unit * step_cost(model, rk4) * steps);
    }
    return seconds;
}

GridConvergence converge_in_grid(const GridRequest& request, double unit, double seconds,
                                 const std::function<void()>& tick) {
    const std::vector<double> expected = seconds_of_flights(request, unit);
    GridConvergence found;
    Grids grids(request, seconds, tick);
    std::optional<Seen> before;
    double slower = 1.0;  // than expected, as the grid before was
    for (std::size_t n = 0; n < request.grids.size(); ++n) {
        const double began = grids.spent(), flight = slower * expected[n];
        std::optional<Seen> now;
        if (began + flight <= seconds) now = grids.seen(n, Borders::alike, false);
        if (!now) {
            for (std::size_t left = n; left < request.grids.size(); ++left)
                found.left_out.push_back(
                    {request.grids[left].first, request.grids[left].second, slower * expected[left]});
            break;
        }
        if (const double spent = grids.spent() - began; spent > long_enough) slower = spent / expected[n];
        GridLevel& level = found.levels.emplace_back(level_of(request.grids[n], now->shape));
        if (before) level.difference = grids.difference(now->flight, before->flight);
        if (n > 1) level.order = std::log2(found.levels[n - 1].difference / level.difference);
        // The finest grid's own growth, unless it takes more time than there is.
        if (grids.spent() + slower * expected[n] <= seconds)
            if (const auto aside = grids.seen(n, Borders::alike, true))
                level.growth = grids.growth(now->flight, aside->flight);
        if (n == 0)
            if (const auto finer = grids.seen(n, Borders::alike, false, 2))
                found.error_in_time = grids.difference(now->flight, finer->flight);
        before = std::move(now);
    }
    double three = 0.0;  // s, of the last three grids
    for (std::size_t n = found.levels.size(); n-- > 0 && n + 3 >= found.levels.size();) three += slower * expected[n];
    found.verdict = verdict_on(grids, found, grids.spent() + three <= seconds);
    return found;
}

}  // namespace drapeau::lab
