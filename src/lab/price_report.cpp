#include "price_report.hpp"

#include "io/text.hpp"
#include "reduced_scene.hpp"
#include "report_text.hpp"
#include "saved_scene.hpp"
#include "text_table.hpp"

#include "drapeau/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace drapeau::lab {

namespace {

std::string percent(double share) {
    return std::isfinite(share) ? rounded(100.0 * share, share * share < 1e-2 ? 2 : 3) + " %" : "-";
}

std::string milliseconds(double value) {
    return std::isfinite(value) ? rounded(value, 3) + " ms/s" : "-";
}

std::string span_of(const PriceStudy& study) {
    return quantity(study.ground().stretch.seconds(), "s");
}

Row statistics_cells(const TipStatistics& tip, const TipStatistics& reference) {
    const glm::dvec3 d = tip.mean - reference.mean;
    const double apart = standard_errors_apart(tip, reference);
    return {with_error(std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z), std::hypot(tip.mean_error, reference.mean_error),
                       "mm", 1e3),
            with_error(tip.variance, tip.variance_error, "cm²", 1e4),
            with_error(tip.mean_hertz, tip.mean_hertz_error, "Hz"),
            std::isfinite(apart) ? rounded(apart, 2) + " standard errors" : "-"};
}

Row effect_cells(const PriceStudy& study, const Effect& effect) {
    if (!effect.is_measured) return {"-", "-", "-", "-"};
    if (study.is_beyond_horizon()) return statistics_cells(effect.tip, study.reference_tip());
    return {metres(effect.apart.at_end), metres(effect.apart.over_time), metres(effect.apart.greatest),
            metres(effect.known_to)};
}

Row row_of(const PriceStudy& study, const Priced& priced) {
    Row row{priced.part.label};
    const Row effect = effect_cells(study, priced.effect);
    row.insert(row.end(), effect.begin(), effect.end());
    row.push_back(percent(priced.cost.own));
    row.push_back(percent(priced.cost.same_step));
    row.push_back(std::isfinite(priced.dt) ? quantity(priced.dt, "s") : "-");
    row.push_back(priced.remark);
    return row;
}

std::string rms_text(const Effect& effect) {
    if (!effect.is_measured) return effect.remark;
    return fmt::format("{} at the end, {} over the time", metres(effect.apart.at_end), metres(effect.apart.over_time));
}

std::string dropped_table(const PriceStudy& study, const Reduction& reduction) {
    std::vector<Row> rows{{"left out", "effect so far", "over time", "greatest", "known to", "saves", "saved so far"}};
    for (const Dropped& dropped : reduction.dropped) {
        Row row{dropped.part.label};
        const Row effect = effect_cells(study, dropped.effect);
        row.insert(row.end(), effect.begin(), effect.end());
        row.push_back(percent(dropped.bought));
        row.push_back(percent(dropped.saving));
        rows.push_back(row);
    }
    return aligned(rows);
}

nlohmann::ordered_json effect_json(const PriceStudy& study, const Effect& effect) {
    const double unknown = study.is_beyond_horizon() || !effect.is_measured ? NAN : 1.0;
    nlohmann::ordered_json json{{"effect_rms_m", unknown * effect.apart.at_end},
                                {"effect_max_m", unknown * effect.apart.greatest},
                                {"effect_over_time_m", unknown * effect.apart.over_time},
                                {"known_to_m", unknown * effect.known_to}};
    if (study.is_beyond_horizon() && effect.is_measured) json["statistics"] = statistics_json(effect.tip);
    return json;
}

nlohmann::ordered_json dropped_json(const PriceStudy& study, const Dropped& dropped) {
    nlohmann::ordered_json json{{"term", dropped.part.key}, {"label", dropped.part.label}, {"also", dropped.part.also}};
    json.update(effect_json(study, dropped.effect));
    json["bought_percent"] = 100.0 * dropped.bought.value;
    json["saved_percent"] = 100.0 * dropped.saving.value;
    return json;
}

