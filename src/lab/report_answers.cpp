#include "report_answers.hpp"

#include "io/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace drapeau::lab {

namespace {

double number(const Json& json, const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_number() ? found->get<double>() : NAN;
}

std::string text(const Json& json, const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

/// But for the digits of a file.
bool is_same(double a, double b) {
    return std::abs(a - b) <= 1e-9 * std::abs(b);
}

std::string setting(const Json& point) {
    return fmt::format("{} in {} at steps of {}", text(point, "method"), text(point, "precision"),
                       quantity(number(point, "dt"), "s"));
}

}  // namespace

std::vector<std::string> trade_answers(const Json& found, const Scene&) {
    if (!found.is_object()) return {};
    std::vector<std::string> answers;
    const std::string span = quantity(number(found, "seconds"), "s");
    if (text(found, "compared") == "statistics")
        answers.push_back("The motion is chaotic within " + span + ": trajectories mean nothing there, statistics do.");
    else if (const double horizon = number(found, "horizon_s"); std::isfinite(horizon))
        answers.push_back("The motion can be foretold for " + quantity(horizon, "s", 2) +
                          ": what is a nanometre apart is as far apart then as the tolerance.");
    const double tolerance = number(found, "tolerance_m");
    const Json recommended = found.value("recommended", Json());
    if (recommended.is_object() && std::isfinite(tolerance)) {
        const double cost = number(recommended, "ms_per_second");
        answers.push_back(
            fmt::format("Within {} over {} the cheapest setting is {}: {} of processor time a simulated second{}.",
                        quantity(tolerance, "m"), span, setting(recommended), quantity(1e-3 * cost, "s"),
                        cost <= 1000.0 ? ", " + rounded(1000.0 / cost, 2) + " times faster than real time"
                                       : ", slower than real time"));
    } else if (std::isfinite(tolerance)) {
        answers.push_back("No setting measured stays within " + quantity(tolerance, "m") + " over " + span + ".");
    }
    return answers;
}

/// Of the methods that have one, the limit at the scene's own stiffness and damping: the first of each.
std::vector<std::string> stability_answers(const Json& found, const Scene& scene) {
    if (!found.is_object()) return {};
    const Springs springs = model_of(scene).springs;
    std::string limits;
    std::vector<std::string> seen;
    for (const Json& limit : found.value("limits", Json::array())) {
        const std::string method = text(limit, "method");
        const double measured = number(limit, "measured_dt");
        if (!std::isfinite(measured) || std::find(seen.begin(), seen.end(), method) != seen.end()) continue;
        if (!is_same(number(limit, "stiffness"), springs.stiffness) ||
            !is_same(number(limit, "damping"), springs.damping.value_or(0.0)))
            continue;
        seen.push_back(method);
        limits += (limits.empty() ? "" : ", ") + quantity(measured, "s") + " for " + method;
    }
    if (limits.empty()) return {};
    return {"The largest stable step of the cloth at rest is " + limits + "."};
}

std::vector<std::string> price_answers(const Json& found, const Scene&) {
    if (!found.is_object()) return {};
    std::vector<std::string> answers;
    std::vector<Json> terms;
    for (const Json& term : found.value("terms", Json::array()))
        if (number(term, "cost_percent") > number(term, "cost_known_to_percent")) terms.push_back(term);
    std::stable_sort(terms.begin(), terms.end(), [](const Json& a, const Json& b) {
        return number(a, "cost_percent") > number(b, "cost_percent");
    });
    constexpr std::size_t most = 3;
    if (terms.size() > most) terms.resize(most);
    std::string costs;
    for (const Json& term : terms) {
        const double effect = number(term, "effect_rms_m");
        costs += (costs.empty() ? "" : "; ") +
                 fmt::format("without {} it takes {} % less time", text(term, "label"),
                             rounded(number(term, "cost_percent"), 2)) +
                 (std::isfinite(effect) ? " and moves " + quantity(effect, "m", 2) + " off (rms)" : "");
    }
    if (!costs.empty()) answers.push_back("Of the scene's parts: " + costs + ".");
    const Json reduced = found.value("reduced", Json());
    if (reduced.is_object() && reduced.value("holds", false))
        answers.push_back(fmt::format("Within {} it can do without {} of its parts and then takes {} % less time.",
                                      quantity(number(found, "tolerance_m"), "m"), reduced.at("left_out").size(),
                                      rounded(number(reduced, "measured_percent"), 2)));
    else if (reduced.is_object())
        answers.push_back("No part that costs time can be left out within " +
                          quantity(number(found, "tolerance_m"), "m") + ".");
    return answers;
}

std::vector<std::string> converge_answers(const Json& found, const Scene&) {
    if (!found.is_object() || text(found, "conclusion").empty()) return {};
    std::vector<std::string> answers;
    for (std::string left = text(found, "conclusion"); !left.empty();) {
        const auto end = left.find('\n');
        answers.push_back(left.substr(0, end));
        left = end == std::string::npos ? "" : left.substr(end + 1);
    }
    return answers;
}

}  // namespace drapeau::lab
