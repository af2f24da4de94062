#include "trade_report.hpp"

#include "io/text.hpp"
#include "report_text.hpp"
#include "scene/file.hpp"
#include "text_table.hpp"
#include "trade_records.hpp"

#include "drapeau/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace drapeau::lab {

namespace {

constexpr double real_time = 1000.0;  // ms of processor time a simulated second

std::string milliseconds(double value) {
    return std::isfinite(value) ? rounded(value, 3) + " ms/s" : "-";
}
std::string factor(double ms_per_second) {
    return std::isfinite(ms_per_second) ? rounded(real_time / ms_per_second, 3) + " x" : "-";
}

bool is_on_front(const TradeFindings& findings, std::size_t n) {
    return std::find(findings.front.begin(), findings.front.end(), n) != findings.front.end();
}

std::string remark_on(const TradeSweep& sweep, const TradeFindings& findings, std::size_t n) {
    const Measured& point = findings.points[n];
    switch (point.outcome) {
        case Measured::Outcome::diverged:
            return "diverged after " + quantity(point.diverged_at, "s");
        case Measured::Outcome::refused:
        case Measured::Outcome::left_out:
            return point.remark;
        case Measured::Outcome::measured:
            break;
    }
    std::string remark;
    const auto add = [&](const std::string& text) { remark += (remark.empty() ? "" : ", ") + text; };
    if (is_on_front(findings, n)) add("on the front");
    if (!sweep.is_beyond_horizon() && point.is_below_resolution()) add("below resolution");
    if (point.ms_per_second > real_time) add("slower than real time");
    return remark;
}

std::string label_of(const Variant& variant) {
    return variant.label.empty() ? "as given" : variant.label;
}

Row heading_of(const TradeSweep& sweep) {
    Row row{"method", "step", "precision"};
    if (sweep.variants().size() > 1) row.emplace_back("model");
    const Row rest = sweep.is_beyond_horizon() ? Row{"mean tip apart", "variance", "mean frequency", "apart"}
                                               : Row{"error", "greatest", "energy", "stretch"};
    row.insert(row.end(), rest.begin(), rest.end());
    for (const char* cell : {"CPU", "real time", "evaluations"}) row.emplace_back(cell);
    return row;
}

Row row_of(const TradeSweep& sweep, const Measured& measured) {
    const TradePoint& point = measured.point;
    Row row{std::string(name_of(point.method)), quantity(point.dt(), "s"), std::string(name_of(point.precision))};
    if (sweep.variants().size() > 1) row.push_back(label_of(sweep.variants()[point.variant]));
    if (!measured.is_measured()) {
        row.insert(row.end(), 4, "-");
    } else if (sweep.is_beyond_horizon()) {
        const TipStatistics reference = sweep.reference_tip(), &tip = measured.tip;
        const glm::dvec3 d = tip.mean - reference.mean;
        const double apart = standard_errors_apart(tip, reference);
        row.push_back(with_error(std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z),
                                 std::hypot(tip.mean_error, reference.mean_error), "mm", 1e3));
        row.push_back(with_error(tip.variance, tip.variance_error, "cm²", 1e4));
        row.push_back(with_error(tip.mean_hertz, tip.mean_hertz_error, "Hz"));
        row.push_back(std::isfinite(apart) ? rounded(apart, 2) + " standard errors" : "-");
    } else {
        row.push_back(metres(measured.error.at_end));
        row.push_back(metres(measured.error.greatest));
        row.push_back(quantity(measured.error.energy, "J"));
        row.push_back(rounded(100.0 * measured.error.stretch, 2) + " %");
    }
    row.push_back(milliseconds(measured.ms_per_second));
    row.push_back(factor(measured.ms_per_second));
    row.push_back(measured.is_measured() ? std::to_string(measured.force_evaluations) : "-");
    return row;
}

