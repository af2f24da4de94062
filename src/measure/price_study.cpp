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
#include <numeric>
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
    unit_ = measured_unit(model_);
    if (request_.counts_work) pace_ = unit_ / counted_unit, unit_ = counted_unit;
    if (!request_.counts_work) deadline_ = request_.budget;
    a_second_ = unit_ * step_cost(model_, method_id<Rk4>) / step;

    list_times();
}

/// The scene's reference, and every effect takes about as long. With a tolerance about half as many effects again, and
/// two more references, to confirm and to check what is left.
void PriceStudy::list_times() {
    // At rk4's limit, flights that take as long as the least that a reference, and an effect, may do with.
    constexpr double for_reference = 20.0, for_effect = 7.0;
    constexpr double usual_search = 36.0;  // the same, as it is usually
    const double parts = static_cast<double>(parts_.size());
    const double a_flight = a_second_ * static_cast<double>(request_.batches) * batch_seconds;
    swing_seconds_ = 2.0 * a_second_ * request_.settle;
    const double least = swing_seconds_ + (for_reference + for_effect * parts) * a_flight;
    if (least > request_.budget)
        throw BudgetError("swinging in and the flights with and without each part", least, request_.budget);
    const double searches = 1.0 + (request_.tolerance ? 1.5 * parts + 4.0 : parts);
    search_seconds_ = std::max(for_flights * request_.budget / searches, for_reference * a_flight);
    usual_seconds_ = std::min(usual_search * a_flight, search_seconds_);
}

double PriceStudy::seconds_for(std::size_t count) const {
    constexpr double a_turn = 0.3;  // s, that the cost of one scene takes
    const double parts = static_cast<double>(count);
    const double searches = 1.0 + (request_.tolerance ? 1.5 * parts + 4.0 : parts);
    return pace_ * (swing_seconds_ + searches * usual_seconds_) + 2.0 * a_turn * (parts + 1.0);
}

double PriceStudy::elapsed() const {
    return wall_seconds() - began_;
}

void PriceStudy::tell() const {
    tick_(std::min(0.99, elapsed() / std::max(expected_, 1e-3)));
}

double PriceStudy::horizon() const {
    return growth_.horizon(request_.tolerance.value_or(1e-3));
}
bool PriceStudy::is_beyond_horizon() const {
    return horizon() < static_cast<double>(request_.batches) * batch_seconds;
}
/// m, root mean square: how well motions are to be known. Statistics need no finer steps than those that hold.
double PriceStudy::goal() const {
    constexpr double coarser = 1e5;   // than what double resolves: a ten-millionth of the cloth
    constexpr double finer = 1000.0;  // than the tolerance
    if (is_beyond_horizon()) return INFINITY;
    const double finest = finest_goal(model_);
    return std::max(finest, std::min(coarser * finest, request_.tolerance.value_or(INFINITY) / finer));
}

std::optional<std::string> PriceStudy::prepare(std::size_t parts) {
    expected_ = request_.counts_work ? seconds_for(parts) : estimate();
    const SwungIn swung = swing_in(request_.scene, request_.settle, [&] { tell(); });
    if (swung.diverged) return "while it swings in, at rk4's automatic step: " + *swung.diverged;
    Yardstick yardstick(model_);
    const Stretch stretch{swung.state, swung.time, request_.batches, sampling(model_.grid, request_.batches)};
    growth_ = find_growth(model_, stretch, yardstick,
                          {0.0, search_seconds_, [&] { tell(); }, request_.counts_work ? unit_ : 0.0});
    if (!request_.batches_are_given && growth_.is_seen()) {
        const long long trusted = trusted_batches(horizon());
        is_shortened_ = trusted < request_.batches;
        request_.batches = std::min(trusted, request_.batches);
    }
    const double before = wall_seconds();
    ground_ = ground_at(swung.state, swung.time);
    reference_seconds_ = effect_seconds_ = wall_seconds() - before;
    const Flight& flight = ground_->reference.by_rk4;
    reference_tip_ = statistics_of(flight.tip, flight.tip_velocity, batch_seconds);
    scene_ = as_run(request_.scene, *ground_);
    if (scene_.remark.empty()) return {};
    return "in the time compared, at its own step: " + scene_.remark;
}

