#include "converge_sweep.hpp"

#include "io/error.hpp"
#include "io/text.hpp"
#include "measure/clocks.hpp"
#include "measure/swing_in.hpp"
#include "run/simulation.hpp"
#include "scene/file.hpp"

#include "drapeau/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace drapeau::lab {

namespace {

constexpr double for_reference = 0.15, for_grids = 0.5;  // of the budget
constexpr double for_steps = 1.0 - for_reference - for_grids;
constexpr int least_flights = 8;  // of the coarsest reference, that any search takes

}  // namespace

ConvergeSweep::ConvergeSweep(const ConvergeRequest& request)
    : request_(request),
      model_(model_of(request.scene)),
      began_(wall_seconds()),
      stretch_{State<double>(1, 1), 0.0, request.batches, sampling(model_.grid, request.batches)},
      yardstick_(model_) {
    check_that_it_moves(model_);
    unit_ = measured_unit(model_);
    if (request_.counts_work) pace_ = unit_ / counted_unit, unit_ = counted_unit;
    if (const double least = least_of_reference(); least > request_.budget)
        throw InputError(fmt::format(
            "--budget: swinging in and the reference alone take about {} min, and {} min is allowed; allow more, or "
            "compare fewer --seconds",
            rounded(least / 60.0, 2), rounded(request_.budget / 60.0, 3)));
}

double ConvergeSweep::elapsed() const {
    return wall_seconds() - began_;
}

double ConvergeSweep::least_of_reference() const {
    const double step = std::min(stable_step(Rk4{}, model_).seconds(), batch_seconds);
    const double a_second = unit_ * step_cost(model_, method_id<Rk4>) / step;
    return a_second *
           (2.0 * request_.settle + least_flights * 4.0 * static_cast<double>(request_.batches) * batch_seconds);
}

GridRequest ConvergeSweep::grid_request(double seconds) const {
    return {request_.scene,   request_.grids, std::llround(request_.settle / batch_seconds),
            request_.batches, unit_,          seconds};
}
GridRequest ConvergeSweep::counted_grid_request() const {
    return grid_request(for_grids * request_.budget);
}

double ConvergeSweep::estimate() const {
    constexpr double usual_search = 10.0, usual_ladder = 4.0;  // of the least
    const double budget = request_.budget;
    double seconds = std::min(for_reference * budget, usual_search * least_of_reference());
    double steps = 0.0;
    const ReferenceFlight none;
    const Growth unknown;
    Yardstick yardstick(model_);
    const StepGround ground{model_, stretch_, yardstick, none, unknown, unit_, request_.counts_work, {}};
    for (const Method method : request_.methods) {
        const double least = least_seconds(method, ground);
        if (least < for_steps * budget) steps += usual_ladder * least;
    }
    seconds += std::min(for_steps * budget, steps);
    double grids = 0.0;
    for (const double one : seconds_of_flights(grid_request(0.0))) {
        if (seconds + grids + one > budget) break;
        grids += 2.0 * one;  // one of them a nanometre aside
    }
    return pace_ * std::min(budget, seconds + grids);
}

std::optional<std::string> ConvergeSweep::prepare(const std::function<void()>& tick) {
    const SwungIn swung = swing_in(request_.scene, request_.settle, tick);
    if (swung.diverged) return "while it swings in, at rk4's automatic step: " + *swung.diverged;
    stretch_.start = swung.state;
    stretch_.time = swung.time;

    ReferenceLimits limits{0.0, for_reference * request_.budget, tick, request_.counts_work ? unit_ : 0.0};
    found_.growth = find_growth(model_, stretch_, yardstick_, limits);
    if (!request_.batches_are_given && found_.growth.is_seen()) {
        const auto fewer = trusted_batches(found_.horizon());
        found_.is_shortened = fewer < request_.batches;
        request_.batches = std::min(fewer, request_.batches);
        stretch_.batches = request_.batches;
        stretch_.every = sampling(model_.grid, request_.batches);
    }
    found_.seconds = stretch_.seconds();

    const Grid& grid = model_.grid;
    const double size = std::hypot(grid.columns * grid.pitch_x, grid.rows * grid.pitch_y);
    limits.goal = found_.is_beyond_horizon() ? INFINITY : 1e-12 * size;
    found_.reference = find_reference(model_, stretch_, yardstick_, limits);
    return {};
}

StepGround ConvergeSweep::ground(const std::function<void()>& tick) {
    return {model_, stretch_, yardstick_, found_.reference, found_.growth, unit_, request_.counts_work, tick};
}

ConvergeFindings ConvergeSweep::measure(const std::function<void()>& tick) {
    found_.steps = all_methods(ground(tick));
    found_.grids = converge_in_grid(grid_request(std::max(left(), 0.0)), tick);
    return found_;
}

/// The cheapest method first: what it leaves of its share of time goes to the others.
std::vector<MethodConvergence> ConvergeSweep::all_methods(const StepGround& ground) const {
    std::vector<std::size_t> order(request_.methods.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return least_seconds(request_.methods[a], ground) < least_seconds(request_.methods[b], ground);
    });
    std::vector<MethodConvergence> all(order.size());
    for (std::size_t n = 0; n < order.size(); ++n) {
        const double seconds = std::max(0.0, left() - for_grids * request_.budget);
        all[order[n]] =
            converge_in_step(request_.methods[order[n]], ground, seconds / static_cast<double>(order.size() - n));
    }
    return all;
}

std::vector<ConvergePoint> ConvergeSweep::points() const {
    using Kind = ConvergePoint::Kind;
    std::vector<ConvergePoint> points;
    for (std::size_t n = 0; n < request_.methods.size(); ++n)
        points.push_back({Kind::steps, n, std::string(name_of(request_.methods[n]))});
    for (std::size_t n = 0; n < request_.grids.size(); ++n) {
        const std::string grid = fmt::format("{}x{}", request_.grids[n].first, request_.grids[n].second);
        points.push_back({Kind::grid, n, "grid " + grid});
        if (n > 0) points.push_back({Kind::light_borders, n, "light borders " + grid});
    }
    return points;
}

MethodConvergence ConvergeSweep::steps_of(Method method, const std::function<void()>& tick) {
    return converge_in_step(method, ground(tick),
                            for_steps * request_.budget / static_cast<double>(request_.methods.size()));
}

Basis ConvergeSweep::basis() const {
    Basis basis{stretch_.time, stretch_.batches, found_.is_shortened, found_.growth, {}, {}};
    basis.add(found_.reference);
    return basis;
}

void ConvergeSweep::restore(const Basis& basis) {
    stretch_.time = basis.time;
    stretch_.batches = request_.batches = basis.batches;
    found_.is_shortened = basis.is_shortened;
    found_.growth = basis.growth;
    found_.reference = basis.reference(0);
    found_.seconds = stretch_.seconds();
}

}  // namespace drapeau::lab
