#include "trade_records.hpp"

#include "basis_records.hpp"
#include "report_text.hpp"
#include "scene/file.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace drapeau::lab {

namespace {

/// Options whose texts belong to the identity.
constexpr TextOption<TradeOptions> texts[] = {{"--methods", &TradeOptions::methods},
                                              {"--precisions", &TradeOptions::precisions},
                                              {"--dt", &TradeOptions::dt},
                                              {"--grids", &TradeOptions::grids},
                                              {"--limits", &TradeOptions::limits}};

constexpr const char* outcomes[] = {"measured", "diverged", "refused", "left out"};

/// Where a point was measured its error is known.
Apart error_in(const Json& json) {
    const Apart error = apart_in(json);
    if (!std::isfinite(error.at_end + error.over_time)) throw std::out_of_range("an error that is not known");
    return error;
}

}  // namespace

SweepIdentity identity_of(const TradeOptions& options, const TradeRequest& request) {
    Json json = texts_json<TradeOptions>(options, texts);
    json.update(comparison_json(options));
    json["--diagonals"] = options.both_diagonals;
    return {"trade", DRAPEAU_VERSION, write_scene(request.scene), json};
}

TradeOptions options_in(const SweepIdentity& sweep) {
    TradeOptions options;
    use_options(sweep, [&](const Json& json) {
        read_texts<TradeOptions>(json, options, texts);
        read_comparison_json(json, options);
        options.both_diagonals = json.at("--diagonals").get<bool>();
    });
    return options;
}

Json result_json(const Measured& measured) {
    Json json{{"outcome", outcomes[static_cast<int>(measured.outcome)]}};
    if (measured.is_measured()) {
        json["error"] = apart_json(measured.error);
        json["error_in_time"] = apart_json(measured.error_in_time);
        json["known_to_m"] = measured.known_to;
        json["tip"] = statistics_json(measured.tip);
    }
    json["force_evaluations"] = measured.force_evaluations;
    json["diverged_after_s"] = measured.diverged_at;
    json["remark"] = measured.remark;
    return json;
}

Json cost_json(const Measured& measured) {
    return {{"ms_per_second", measured.ms_per_second}, {"took_s", measured.first_cost}};
}

Measured measured_in(const PointRecord& record, const TradePoint& point) {
    const Json& json = record.result;
    Measured measured;
    measured.point = point;
    const auto outcome = std::find(std::begin(outcomes), std::end(outcomes), json.at("outcome").get<std::string>());
    if (outcome == std::end(outcomes)) throw std::out_of_range("an outcome");
    measured.outcome = static_cast<Measured::Outcome>(outcome - std::begin(outcomes));
    Apart unknown;
    unknown.at_end = unknown.over_time = unknown.greatest = unknown.energy = unknown.stretch = NAN;
    measured.error = measured.error_in_time = unknown;
    if (measured.is_measured()) {
        measured.error = error_in(json.at("error"));
        measured.error_in_time = apart_in(json.at("error_in_time"));
        measured.known_to = known_amount(json.at("known_to_m"));
        measured.tip = statistics_in(json.at("tip"));
    }
    measured.force_evaluations = json.at("force_evaluations").get<long long>();
    measured.diverged_at = amount(json.at("diverged_after_s"));
    measured.remark = json.at("remark").get<std::string>();
    measured.first_cost = NAN;
    use_costs(record, [&](const Json& cost) {
        const auto time = measured.is_measured() ? known_amount : amount;
        const double ms = time(cost.at("ms_per_second"));
        if (std::isnan(measured.first_cost)) measured.first_cost = known_amount(cost.at("took_s"));
        measured.ms_per_second = std::fmin(measured.ms_per_second, ms);
    });
    if (std::isnan(measured.first_cost)) throw std::out_of_range("a cost");
    return measured;
}

std::vector<std::string> keys_of(const TradeSweep& sweep) {
    std::vector<std::string> keys;
    for (const std::size_t n : sweep.cheapest_first()) keys.push_back(sweep.point(n).key);
    return keys;
}

std::vector<Measured> points_in(const Part& part, const TradeSweep& sweep) {
    std::vector<Measured> points;
    for (std::size_t n = 0; n < sweep.count(); ++n)
        use_point(part, sweep.point(n).key,
                  [&](const PointRecord& record) { points.push_back(measured_in(record, sweep.point(n))); });
    return points;
}

}  // namespace drapeau::lab
