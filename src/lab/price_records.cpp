#include "price_records.hpp"

#include "basis_records.hpp"
#include "report_text.hpp"
#include "scene/file.hpp"

#include <cmath>
#include <stdexcept>

namespace drapeau::lab {

namespace {

Json effect_json(const Effect& effect) {
    if (!effect.is_measured) return {{"remark", effect.remark}};
    return {{"apart", apart_json(effect.apart)}, {"known_to_m", effect.known_to}, {"tip", statistics_json(effect.tip)}};
}

Effect effect_in(const Json& json) {
    Effect effect;
    effect.is_measured = !json.contains("remark");
    if (!effect.is_measured) {
        effect.remark = json.at("remark").get<std::string>();
        return effect;
    }
    effect.apart = apart_in(json.at("apart"));
    effect.known_to = amount(json.at("known_to_m"));
    effect.tip = statistics_in(json.at("tip"));
    if (!std::isfinite(effect.apart.at_end + effect.apart.over_time)) throw std::out_of_range("an unknown effect");
    return effect;
}

Json share_json(const Share& share) {
    return {{"share", share.value}, {"known_to", share.known_to}};
}

/// What is known at all is known to something; nothing saves more than all.
Share share_in(const Json& json) {
    const Share share{number(json.at("share")), amount(json.at("known_to"))};
    const bool is_possible = !std::isfinite(share.value) || share.value <= 1.0;
    if (!is_possible || std::isfinite(share.value) != std::isfinite(share.known_to)) throw std::out_of_range("a share");
    return share;
}

}  // namespace

SweepIdentity identity_of(const PriceOptions& options, const PriceRequest& request) {
    return {"price", DRAPEAU_VERSION, write_scene(request.scene), comparison_json(options)};
}

PriceOptions options_of_price(const SweepIdentity& sweep) {
    PriceOptions options;
    use_options(sweep, [&](const Json& json) { read_comparison_json(json, options); });
    return options;
}

std::vector<std::string> keys_of(const PriceStudy& study) {
    std::vector<std::string> keys;
    for (const ScenePart& part : study.parts()) keys.push_back(part.key);
    return keys;
}

Json basis_json(const PriceStudy& study) {
    Json json = basis_json(study.basis());
    json["dt_s"] = study.dt();
    return json;
}

void restore(PriceStudy& study, const Json& basis) {
    study.restore(basis_in(basis), known_amount(basis.at("dt_s")));
}

Json result_json(const Priced& priced) {
    return {{"effect", effect_json(priced.effect)}, {"dt_s", priced.dt}, {"remark", priced.remark}};
}

Json cost_json(const PartCost& cost) {
    return {{"scene_ms_per_second", cost.scene_ms},
            {"own_step", share_json(cost.own)},
            {"same_step", share_json(cost.same_step)}};
}

Priced priced_in(const PointRecord& record, const ScenePart& part) {
    Priced priced;
    priced.part = part;
    priced.effect = effect_in(record.result.at("effect"));
    priced.dt = amount(record.result.at("dt_s"));
    priced.remark = record.result.at("remark").get<std::string>();
    use_costs(record, [&](const Json& json) {
        const PartCost cost{known_amount(json.at("scene_ms_per_second")), share_in(json.at("own_step")),
                            share_in(json.at("same_step"))};
        if (!(cost.own.known_to >= priced.cost.own.known_to)) priced.cost = cost;
    });
    return priced;
}

Prices prices_in(const Part& part, const PriceStudy& study) {
    Prices prices;
    prices.scene.dt = study.dt();
    for (const ScenePart& of_scene : study.parts())
        use_point(part, of_scene.key, [&](const PointRecord& record) {
            const Priced& priced = prices.parts.emplace_back(priced_in(record, of_scene));
            prices.scene.ms_per_second = std::fmin(prices.scene.ms_per_second, priced.cost.scene_ms);
        });
    return prices;
}

}  // namespace drapeau::lab
