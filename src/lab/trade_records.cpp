#include "trade_records.hpp"

#include "io/error.hpp"
#include "io/text.hpp"
#include "report_text.hpp"
#include "scene/file.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace drapeau::lab {

namespace {

/// Options whose texts belong to the identity.
constexpr std::pair<const char*, std::string TradeOptions::*> texts[] = {{"--methods", &TradeOptions::methods},
                                                                         {"--precisions", &TradeOptions::precisions},
                                                                         {"--dt", &TradeOptions::dt},
                                                                         {"--grids", &TradeOptions::grids},
                                                                         {"--limits", &TradeOptions::limits},
                                                                         {"--settle", &TradeOptions::settle},
                                                                         {"--seconds", &TradeOptions::seconds},
                                                                         {"--budget", &TradeOptions::budget},
                                                                         {"--tolerance", &TradeOptions::tolerance}};

constexpr const char* outcomes[] = {"measured", "diverged", "refused", "left out"};

double number(const Json& json) {
    return json.is_null() ? NAN : json.get<double>();
}

/// One that is above zero, and small enough for all that is made of it.
long long count(const Json& json) {
    constexpr long long most = 1'000'000'000;
    const auto value = json.get<long long>();
    if (value < 1 || value > most) throw std::out_of_range("a count");
    return value;
}

Json apart_json(const Apart& apart) {
    return {{"at_end_m", apart.at_end},
            {"over_time_m", apart.over_time},
            {"greatest_m", apart.greatest},
            {"energy_J", apart.energy},
            {"stretch", apart.stretch}};
}
Apart apart_in(const Json& json) {
    return {number(json.at("at_end_m")), number(json.at("over_time_m")), number(json.at("greatest_m")),
            number(json.at("energy_J")), number(json.at("stretch"))};
}

TipStatistics statistics_in(const Json& json) {
    const Json& mean = json.at("mean_m");
    return {{number(mean.at(0)), number(mean.at(1)), number(mean.at(2))},
            number(json.at("mean_error_m")),
            number(json.at("variance_m2")),
            number(json.at("variance_error_m2")),
            number(json.at("mean_hz")),
            number(json.at("mean_error_hz")),
            number(json.at("peak_hz")),
            number(json.at("peak_error_hz"))};
}

}  // namespace

SweepIdentity identity_of(const TradeOptions& options, const TradeRequest& request) {
    Json json = Json::object();
    for (const auto& [name, text] : texts) json[name] = options.*text;
    json["--diagonals"] = options.both_diagonals;
    return {"trade", DRAPEAU_VERSION, write_scene(request.scene), json};
}

TradeOptions options_in(const SweepIdentity& sweep) {
    TradeOptions options;
    try {
        for (const auto& [name, text] : texts) options.*text = sweep.options.at(name).get<std::string>();
        options.both_diagonals = sweep.options.at("--diagonals").get<bool>();
    } catch (const Json::exception&) {
        throw InputError("the parts do not say with which options their sweep was made");
    }
    return options;
}

Json basis_json(const TradeBasis& basis) {
    Json json{{"begins_s", basis.time},
              {"batches", basis.batches},
              {"shortened", basis.is_shortened},
              {"growth", {{"last_m", basis.growth.last}, {"rate_per_s", basis.growth.rate}}},
              {"tip", statistics_json(basis.tip)},
              {"references", Json::array()}};
    for (const TradeBasis::Reference& r : basis.references)
        json["references"].push_back({{"rk4_steps", r.rk4_steps},
                                      {"leapfrog_steps", r.leapfrog_steps},
                                      {"rk4_error_m", r.rk4_error},
                                      {"leapfrog_error_m", r.leapfrog_error},
                                      {"methods_apart_m", r.methods_apart}});
    return json;
}

TradeBasis basis_in(const Json& json) {
    TradeBasis basis;
    basis.time = number(json.at("begins_s"));
    basis.batches = count(json.at("batches"));
    basis.is_shortened = json.at("shortened");
    basis.growth = {number(json.at("growth").at("last_m")), number(json.at("growth").at("rate_per_s"))};
    basis.tip = statistics_in(json.at("tip"));
    for (const Json& r : json.at("references"))
        basis.references.push_back({count(r.at("rk4_steps")), count(r.at("leapfrog_steps")),
                                    number(r.at("rk4_error_m")), number(r.at("leapfrog_error_m")),
                                    number(r.at("methods_apart_m"))});
    return basis;
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
        measured.error = apart_in(json.at("error"));
        measured.error_in_time = apart_in(json.at("error_in_time"));
        measured.known_to = number(json.at("known_to_m"));
        measured.tip = statistics_in(json.at("tip"));
    }
    measured.force_evaluations = json.at("force_evaluations").get<long long>();
    measured.diverged_at = number(json.at("diverged_after_s"));
    measured.remark = json.at("remark").get<std::string>();
    measured.first_cost = number(record.costs.at(0).at("took_s"));
    for (const Json& cost : record.costs)
        measured.ms_per_second = std::fmin(measured.ms_per_second, number(cost.at("ms_per_second")));
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
