#include "grid_convergence.hpp"

#include "grid_flights.hpp"
#include "measure/same_cloth.hpp"

#include "drapeau/stability.hpp"

#include <algorithm>
#include <optional>

namespace drapeau::lab {

namespace {

constexpr double long_enough = 0.05;  // s, that a flight lasts, to tell how fast it was

/// Below this a lower order is not the grid's own, which is 2.
constexpr double second_order = 1.7, any_order = 0.5;

/// Whether no mass on a border moves, so that it does not matter how heavy they are; or they are as light as they
/// should be.
bool is_border_apt(const Model& model) {
    const Grid& grid = model.grid;
    if (model.mass(0, 0) < model.springs.mass) return true;
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            const bool ends_row = grid.columns > 1 && (i == 0 || i == grid.columns - 1);
            const bool ends_column = grid.rows > 1 && (j == 0 || j == grid.rows - 1);
            if ((ends_row || ends_column) && !model.held(i, j)) return false;
        }
    return true;
}

/// Light borders on the last three of the grids: whether borders are what makes the order low.
void try_light_borders(const Grids& grids, std::vector<GridLevel>& levels) {
    std::optional<Seen> before;
    for (std::size_t n = levels.size() - 3; n < levels.size(); ++n) {
        auto now = grids.seen(n, Borders::light, false);
        if (!now) return;
        if (before) levels[n].light_difference = grids.difference(now->flight, before->flight);
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

/// Whether halving the cells shrinks differences: by the last two ratios, as far as there are two. One that is right by
/// chance is none where motions part.
bool is_steady(const GridConvergence& found, const Growth& growth) {
    const std::vector<double> orders = found.orders();
    if (orders.empty() || orders.back() < any_order) return false;
    return orders.size() > 1 ? orders[orders.size() - 2] >= any_order : !growth.is_seen();
}

/// `try_light`: flies the grids with light borders, if there is time.
GridConvergence::Verdict verdict_on(GridConvergence& found, const std::function<void()>& try_light) {
    using Verdict = GridConvergence::Verdict;
    if (found.levels.size() < 3) return Verdict::unknown;
    const GridLevel& finest = found.levels.back();
    const Growth growth = finest_growth(found);
    if (finest.difference <= found.floor) return Verdict::no_matter;
    if (is_steady(found, growth)) {
        if (finest.order >= second_order) return Verdict::converges;
        if (!found.is_border_apt) try_light();
        const bool is_better =
            found.light_order() >= finest.order + 0.3 || found.light_difference() <= 0.1 * finest.difference;
        if (is_better) return Verdict::by_borders;
        return found.is_limit_active() ? Verdict::by_limit : Verdict::slowly;
    }
    if (finest.is_folded_by_compression()) return Verdict::compression;
    return growth.is_seen() ? Verdict::chaos : Verdict::too_coarse;
}

/// The orders of all levels, and what they come to.
void conclude(GridConvergence& found, const Model& coarsest, const std::function<void()>& try_light) {
    for (std::size_t n = 2; n < found.levels.size(); ++n)
        found.levels[n].order = std::log2(found.levels[n - 1].difference / found.levels[n].difference);
    found.is_border_apt = is_border_apt(coarsest);
    found.is_bent = coarsest.bending() != nullptr;
    found.floor = floor_of(coarsest.grid, finest_growth(found));
    found.verdict = verdict_on(found, try_light);
}

GridLevel level_of(const std::pair<int, int>& grid, const Seen& seen) {
    GridLevel level;
    level.columns = grid.first, level.rows = grid.second;
    level.compressed_share = seen.shape.compressed_share();
    level.fold_wavelength = seen.shape.fold_wavelength();
    level.fold_cells = seen.shape.fold_cells();
    level.is_limit_active = seen.is_limit_active;
    return level;
}

/// What is known of a grid by itself, beside its difference: `has_time_for_growth` of a push.
void add_own(const Grids& grids, std::size_t n, const Seen& now, bool has_time_for_growth, GridLevel& level) {
    if (has_time_for_growth)
        if (const auto aside = grids.seen(n, Borders::alike, true))
            level.growth = grids.growth(now.flight, aside->flight);
    if (n == 0)
        if (const auto finer = grids.seen(n, Borders::alike, false, 2))
            level.error_in_time = grids.difference(now.flight, finer->flight);
}

Scene coarsest_of(const GridRequest& request) {
    return same_cloth(request.scene, request.grids.front().first, request.grids.front().second);
}

void leave_out(GridConvergence& found, const GridRequest& request, double slower) {
    const std::vector<double> expected = seconds_of_flights(request);
    for (std::size_t left = found.levels.size(); left < request.grids.size(); ++left)
        found.left_out.push_back({request.grids[left].first, request.grids[left].second, slower * expected[left]});
}

}  // namespace

bool GridLevel::is_folded_by_compression() const {
    constexpr double compressed = 0.05, of_the_grid = 8.0;
    return compressed_share >= compressed && fold_cells <= of_the_grid;
}

bool GridLevel::is_converging() const {
    return order >= any_order;
}

std::vector<double> GridConvergence::orders() const {
    std::vector<double> all;
    for (const GridLevel& level : levels)
        if (std::isfinite(level.order) && level.difference > floor) all.push_back(level.order);
    return all;
}

bool GridConvergence::do_orders_disagree() const {
    constexpr double far = 0.5;
    const std::vector<double> all = orders();
    if (all.empty()) return false;
    const auto [least, most] = std::minmax_element(all.begin(), all.end());
    return *most - *least > far;
}

double GridConvergence::light_order() const {
    if (levels.size() < 2) return NAN;
    return std::log2(levels[levels.size() - 2].light_difference / levels.back().light_difference);
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

std::vector<double> seconds_of_flights(const GridRequest& request) {
    std::vector<double> seconds;
    for (const auto& [columns, rows] : request.grids) {
        const Model model = model_of(same_cloth(request.scene, columns, rows));
        const double steps = static_cast<double>(steps_a_batch(model) * (request.settle + request.batches));
        seconds.push_back(request.unit * step_cost(model, method_id<Rk4>) * steps);
    }
    return seconds;
}

GridConvergence converge_in_grid(const GridRequest& request, const std::function<void()>& tick) {
    const std::vector<double> expected = seconds_of_flights(request);
    const double seconds = request.seconds;
    GridConvergence found;
    Grids grids(request, 1.5 * seconds, tick);
    std::optional<Seen> before;
    double slower = 1.0;  // than expected, as the grid before was
    for (std::size_t n = 0; n < request.grids.size(); ++n) {
        const double began = grids.spent(), flight = slower * expected[n];
        std::optional<Seen> now;
        if (began + flight <= seconds) now = grids.seen(n, Borders::alike, false);
        if (!now) break;
        if (const double spent = grids.spent() - began; spent > long_enough) slower = spent / expected[n];
        GridLevel& level = found.levels.emplace_back(level_of(request.grids[n], *now));
        if (before) level.difference = grids.difference(now->flight, before->flight);
        // The finest grid's own growth, unless it takes more time than there is.
        add_own(grids, n, *now, grids.spent() + slower * expected[n] <= seconds, level);
        before = std::move(now);
    }
    leave_out(found, request, slower);
    double three = 0.0;  // s, of the last three grids
    for (std::size_t n = found.levels.size(); n-- > 0 && n + 3 >= found.levels.size();) three += slower * expected[n];
    conclude(found, grids.coarsest_model(), [&] {
        if (grids.spent() + three <= seconds) try_light_borders(grids, found.levels);
    });
    return found;
}

/// Each takes its own flight, one a nanometre aside and the grid before; the first also one at half the step. With
/// light borders the last two are flown once more, each with the grid before.
std::size_t affordable_grids(const GridRequest& request) {
    const std::vector<double> expected = seconds_of_flights(request);
    double spent = 0.0;
    for (std::size_t n = 0; n < expected.size(); ++n) {
        spent += 2.0 * expected[n] + (n == 0 ? 2.0 * expected[n] : expected[n - 1]);
        double light = 0.0;
        for (std::size_t m = n; m > 0 && m + 2 > n; --m) light += expected[m] + expected[m - 1];
        if (spent + light > request.seconds) return n;
    }
    return expected.size();
}

std::optional<GridLevel> converge_at(const GridRequest& request, std::size_t n, const std::function<void()>& tick) {
    const Grids grids(request, INFINITY, tick);
    const auto now = grids.seen(n, Borders::alike, false);
    if (!now) return {};
    GridLevel level = level_of(request.grids[n], *now);
    if (n > 0) {
        const auto before = grids.seen(n - 1, Borders::alike, false);
        if (!before) return {};
        level.difference = grids.difference(now->flight, before->flight);
    }
    add_own(grids, n, *now, true, level);
    return level;
}

bool wants_light_borders(const GridRequest& request, std::size_t n) {
    const std::size_t flown = affordable_grids(request);
    return flown >= 3 && n < flown && n + 2 >= flown && !is_border_apt(model_of(coarsest_of(request)));
}

double light_difference_at(const GridRequest& request, std::size_t n, const std::function<void()>& tick) {
    const Grids grids(request, INFINITY, tick);
    const auto now = grids.seen(n, Borders::light, false), before = grids.seen(n - 1, Borders::light, false);
    return now && before ? grids.difference(now->flight, before->flight) : NAN;
}

GridConvergence converge_from(const GridRequest& request, std::vector<GridLevel> levels) {
    GridConvergence found;
    found.levels = std::move(levels);
    leave_out(found, request, 1.0);
    conclude(found, model_of(coarsest_of(request)), [] {});
    return found;
}

}  // namespace drapeau::lab