nlohmann::ordered_json as_json(const TradeSweep& sweep, const Measured& measured) {
    const TradePoint& point = measured.point;
    const Scene& scene = sweep.variants()[point.variant].scene;
    const auto& limit = scene.limits.get<StretchLimit>();
    constexpr const char* outcomes[] = {"measured", "diverged", "refused", "left out"};
    const double unknown = sweep.is_beyond_horizon() ? NAN : 1.0;
    nlohmann::ordered_json json{{"key", point.key},
                                {"method", name_of(point.method)},
                                {"dt", point.dt()},
                                {"precision", name_of(point.precision)},
                                {"columns", scene.flag.columns},
                                {"rows", scene.flag.rows},
                                {"diagonals", scene.diagonals().has_value()},
                                {"limit", limit ? limit->stretch : NAN},
                                {"error_rms_m", unknown * measured.error.at_end},
                                {"error_max_m", unknown * measured.error.greatest},
                                {"error_over_time_m", unknown * measured.error.over_time},
                                {"error_energy_J", unknown * measured.error.energy},
                                {"error_stretch", unknown * measured.error.stretch},
                                {"error_in_time_rms_m", unknown * measured.error_in_time.at_end},
                                {"below_resolution", measured.is_below_resolution()},
                                {"ms_per_second", measured.ms_per_second},
                                {"force_evaluations", measured.force_evaluations},
                                {"diverged", measured.outcome == Measured::Outcome::diverged},
                                {"diverged_after_s", measured.diverged_at},
                                {"outcome", outcomes[static_cast<int>(measured.outcome)]},
                                {"remark", measured.remark}};
    if (sweep.is_beyond_horizon() && measured.is_measured()) json["statistics"] = statistics_json(measured.tip);
    return json;
}

}  // namespace

std::string name_of(const TradePoint& point, const std::vector<Variant>& variants) {
    const std::string& label = variants[point.variant].label;
    return fmt::format("{}, steps of {}, {}{}{}", name_of(point.method), quantity(point.dt(), "s"),
                       name_of(point.precision), label.empty() ? "" : ", ", label);
}

std::string reference_text(const TradeSweep& sweep) {
    const Footing& ground = sweep.grounds().front();
    const ReferenceFlight& reference = ground.reference;
    const Growth& growth = sweep.growth();
    const auto step = [](long long steps) { return quantity(batch_seconds / static_cast<double>(steps), "s"); };
    std::string text = fmt::format("{}: {} compared, after {} to swing in\n", ground.variant.scene.name,
                                   quantity(ground.stretch.seconds(), "s"), quantity(ground.stretch.time, "s"));
    const bool beyond = sweep.is_beyond_horizon();
    text += fmt::format("reference: rk4 in double at {}; leapfrog in double, extrapolated from {} and coarser{}\n",
                        step(reference.rk4_steps), step(reference.leapfrog_steps),
                        beyond ? "" : ", is " + metres(reference.methods_apart) + " from it");
    if (!beyond)
        text += fmt::format("  so the motion is {}; rk4 is judged by leapfrog, all others by rk4\n",
                            known_text(reference.error(), false));
    text += growth_text(growth, sweep.request().tolerance.value_or(1e-3));
    if (sweep.is_shortened()) text += shortened_text;
    if (beyond) {
        text += beyond_text(ground.stretch, sweep.horizon());
        text += "reference: " + statistics_text(tip_of(ground.model), sweep.reference_tip());
    }
    for (std::size_t n = 1; n < sweep.grounds().size(); ++n)
        text += fmt::format("{}: its own reference is {}\n", label_of(sweep.variants()[n]),
                            known_text(sweep.grounds()[n].reference.error(), beyond));
    if (sweep.grounds().size() > 1)
        text +=
            "  errors are from the motion of the scene as given, at its masses (other grids are interpolated to them;\n"
            "  inside the cloth they have as much mass per area and are as stiff)\n";
    return text;
}

std::string points_table(const TradeSweep& sweep, const TradeFindings& findings) {
    std::vector<Row> rows{heading_of(sweep)};
    rows.front().emplace_back("");
    for (std::size_t n = 0; n < findings.points.size(); ++n) {
        if (findings.points[n].outcome == Measured::Outcome::left_out) continue;
        rows.push_back(row_of(sweep, findings.points[n]));
        rows.back().push_back(remark_on(sweep, findings, n));
    }
    std::string text = aligned(rows);
    for (const Measured& point : findings.points)
        if (point.outcome == Measured::Outcome::left_out)
            text += "left out: " + name_of(point.point, sweep.variants()) + ": " + point.remark + "\n";
    return text;
}

