// Price reduce: the parts that a scene can do without, one after the other.
#include "measure/clocks.hpp"
#include "measure/price_study.hpp"

#include <algorithm>
#include <utility>

namespace drapeau {

/// A part that may be dropped next, and the effect of all that is left out with it.
struct PriceStudy::Candidate {
    ScenePart part;
    Effect effect;
    std::optional<double> alone;
};

namespace {

/// The grid may be halved again: that is another part.
bool is_same(const ScenePart& a, const ScenePart& b) {
    return a.key == b.key && (a.key != "flag" || a.label == b.label);
}

const Priced* priced(const Prices& prices, const ScenePart& part) {
    const auto found =
        std::find_if(prices.parts.begin(), prices.parts.end(), [&](const Priced& p) { return is_same(p.part, part); });
    return found != prices.parts.end() ? &*found : nullptr;
}

bool is_among(const std::vector<ScenePart>& parts, const ScenePart& part) {
    return std::any_of(parts.begin(), parts.end(), [&](const ScenePart& p) { return is_same(p, part); });
}

/// Where nothing was dropped: the part that saves time and changes the motion least.
std::optional<Dropped> nearest_of(const Prices& prices) {
    const Priced* least = nullptr;
    for (const Priced& p : prices.parts) {
        if (!p.effect.is_measured || !p.cost.own.is_saving()) continue;
        if (!least || p.effect.apart.distance() < least->effect.apart.distance()) least = &p;
    }
    if (!least) return {};
    return Dropped{least->part, least->effect, least->cost.own, least->cost.own, least->effect.apart.distance()};
}

}  // namespace

/// What may be left out of the scene next, the least effect first. What alone is beyond the tolerance is not tried with
/// others.
std::vector<PriceStudy::Candidate> PriceStudy::candidates(const Scene& scene, const Prices& prices,
                                                          const std::vector<ScenePart>& useless) {
    std::vector<Candidate> found;
    for (const ScenePart& part : parts_of(scene)) {
        if (!part.impossible.empty() || is_among(useless, part)) continue;
        Candidate candidate{part, {}, {}};
        if (const Priced* alone = priced(prices, part)) {
            if (!alone->effect.is_within(*request_.tolerance)) continue;
            candidate.alone = alone->effect.apart.distance();
            if (scene == request_.scene) candidate.effect = alone->effect;
        }
        if (!candidate.effect.is_measured) candidate.effect = effect(part.without, *ground_);
        if (candidate.effect.is_within(*request_.tolerance)) found.push_back(std::move(candidate));
    }
    std::stable_sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
        return a.effect.apart.distance() < b.effect.apart.distance();
    });
    return found;
}

/// Drops the candidate of least effect that saves time; false if there is none.
bool PriceStudy::drop_one(Reduction& reduction, const Prices& prices, std::vector<ScenePart>& useless) {
    for (const Candidate& candidate : candidates(reduction.scene, prices, useless)) {
        std::vector<Scene> scenes{request_.scene, candidate.part.without};
        if (!reduction.dropped.empty()) scenes.push_back(reduction.scene);
        const Costs costs = this->costs(scenes, *ground_, 0.15);
        const Share bought = costs.saved(scenes.size() == 3 ? 2 : 0, 1);
        if (!bought.is_saving()) {
            useless.push_back(candidate.part);
            continue;
        }
        reduction.dropped.push_back({candidate.part, candidate.effect, costs.saved(0, 1), bought, candidate.alone});
        reduction.scene = candidate.part.without;
        return true;
    }
    return false;
}

void PriceStudy::confirm(Reduction& reduction) {
    const double tolerance = *request_.tolerance;
    const Footing second = after(*ground_);
    while (!reduction.dropped.empty()) {
        reduction.confirmed = effect(reduction.scene, second);
        if (reduction.confirmed.is_within(tolerance)) break;
        reduction.failed.push_back(reduction.confirmed);
        reduction.put_back.push_back(std::move(reduction.dropped.back()));
        reduction.dropped.pop_back();
        reduction.scene = reduction.dropped.empty() ? request_.scene : reduction.dropped.back().part.without;
    }
    if (reduction.dropped.empty()) return;
    const Footing third = after(second);
    reduction.check = effect(reduction.scene, third);
    const Costs costs = this->costs({request_.scene, reduction.scene}, third, 0.3);
    reduction.before = costs.of[0];
    reduction.after = costs.of[1];
    reduction.measured = costs.saved(0, 1);
}

Reduction PriceStudy::reduce(const Prices& prices) {
    if (request_.counts_work) began_ = wall_seconds(), deadline_ = request_.budget;
    Reduction reduction;
    reduction.scene = request_.scene;
    std::vector<ScenePart> useless;  // within the tolerance, but saves nothing that can be measured
    const auto within = std::count_if(prices.parts.begin(), prices.parts.end(),
                                      [&](const Priced& p) { return p.effect.is_within(*request_.tolerance); });
    for (bool goes_on = within > 0; goes_on;) {
        // In the first round all effects are known.
        const double round = reduction.dropped.empty() ? 0.0 : effect_seconds_ * static_cast<double>(within);
        const double check = 2.0 * (reference_seconds_ + effect_seconds_);
        reduction.is_cut_short = elapsed() + round + check > request_.budget;
        goes_on = !reduction.is_cut_short && drop_one(reduction, prices, useless);
    }
    if (reduction.dropped.empty())
        reduction.nearest = nearest_of(prices);
    else
        confirm(reduction);
    return reduction;
}

}  // namespace drapeau
