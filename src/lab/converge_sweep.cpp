#include "converge_sweep.hpp"

#include "io/error.hpp"
#include "io/text.hpp"
#include "measure/clocks.hpp"
#include "measure/swing_in.hpp"
#include "run/simulation.hpp"

#include "drapeau/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace drapeau::lab {

namespace {

constexpr double for_reference = 0.15, for_grids = 0.5;  // of the budget
constexpr int least_flights = 8;                         // of the coarsest reference, that any search takes

}  // namespace

ConvergeSweep::ConvergeSweep(const ConvergeRequest& request)
    : request_(request), model_(model_of(request.scene)), began_(wall_seconds()) {
    check_that_it_moves(model_);
    unit_ = measured_unit(model_);
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

GridRequest ConvergeSweep::grid_request() const {
    return {request_.scene, request_.grids, std::llround(request_.settle / batch_seconds), request_.batches};
}

double ConvergeSweep::estimate() const {
    constexpr double usual_search = 10.0, usual_ladder = 4.0;  // of the least
    const double budget = request_.budget;
    double seconds = std::min(for_reference * budget, usual_search * least_of_reference());
    const double for_steps = (1.0 - for_reference - for_grids) * budget;
    double steps = 0.0;
    const ConvergeFindings none;
    Yardstick yardstick(model_);
    const Stretch stretch{State<double>(1, 1), 0.0, request_.batches, 1};
    for (const Method method : request_.methods) {
        const double least = least_seconds(method, ground_of(stretch, yardstick, none));
        if (least < for_steps) steps += usual_ladder * least;
    }
    seconds += std::min(for_steps, steps);
    double grids = 0.0;
    for (const double one : seconds_of_flights(grid_request(), unit_)) {
        if (seconds + grids + one > budget) break;
        grids += 2.0 * one;  // one of them a nanometre aside
    }
    return std::min(budget, seconds + grids);
}

StepGround ConvergeSweep::ground_of(const Stretch& stretch, Yardstick& yardstick, const ConvergeFindings& found) const {
    return {model_, stretch, yardstick, found.reference, found.growth, unit_, {}};
}

ConvergeFindings ConvergeSweep::find(const std::function<void(double)>& tick) {
    ConvergeFindings found;
    const double expected = estimate();
    const auto tell = [&, expected] { tick(std::min(0.99, elapsed() / std::max(expected, 1e-3))); };

    const SwungIn swung = swing_in(request_.scene, request_.settle, tell);
    found.diverged = swung.diverged;
    if (found.diverged) return found;

    Yardstick yardstick(model_);
    Stretch stretch{swung.state, swung.time, request_.batches, sampling(model_.grid, request_.batches)};
    ReferenceLimits limits{0.0, for_reference * request_.budget, tell};
    found.growth = find_growth(model_, stretch, yardstick, limits);
    if (!request_.batches_are_given && found.growth.is_seen()) {
        const auto fewer = trusted_batches(found.horizon());
        found.is_shortened = fewer < request_.batches;
        request_.batches = std::min(fewer, request_.batches);
        stretch.batches = request_.batches;
        stretch.every = sampling(model_.grid, request_.batches);
    }
    found.seconds = stretch.seconds();

    const Grid& grid = model_.grid;
    const double size = std::hypot(grid.columns * grid.pitch_x, grid.rows * grid.pitch_y);
    limits.goal = found.horizon() < found.seconds ? INFINITY : 1e-12 * size;
    found.reference = find_reference(model_, stretch, yardstick, limits);
    StepGround ground = ground_of(stretch, yardstick, found);
    ground.tick = tell;
    found.steps = all_methods(ground);
    found.grids = converge_in_grid(grid_request(), unit_, std::max(left(), 0.0), tell);
    return found;
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

}  // namespace drapeau::lab