Basis PriceStudy::basis() const {
    const Stretch& stretch = ground_->stretch;
    Basis basis{stretch.time, stretch.batches, is_shortened_, growth_, reference_tip_, {}};
    basis.add(ground_->reference);
    return basis;
}

void PriceStudy::restore(const Basis& basis, double dt) {
    scene_.dt = dt;
    request_.batches = basis.batches;
    is_shortened_ = basis.is_shortened;
    growth_ = basis.growth;
    reference_tip_ = basis.tip;
    ground_ = Footing{as_given(request_.scene),
                      model_,
                      {State<double>(1, 1), basis.time, basis.batches, 1},
                      basis.reference(0),
                      nullptr};
}

Footing PriceStudy::ground_at(const State<double>& start, double time) const {
    Footing ground{as_given(request_.scene),
                   model_,
                   {start, time, request_.batches, sampling(model_.grid, request_.batches)},
                   {},
                   std::make_unique<Yardstick>(model_)};
    ground.reference = find_reference(ground.model, ground.stretch, *ground.yardstick,
                                      {goal(), search_seconds_, [&] { tell(); }, request_.counts_work ? unit_ : 0.0});
    return ground;
}

/// The scene's ground from where another ends.
Footing PriceStudy::after(const Footing& ground) const {
    return ground_at(ground.reference.by_rk4.end, ground.stretch.time + ground.stretch.seconds());
}

Effect PriceStudy::effect(const Scene& scene, const Footing& ground) {
    const double before = wall_seconds();
    Effect found = effect_of(scene, ground, is_beyond_horizon(), [&] {
        tell();
        return may_go_on();
    });
    effect_seconds_ = wall_seconds() - before;
    return found;
}

/// `share`: of the time that all costs may take.
Costs PriceStudy::costs(const std::vector<Scene>& scenes, const Footing& ground, double share) const {
    return costs_of(scenes, ground, share * for_costs * request_.budget, [&] { tell(); });
}

std::vector<PartCost> PriceStudy::time(const std::vector<std::size_t>& places) const {
    const bool is_given = request_.scene.time.dt.has_value();
    std::vector<Scene> scenes{request_.scene, at_step(request_.scene, scene_.dt)};
    std::vector<std::size_t> same;  // of each part, in the scenes: without it at the scene's step; its own step follows
    for (const std::size_t n : places) {
        const ScenePart& part = parts_[n];
        same.push_back(scenes.size());
        if (!part.impossible.empty()) continue;
        scenes.push_back(at_step(part.without, scene_.dt));
        if (!is_given) scenes.push_back(part.without);
    }
    const double share = static_cast<double>(places.size()) / static_cast<double>(parts_.size());
    const Costs costs = this->costs(scenes, *ground_, 0.5 * share);
    std::vector<PartCost> found(places.size());
    for (std::size_t n = 0; n < places.size(); ++n) {
        found[n].scene_ms = costs.first();
        if (!parts_[places[n]].impossible.empty()) continue;
        found[n].own = costs.saved(0, is_given ? same[n] : same[n] + 1);
        found[n].same_step = is_given ? found[n].own : costs.saved(1, same[n]);
    }
    return found;
}

Priced PriceStudy::measure_one(std::size_t n) {
    Priced priced;
    priced.part = parts_[n];
    priced.remark = priced.part.impossible;
    if (!priced.remark.empty()) return priced;
    const Cost run = as_run(priced.part.without, *ground_);
    priced.dt = run.dt;
    priced.effect = effect(priced.part.without, *ground_);
    priced.remark = run.remark.empty() ? priced.effect.remark : run.remark;
    return priced;
}

Prices PriceStudy::measure() {
    std::vector<std::size_t> all(parts_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    Prices prices;
    prices.scene = scene_;
    for (const std::size_t n : all) prices.parts.push_back(measure_one(n));
    const std::vector<PartCost> costs = time(all);
    for (const std::size_t n : all) prices.parts[n].cost = costs[n];
    prices.scene.ms_per_second = costs.front().scene_ms;
    return prices;
}

}  // namespace drapeau
