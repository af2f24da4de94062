#include "measure/trade_sweep.hpp"

#include "io/text.hpp"
#include "measure/budget.hpp"
#include "measure/clocks.hpp"
#include "measure/swing_in.hpp"
#include "run/carry_over.hpp"
#include "run/simulation.hpp"

#include "drapeau/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace drapeau {

namespace {

constexpr double float_share = 0.6;      // of the time that double takes, about
constexpr double for_references = 0.25;  // of the budget
constexpr int least_flights = 8;         // of the coarsest reference, that any search takes
constexpr double usual_search = 20.0;    // of the least

/// How often a point is timed after its error was measured. What takes long needs no more: it is long enough to be
/// steady.
int rounds_for(double seconds) {
    return seconds < 0.1 ? 5 : seconds < 0.5 ? 2 : 1;
}
double with_rounds(double seconds) {
    constexpr double least = 4e-3;  // s, that a round lasts
    return seconds + rounds_for(seconds) * std::max(seconds, least);
}

}  // namespace

TradeSweep::TradeSweep(const TradeRequest& request)
    : request_(request), variants_(variants_of(request.scene, request.choice)) {
    began_ = wall_seconds();
    points_ = points_of(variants_, request_.choice);
    for (const Variant& variant : variants_) models_.push_back(model_of(variant.scene));
    check_that_it_moves(models_.front());
    unit_ = measured_unit(models_.front());
    if (request_.counts_work) pace_ = unit_ / counted_unit, unit_ = counted_unit;
    if (const double least = least_seconds(); least > request_.budget)
        throw BudgetError("swinging in and the reference alone", least, request_.budget);
    list_affordable();
}

double TradeSweep::elapsed() const {
    return wall_seconds() - began_;
}

double TradeSweep::seconds_of(const TradePoint& point) const {
    const double share = point.precision == Precision::double_precision ? 1.0 : float_share;
    return share * unit_ * step_cost(models_[point.variant], point.method) * static_cast<double>(point.steps_a_batch) *
           static_cast<double>(request_.batches);
}

/// What swinging in and the references take at least (s).
double TradeSweep::least_seconds() const {
    double least = 0.0;
    for (const Model& model : models_) {
        const double step = std::min(stable_step(Rk4{}, model).seconds(), batch_seconds);
        const double a_second = unit_ * step_cost(model, method_id<Rk4>) / step;
        if (&model == &models_.front()) least += 2.0 * a_second * request_.settle;
        least += least_flights * 4.0 * a_second * static_cast<double>(request_.batches) * batch_seconds;
    }
    return least;
}

std::vector<std::size_t> TradeSweep::cheapest_first() const {
    std::vector<std::size_t> order(points_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return seconds_of(points_[a]) < seconds_of(points_[b]); });
    return order;
}

double TradeSweep::seconds_of_points(const std::vector<std::size_t>& places) const {
    double seconds = 0.0;
    for (const std::size_t n : places)
        if (!is_left_out_[n]) seconds += pace_ * with_rounds(seconds_of(points_[n]));
    return seconds;
}
double TradeSweep::seconds_of_flight(std::size_t n) const {
    return pace_ * seconds_of(points_[n]);
}
double TradeSweep::seconds_before() const {
    const double least = least_seconds();
    return pace_ * std::min(usual_search * least, std::max(for_references * request_.budget, least));
}

/// The references must fit into the budget, and then as many points as do, the cheapest first.
void TradeSweep::list_affordable() {
    const double least = least_seconds(), most = std::max(for_references * request_.budget, least);
    // Two more to recommend a setting and to check it.
    const double searches = static_cast<double>(variants_.size()) + (request_.tolerance ? 2.0 : 0.0);
    reference_seconds_ = most / searches;
    is_left_out_.assign(points_.size(), 0);
    double spent = 0.0;
    for (const std::size_t n : cheapest_first()) {
        const double seconds = with_rounds(seconds_of(points_[n]));
        is_left_out_[n] = spent + seconds > request_.budget - most;
        if (!is_left_out_[n]) spent += seconds;
    }
    estimate_ = std::min(request_.budget, spent + std::min(usual_search * least, most));
}

std::optional<std::string> TradeSweep::prepare(const Tick& tick) {
    const SwungIn swung =
        swing_in(request_.scene, request_.settle, [&] { tick(std::min(0.99, elapsed() / estimate_)); });
    if (swung.diverged) return swung.diverged;
    const State<double>& settled = swung.state;
    const double time = swung.time;
    find_horizon(settled, time, tick);
    for (const Variant& variant : variants_) {
        const bool is_scene = &variant == &variants_.front();
        grounds_.push_back(
            ground_of(variant, is_scene ? settled : carried_over(settled, variant.scene), time, request_.enough, tick));
    }
    const Flight& flight = grounds_.front().reference.by_rk4;
    reference_tip_ = statistics_of(flight.tip, flight.tip_velocity, batch_seconds);
    return {};
}

void TradeSweep::find_horizon(const State<double>& start, double time, const Tick& tick) {
    const Model& model = models_.front();
    Yardstick yardstick(model);
    growth_ = find_growth(model, stretch_of(model, start, time), yardstick,
                          {0.0, reference_seconds_, [&] { tick(std::min(0.99, elapsed() / estimate_)); },
                           request_.counts_work ? counted_unit : 0.0});
    if (request_.batches_are_given || !growth_.is_seen()) return;
    const long long batches = trusted_batches(horizon());
    if (batches >= request_.batches) return;
    request_.batches = batches;
    is_shortened_ = true;
    list_affordable();
}

