#include "measure/price_study.hpp"

#include "io/error.hpp"
#include "io/text.hpp"
#include "measure/budget.hpp"
#include "measure/clocks.hpp"
#include "measure/swing_in.hpp"
#include "run/step_choice.hpp"

#include "drapeau/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace drapeau {

namespace {

constexpr double for_flights = 0.6, for_costs = 0.2;  // of the budget

Variant as_given(const Scene& scene) {
    return {fmt::format("{}x{}", scene.flag.columns, scene.flag.rows), "", scene};
}

}  // namespace

PriceStudy::PriceStudy(const PriceRequest& request, Tick tick)
    : request_(request),
      tick_(std::move(tick)),
      parts_(parts_of(request.scene)),
      model_(model_of(request.scene)),
      began_(wall_seconds()) {
    check_that_it_moves(model_);
    chosen_precision(request.scene, model_, chosen_step(request.scene, model_, false, 1.0));  // whether it can be run
    if (parts_.empty()) throw InputError("nothing in this scene can be left out");
    const double step = std::min(stable_step(Rk4{}, model_).seconds(), batch_seconds);
    a_second_ = measured_unit(model_) * step_cost(model_, method_id<Rk4>) / step;

    list_times();
}

/// The scene's reference, and every effect takes about as long. With a tolerance about half as many effects again, and
/// two more references, to confirm and to check what is left.
void PriceStudy::list_times() {
    // At rk4's limit, flights that take as long as the least that a reference, and an effect, may do with.
    constexpr double for_reference = 20.0, for_effect = 7.0;
    constexpr double usual_search = 36.0;  // the same, as it is usually
    constexpr double a_turn = 0.3;         // s, that the cost of one scene takes
    const double parts = static_cast<double>(parts_.size());
    const double a_flight = a_second_ * static_cast<double>(request_.batches) * batch_seconds;
    const double swing = 2.0 * a_second_ * request_.settle;
    const double least = swing + (for_reference + for_effect * parts) * a_flight;
    if (least > request_.budget)
        throw BudgetError("swinging in and the flights with and without each part", least, request_.budget);
    const double searches = 1.0 + (request_.tolerance ? 1.5 * parts + 4.0 : parts);
    search_seconds_ = std::max(for_flights * request_.budget / searches, for_reference * a_flight);
    const double usual = std::min(usual_search * a_flight, search_seconds_);
    estimate_ = std::min(request_.budget, swing + searches * usual + 2.0 * a_turn * (parts + 1.0));
}

double PriceStudy::elapsed() const {
    return wall_seconds() - began_;
}

void PriceStudy::tell() const {
    tick_(std::min(0.99, elapsed() / std::max(estimate_, 1e-3)));
}

double PriceStudy::horizon() const {
    return growth_.horizon(request_.tolerance.value_or(1e-3));
}
bool PriceStudy::is_beyond_horizon() const {
    return horizon() < static_cast<double>(request_.batches) * batch_seconds;
}
TipStatistics PriceStudy::reference_tip() const {
    const Flight& flight = ground_->reference.by_rk4;
    return statistics_of(flight.tip, flight.tip_velocity, batch_seconds);
}

/// m, root mean square: how well motions are to be known. Statistics need no finer steps than those that hold.
double PriceStudy::goal() const {
    constexpr double coarser = 1e5;   // than what double resolves: a ten-millionth of the cloth
    constexpr double finer = 1000.0;  // than the tolerance
    if (is_beyond_horizon()) return INFINITY;
    const double finest = finest_goal(model_);
    return std::max(finest, std::min(coarser * finest, request_.tolerance.value_or(INFINITY) / finer));
}

std::optional<std::string> PriceStudy::prepare() {
    const SwungIn swung = swing_in(request_.scene, request_.settle, [&] { tell(); });
    if (swung.diverged) return swung.diverged;
    Yardstick yardstick(model_);
    const Stretch stretch{swung.state, swung.time, request_.batches, sampling(model_.grid, request_.batches)};
    growth_ = find_growth(model_, stretch, yardstick, {0.0, search_seconds_, [&] { tell(); }});
    if (!request_.batches_are_given && growth_.is_seen()) {
        const long long trusted = trusted_batches(horizon());
        is_shortened_ = trusted < request_.batches;
        request_.batches = std::min(trusted, request_.batches);
    }
    const double before = wall_seconds();
    ground_ = ground_at(swung.state, swung.time);
    reference_seconds_ = wall_seconds() - before;
    return {};
}

Ground PriceStudy::ground_at(const State<double>& start, double time) const {
    Ground ground{as_given(request_.scene),
                  model_,
                  {start, time, request_.batches, sampling(model_.grid, request_.batches)},
                  {},
                  std::make_unique<Yardstick>(model_)};
    ground.reference =
        find_reference(ground.model, ground.stretch, *ground.yardstick, {goal(), search_seconds_, [&] { tell(); }});
    return ground;
}

/// The scene's ground from where another ends.
Ground PriceStudy::after(const Ground& ground) const {
    return ground_at(ground.reference.by_rk4.end, ground.stretch.time + ground.stretch.seconds());
}

Effect PriceStudy::effect(const Scene& scene, const Ground& ground) {
    const double before = wall_seconds();
    Effect found = effect_of(scene, ground, is_beyond_horizon(), [&] {
        tell();
        return may_go_on();
    });
    effect_seconds_ = wall_seconds() - before;
    return found;
}

/// `share`: of the time that all costs may take.
Costs PriceStudy::costs(const std::vector<Scene>& scenes, const Ground& ground, double share) const {
    return costs_of(scenes, ground, share * for_costs * request_.budget, [&] { tell(); });
}

Prices PriceStudy::measure() {
    Prices prices;
    const bool is_given = request_.scene.time.dt.has_value();
    const double dt = step_of(request_.scene, *ground_);
    std::vector<Scene> scenes{request_.scene, at_step(request_.scene, dt)};
    std::vector<std::size_t> places;  // in the scenes: without the part at the scene's step; its own step follows
    for (const ScenePart& part : parts_) {
        Priced& priced = prices.parts.emplace_back();
        priced.part = part;
        priced.remark = part.impossible;
        places.push_back(scenes.size());
        if (!part.impossible.empty()) continue;
        scenes.push_back(at_step(part.without, dt));
        if (!is_given) scenes.push_back(part.without);
    }
    const Costs costs = this->costs(scenes, *ground_, 0.5);
    prices.scene = costs.of.front();
    prices.resolution = costs.resolution;
    if (!prices.scene.remark.empty()) prices.diverged = prices.scene.remark;
    if (prices.diverged) return prices;

    for (std::size_t n = 0; n < parts_.size(); ++n) {
        Priced& priced = prices.parts[n];
        if (!priced.part.impossible.empty()) continue;
        const std::size_t same = places[n], own = is_given ? same : same + 1;
        priced.cost = costs.saved(0, own);
        priced.cost_same_step = is_given ? priced.cost : costs.saved(1, same);
        priced.dt = costs.of[own].dt;
        priced.effect = effect(priced.part.without, *ground_);
        priced.remark = !costs.of[own].remark.empty() ? costs.of[own].remark : priced.effect.remark;
    }
    return prices;
}

}  // namespace drapeau
