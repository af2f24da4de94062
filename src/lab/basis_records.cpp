#include "basis_records.hpp"

#include "report_text.hpp"

#include <cmath>
#include <stdexcept>

namespace drapeau::lab {

double number(const Json& json) {
    return json.is_null() ? NAN : json.get<double>();
}

double amount(const Json& json) {
    const double value = number(json);
    if (value < 0.0) throw std::out_of_range("a size below zero");
    return value;
}

double known_amount(const Json& json) {
    const double value = amount(json);
    if (!std::isfinite(value)) throw std::out_of_range("a size that is not known");
    return value;
}

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
    return {amount(json.at("at_end_m")), amount(json.at("over_time_m")), amount(json.at("greatest_m")),
            amount(json.at("energy_J")), amount(json.at("stretch"))};
}

TipStatistics statistics_in(const Json& json) {
    const Json& mean = json.at("mean_m");
    return {{number(mean.at(0)), number(mean.at(1)), number(mean.at(2))},
            amount(json.at("mean_error_m")),
            amount(json.at("variance_m2")),
            amount(json.at("variance_error_m2")),
            amount(json.at("mean_hz")),
            amount(json.at("mean_error_hz")),
            amount(json.at("peak_hz")),
            amount(json.at("peak_error_hz"))};
}

Json basis_json(const Basis& basis) {
    Json json{{"begins_s", basis.time},
              {"batches", basis.batches},
              {"shortened", basis.is_shortened},
              {"growth", {{"last_m", basis.growth.last}, {"rate_per_s", basis.growth.rate}}},
              {"tip", statistics_json(basis.tip)},
              {"references", Json::array()}};
    for (const Basis::Reference& r : basis.references)
        json["references"].push_back({{"rk4_steps", r.rk4_steps},
                                      {"leapfrog_steps", r.leapfrog_steps},
                                      {"rk4_error_m", r.rk4_error},
                                      {"leapfrog_error_m", r.leapfrog_error},
                                      {"methods_apart_m", r.methods_apart}});
    return json;
}

Basis basis_in(const Json& json) {
    Basis basis;
    basis.time = known_amount(json.at("begins_s"));
    basis.batches = count(json.at("batches"));
    basis.is_shortened = json.at("shortened");
    basis.growth = {known_amount(json.at("growth").at("last_m")), known_amount(json.at("growth").at("rate_per_s"))};
    basis.tip = statistics_in(json.at("tip"));
    for (const Json& r : json.at("references"))
        basis.references.push_back({count(r.at("rk4_steps")), count(r.at("leapfrog_steps")),
                                    amount(r.at("rk4_error_m")), amount(r.at("leapfrog_error_m")),
                                    amount(r.at("methods_apart_m"))});
    if (basis.references.empty()) throw std::out_of_range("a reference");
    return basis;
}

}  // namespace drapeau::lab