nlohmann::ordered_json reduction_json(const PriceStudy& study, const Reduction& reduction) {
    nlohmann::ordered_json json{{"holds", holds(study, reduction)}, {"cut_short", reduction.is_cut_short}};
    auto& dropped = json["left_out"] = nlohmann::ordered_json::array();
    for (const Dropped& one : reduction.dropped) dropped.push_back(dropped_json(study, one));
    auto& back = json["put_back"] = nlohmann::ordered_json::array();
    for (const Dropped& one : reduction.put_back) back.push_back(dropped_json(study, one));
    json["nearest"] = reduction.nearest ? dropped_json(study, *reduction.nearest) : nlohmann::ordered_json(nullptr);
    json["confirmed"] = effect_json(study, reduction.confirmed);
    json["check"] = effect_json(study, reduction.check);
    json["promised_percent"] = 100.0 * reduction.promised();
    json["measured_percent"] = 100.0 * reduction.measured.value;
    json["resolution_percent"] = 100.0 * reduction.measured.known_to;
    json["ms_per_second_before"] = reduction.before.ms_per_second;
    json["ms_per_second_after"] = reduction.after.ms_per_second;
    return json;
}

}  // namespace

std::string compared_text(const PriceStudy& study) {
    const Footing& ground = study.ground();
    std::string text = fmt::format("{}: {} compared, after {} to swing in; flown by rk4 in double at {}\n",
                                   ground.variant.scene.name, span_of(study), quantity(ground.stretch.time, "s"),
                                   quantity(batch_seconds / static_cast<double>(ground.reference.rk4_steps), "s"));
    if (!study.is_beyond_horizon())
        text += fmt::format("  so the scene's own motion is {}, which leapfrog confirms\n",
                            known_text(ground.reference.error(), false));
    text += growth_text(study.growth(), study.request().tolerance.value_or(1e-3));
    if (study.is_shortened()) text += shortened_text;
    if (study.is_beyond_horizon())
        text += beyond_text(ground.stretch, study.horizon()) +
                "as given: " + statistics_text(tip_of(ground.model), study.reference_tip());
    return text;
}

std::string parts_table(const PriceStudy& study, const Prices& prices) {
    Row heading{"without"};
    const Row effect = study.is_beyond_horizon() ? Row{"mean tip apart", "variance", "mean frequency", "apart"}
                                                 : Row{"effect", "over time", "greatest", "known to"};
    heading.insert(heading.end(), effect.begin(), effect.end());
    for (const char* cell : {"cost", "at the same step", "step without it", ""}) heading.emplace_back(cell);
    std::vector<Row> rows{heading};
    for (const Priced& priced : prices.parts) rows.push_back(row_of(study, priced));
    return aligned(rows) +
           fmt::format(
               "cost in percent of the whole, {} of CPU a simulated second at steps of {}; ± and <: with 95 % the true "
               "cost is within that\n",
               quantity(1e-3 * prices.scene.ms_per_second, "s"), quantity(prices.scene.dt, "s"));
}

bool holds(const PriceStudy& study, const Reduction& reduction) {
    return !reduction.dropped.empty() && reduction.check.is_within(*study.request().tolerance) &&
           reduction.measured.value > 0.0;
}