Stretch TradeSweep::stretch_of(const Model& model, const State<double>& start, double time) const {
    return {start, time, request_.batches, sampling(model.grid, request_.batches)};
}

Footing TradeSweep::ground_of(const Variant& variant, const State<double>& start, double time, double enough,
                              const Tick& tick) const {
    Model model = model_of(variant.scene);
    // Statistics need no finer steps than those that hold.
    const double goal = is_beyond_horizon() ? INFINITY : std::max(finest_goal(model), enough);
    Footing ground{variant, model, stretch_of(model, start, time), {}, std::make_unique<Yardstick>(model)};
    ground.reference = find_reference(ground.model, ground.stretch, *ground.yardstick,
                                      {goal, reference_seconds_, [&] { tick(std::min(0.99, elapsed() / estimate_)); },
                                       request_.counts_work ? counted_unit : 0.0});
    return ground;
}

double TradeSweep::horizon() const {
    return growth_.horizon(request_.tolerance.value_or(1e-3));
}
bool TradeSweep::is_beyond_horizon() const {
    return horizon() < static_cast<double>(request_.batches) * batch_seconds;
}
std::vector<Measured> TradeSweep::measure(const Tick& tick) {
    std::vector<Measured> all;
    for (const TradePoint& point : points_) all.emplace_back().point = point;
    const std::vector<std::size_t> order = cheapest_first();
    const double check = request_.tolerance ? 2.0 * reference_seconds_ : 0.0;
    const double end = request_.budget - check;
    const double begun = elapsed();
    const auto tell = [&] {
        const double all_of_it = std::clamp(estimate_, begun + 1e-3, request_.budget);
        tick(std::min(0.99, elapsed() / all_of_it));
    };
    for (const std::size_t n : order) {
        Measured& measured = all[n];
        const double seconds = with_rounds(seconds_of(measured.point));
        if (is_left_out_[n] || elapsed() + seconds > end) {
            measured.remark = left_out(n);
            continue;
        }
        measured = measure_errors(measured.point, grounds_[measured.point.variant], grounds_.front(), [&] {
            tell();
            return elapsed() < end;
        });
        tell();
    }
    for (int round = 0; round < rounds_for(0.0); ++round)
        for (const std::size_t n : order) {
            Measured& measured = all[n];
            if (round >= rounds_of(measured) || elapsed() + measured.first_cost > end) continue;
            measured.ms_per_second = std::min(measured.ms_per_second, time_again(measured));
            tell();
        }
    return all;
}

std::string TradeSweep::left_out(std::size_t n) const {
    return fmt::format("it takes about {}, more than --budget leaves",
                       quantity(with_rounds(seconds_of(points_[n])), "s", 2));
}

Measured TradeSweep::measure_one(std::size_t n, const Tick& tick) const {
    Measured measured;
    measured.point = points_[n];
    measured.remark = left_out(n);
    if (is_left_out_[n]) return measured;
    return measure_errors(points_[n], grounds_[points_[n].variant], grounds_.front(), [&] {
        tick(0.0);
        return true;
    });
}

int TradeSweep::rounds_of(const Measured& measured) {
    return measured.is_measured() ? rounds_for(measured.first_cost) : 0;
}
double TradeSweep::time_again(const Measured& measured) const {
    return measure_cost(measured, grounds_[measured.point.variant]);
}

/// The scene's ground from where it ends.
Footing TradeSweep::after(const Footing& scene, const Tick& tick) const {
    constexpr double finer = 300.0;  // than the tolerance: it is all that is asked for
    return ground_of(scene.variant, scene.reference.by_rk4.end, scene.stretch.time + scene.stretch.seconds(),
                     *request_.tolerance / finer, tick);
}

/// The point on a ground of the scene.
Measured TradeSweep::judged(const TradePoint& point, const Footing& scene) const {
    const auto always = [] { return true; };
    if (point.variant == 0) return measure_errors(point, scene, scene, always);
    const Variant& variant = variants_[point.variant];
    const Model& model = models_[point.variant];
    const Stretch& stretch = scene.stretch;
    const Footing own{variant,
                      model,
                      {carried_over(stretch.start, variant.scene), stretch.time, stretch.batches, stretch.every},
                      {},
                      std::make_unique<Yardstick>(model)};
    return measure_errors(point, own, scene, always);
}

Recommendation TradeSweep::recommend(const std::vector<Measured>& points, const Tick& tick) const {
    Recommendation found;
    const double tolerance = *request_.tolerance;
    const std::vector<std::size_t> candidates = all_within(points, tolerance);
    if (candidates.empty()) return found;
    const Footing second = after(grounds_.front(), tick);
    for (const std::size_t n : candidates) {
        found.confirmed = judged(points[n].point, second);
        tick(0.99);
        if (meets(found.confirmed, tolerance)) {
            found.place = n;
            found.verified = judged(points[n].point, after(second, tick));
            break;
        }
        found.rejected.push_back(std::move(found.confirmed));
    }
    return found;
}

}  // namespace drapeau