std::string front_table(const TradeSweep& sweep, const TradeFindings& findings) {
    if (findings.front.empty())
        return "(empty: no setting's error is ten times what the reference is known to; compare fewer --seconds)\n";
    std::vector<Row> rows{heading_of(sweep)};
    bool is_past = false;
    for (const std::size_t n : findings.front) {
        const Measured& point = findings.points[n];
        if (!is_past && point.ms_per_second > real_time) rows.push_back({"---- slower than real time from here ----"});
        is_past = is_past || point.ms_per_second > real_time;
        rows.push_back(row_of(sweep, point));
    }
    std::string text = aligned(rows);
    if (!is_past) text += "(all of it is faster than real time, 1000 ms of CPU a simulated second)\n";
    return text;
}

std::string orders_text(const TradeSweep& sweep, const TradeFindings& findings) {
    std::string text;
    for (const OrderFit& fit : findings.orders) {
        const std::string& label = sweep.variants()[fit.variant].label;
        text += fmt::format("{}{} {}{}{}", text.empty() ? "orders in double: " : "; ", name_of(fit.method),
                            fmt::format("{:.2f}", fit.order), label.empty() ? "" : " with ", label);
    }
    return text.empty() ? text : text + "\n";
}

nlohmann::ordered_json as_json(const TradeSweep& sweep, const TradeFindings& findings) {
    const bool beyond = sweep.is_beyond_horizon();
    const Footing& ground = sweep.grounds().front();
    nlohmann::ordered_json json{{"scene", ground.variant.scene.name},
                                {"settle_s", ground.stretch.time},
                                {"seconds", ground.stretch.seconds()},
                                {"compared", beyond ? "statistics" : "trajectories"},
                                {"growth_per_s", sweep.growth().is_seen() ? sweep.growth().rate : NAN},
                                {"horizon_s", sweep.horizon()}};
    const auto step = [](long long steps) { return batch_seconds / static_cast<double>(steps); };
    const auto reference_json = [&](const Footing& of) {
        const ReferenceFlight& r = of.reference;
        return nlohmann::ordered_json{{"key", of.variant.key},
                                      {"method", name_of(method_id<Rk4>)},
                                      {"dt", step(r.rk4_steps)},
                                      {"precision", name_of(Precision::double_precision)},
                                      {"error_m", r.error()},
                                      {"error_by_halving_m", r.rk4_error},
                                      {"other_method", name_of(method_id<Leapfrog>)},
                                      {"other_dt", step(r.leapfrog_steps)},
                                      {"other_error_by_halving_m", r.leapfrog_error},
                                      {"methods_apart_m", r.methods_apart}};
    };
    json["reference"] = reference_json(ground);
    if (beyond) json["reference"]["statistics"] = statistics_json(sweep.reference_tip());
    auto& others = json["other_references"] = nlohmann::ordered_json::array();
    for (std::size_t n = 1; n < sweep.grounds().size(); ++n) others.push_back(reference_json(sweep.grounds()[n]));
    auto& points = json["points"] = nlohmann::ordered_json::array();
    for (const Measured& point : findings.points) points.push_back(as_json(sweep, point));
    auto& front = json["front"] = nlohmann::ordered_json::array();
    for (const std::size_t n : findings.front) front.push_back(as_json(sweep, findings.points[n]));
    auto& orders = json["orders"] = nlohmann::ordered_json::array();
    for (const OrderFit& fit : findings.orders)
        orders.push_back({{"method", name_of(fit.method)},
                          {"key", sweep.variants()[fit.variant].key},
                          {"order", fit.order},
                          {"points", fit.points}});
    json["tolerance_m"] = sweep.request().tolerance.value_or(NAN);
    const Recommendation& best = findings.recommended;
    const auto unless_none = [&](const Measured& measured) {
        return best.place ? as_json(sweep, measured) : nlohmann::ordered_json(nullptr);
    };
    json["recommended"] = best.place ? as_json(sweep, findings.points[*best.place]) : nlohmann::ordered_json(nullptr);
    json["confirmed"] = unless_none(best.confirmed);
    json["verified"] = unless_none(best.verified);
    auto& rejected = json["rejected"] = nlohmann::ordered_json::array();
    for (const Measured& measured : best.rejected) rejected.push_back(as_json(sweep, measured));
    return json;
}

}  // namespace drapeau::lab