std::string reduction_text(const PriceStudy& study, const Reduction& reduction) {
    const std::string tolerance = quantity(*study.request().tolerance, "m"), span = span_of(study);
    std::string text;
    if (reduction.is_cut_short) text += "stopped looking for more: there was no time left in --budget\n";
    for (std::size_t n = 0; n < reduction.put_back.size(); ++n)
        text += fmt::format("not {}: within {} at first, but not in the {} that follow: {}\n",
                            reduction.put_back[n].part.label, tolerance, span, rms_text(reduction.failed[n]));
    if (reduction.dropped.empty()) {
        text += "nothing that saves time that can be measured can be left out within " + tolerance;
        if (reduction.nearest)
            text += fmt::format("; the nearest is {}: {}, known to {}, {} less time", reduction.nearest->part.label,
                                rms_text(reduction.nearest->effect), metres(reduction.nearest->effect.known_to),
                                percent(reduction.nearest->bought));
        return text + "\n";
    }
    text +=
        "within " + tolerance + " (rms) the scene can do without, in this order\n" + dropped_table(study, reduction);
    text += fmt::format("  in the {} that follow: {}\n", span, rms_text(reduction.confirmed));
    text += fmt::format("  check, in the {} after that: {}: {}\n", span, rms_text(reduction.check),
                        reduction.check.is_within(*study.request().tolerance) ? "it holds" : "it does not hold");
    text += fmt::format("  promised {} less time; what is left run as a whole there: {} instead of {}, {} less\n",
                        percent(reduction.promised()), milliseconds(reduction.after.ms_per_second),
                        milliseconds(reduction.before.ms_per_second), percent(reduction.measured));
    return text;
}

std::string reduced_text(const PriceStudy& study, const Reduction& reduction, const std::filesystem::path& file) {
    const std::string span = span_of(study);
    std::vector<LeftOut> left_out;
    for (const Dropped& dropped : reduction.dropped)
        left_out.push_back(
            {as_saved(dropped.part.without, file),
             dropped.alone
                 ? fmt::format("{} less time, {} rms in {}", percent(dropped.bought), metres(*dropped.alone), span)
                 : fmt::format("{} less time, with all else {} rms in {}", percent(dropped.bought),
                               metres(dropped.effect.apart.distance()), span)});
    const Dropped& last = reduction.dropped.back();
    return reduced_scene_text(
        as_saved(study.request().scene, file), left_out,
        {fmt::format("Reduced within {} (rms): {} less time, {} rms in {}, {} in another.",
                     quantity(*study.request().tolerance, "m"), percent(reduction.measured),
                     metres(last.effect.apart.distance()), span, metres(reduction.check.apart.distance()))});
}

nlohmann::ordered_json as_json(const PriceStudy& study, const Prices& prices,
                               const std::optional<Reduction>& reduction) {
    const Footing& ground = study.ground();
    const bool beyond = study.is_beyond_horizon();
    nlohmann::ordered_json json{{"scene", ground.variant.scene.name},
                                {"settle_s", ground.stretch.time},
                                {"seconds", ground.stretch.seconds()},
                                {"compared", beyond ? "statistics" : "trajectories"},
                                {"growth_per_s", study.growth().is_seen() ? study.growth().rate : NAN},
                                {"horizon_s", study.horizon()},
                                {"reference_error_m", beyond ? NAN : ground.reference.error()},
                                {"reference_dt", batch_seconds / static_cast<double>(ground.reference.rk4_steps)},
                                {"ms_per_second", prices.scene.ms_per_second},
                                {"dt", prices.scene.dt}};
    if (beyond) json["statistics"] = statistics_json(study.reference_tip());
    auto& terms = json["terms"] = nlohmann::ordered_json::array();
    for (const Priced& priced : prices.parts) {
        terms.push_back({{"term", priced.part.key},
                         {"label", priced.part.label},
                         {"also", priced.part.also},
                         {"cost_percent", 100.0 * priced.cost.own.value},
                         {"cost_known_to_percent", 100.0 * priced.cost.own.known_to},
                         {"cost_same_step_percent", 100.0 * priced.cost.same_step.value},
                         {"cost_same_step_known_to_percent", 100.0 * priced.cost.same_step.known_to},
                         {"dt_without", priced.dt}});
        terms.back().update(effect_json(study, priced.effect));
        terms.back()["remark"] = priced.remark;
    }
    json["tolerance_m"] = study.request().tolerance.value_or(NAN);
    json["reduced"] = reduction ? reduction_json(study, *reduction) : nlohmann::ordered_json(nullptr);
    return json;
}

}  // namespace drapeau::lab
