#include "stability.hpp"

#include "io/error.hpp"
#include "io/terminal.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "lists.hpp"
#include "outputs.hpp"
#include "progress.hpp"
#include "run/engine.hpp"
#include "exit_status.hpp"
#include "scene/file.hpp"
#include "scene/settings.hpp"
#include "stability_limit.hpp"
#include "text_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace drapeau::lab {

namespace {

/// A cloth to measure every method on.
struct Case {
    Scene scene;
    bool is_of_damping = false;  // one of those that differ in damping
};

std::vector<double> values_in(const std::string& option, const std::string& list, const settings::Range& range,
                              const char* unit) {
    std::vector<double> values;
    for (const std::string& item : items_of(list)) values.push_back(number_option(option, item, range, unit));
    return values;
}

Scene with_springs(const Scene& scene, double stiffness, std::optional<double> damping) {
    Scene other = scene;
    other.springs.stiffness = stiffness;
    if (other.springs.diagonal_stiffness) *other.springs.diagonal_stiffness *= stiffness / scene.springs.stiffness;
    other.springs.damping = damping;
    check_scene(other);
    return other;
}

/// Stiffness at the scene's damping, then damping at its stiffness: what was asked for, or from a hundredth to a
/// hundredfold, and from none to a tenth of sqrt(k m).
std::vector<Case> cases_of(const Scene& scene, const StabilityOptions& options) {
    const double k = scene.springs.stiffness, critical = std::sqrt(k * scene.springs.mass);
    auto stiffness = values_in("--stiffness", options.stiffness, settings::stiffness_range, "N/m");
    auto damping = values_in("--damping", options.damping, settings::damping_range, "N s/m");
    if (stiffness.empty())
        for (const double factor : {0.01, 0.1, 1.0, 10.0, 100.0})
            if (settings::stiffness_range.contains(factor * k)) stiffness.push_back(factor * k);
    if (damping.empty()) damping = {0.0, 0.01 * critical, 0.1 * critical};
    std::vector<Case> cases;
    for (const double value : stiffness) cases.push_back({with_springs(scene, value, scene.springs.damping), false});
    for (const double value : damping) cases.push_back({with_springs(scene, k, value), true});
    return cases;
}

std::string measured_text(const StabilityLimit& limit) {
    if (std::isnan(limit.measured)) return "not measured";
    if (std::isinf(limit.measured)) return "above " + quantity(limit.map.back().dt, "s");
    return limit.measured == 0.0 ? "below " + quantity(limit.unseen, "s") : quantity(limit.measured, "s", 4);
}
std::string theory_text(double limit) {
    if (std::isnan(limit)) return "-";
    return std::isinf(limit) ? "every step" : limit == 0.0 ? "none" : quantity(limit, "s", 4);
}
/// How far they are apart, where there are two.
std::string off_text(const StabilityLimit& limit) {
    const bool both = std::isfinite(limit.measured) && limit.measured > 0.0;
    return both || limit.off() != 0.0 ? fmt::format("{:+.2f} %", 100.0 * limit.off()) : "-";
}

/// Growth in a step, at a share of the limit.
std::string growth_text(const StabilityLimit& limit, double share) {
    for (const GrowthAt& at : limit.map)
        if (std::abs(at.dt - share * limit.measured) <= 1e-9 * at.dt)
            return fmt::format("{:+.2f} %", 100.0 * std::expm1(at.per_step));
    return "-";
}

std::string table_of(const std::vector<StabilityLimit>& limits, const std::vector<bool>& is_of_damping) {
    std::string text;
    for (const bool damping : {false, true}) {
        std::vector<Row> rows{{"method", "stiffness", "damping", "measured", "theory", "off", "0.5 x", "0.9 x",
                               "0.99 x", "1.01 x", "1.1 x", "2 x"}};
        for (std::size_t n = 0; n < limits.size(); ++n) {
            if (is_of_damping[n] != damping) continue;
            const StabilityLimit& limit = limits[n];
            rows.push_back({std::string(name_of(limit.method)), quantity(limit.stiffness, "N/m"),
                            quantity(limit.damping, "N·s/m"), measured_text(limit), theory_text(limit.theory),
                            off_text(limit)});
            for (const double share : {0.5, 0.9, 0.99, 1.01, 1.1, 2.0})
                rows.back().push_back(growth_text(limit, share));
        }
        const bool unknown = std::any_of(limits.begin(), limits.end(),
                                         [](const StabilityLimit& limit) { return std::isnan(limit.measured); });
        if (damping && unknown)
            rows.push_back(
                {"(not measured: dampers not in proportion to springs; forward Euler's noise grows too slowly)"});
        text += (damping ? "\nstep and damping\n" : "step and stiffness\n") + aligned(rows);
    }
    return text;
}

nlohmann::ordered_json as_json(const std::string& name, const std::vector<StabilityLimit>& limits) {
    nlohmann::ordered_json json{{"scene", name}};
    auto& list = json["limits"] = nlohmann::ordered_json::array();
    const auto finite = [](double seconds) { return std::isinf(seconds) ? NAN : seconds; };
    for (const StabilityLimit& limit : limits) {
        nlohmann::ordered_json map = nlohmann::ordered_json::array();
        for (const GrowthAt& at : limit.map) map.push_back({{"dt", at.dt}, {"growth_per_step", at.per_step}});
        list.push_back({{"method", name_of(limit.method)},
                        {"stiffness", limit.stiffness},
                        {"damping", limit.damping},
                        {"measured_dt", finite(limit.measured)},
                        {"theory_dt", finite(limit.theory)},
                        {"unlimited", std::isinf(limit.measured)},
                        {"unseen_below_dt", limit.unseen},
                        {"map", map}});
    }
    return json;
}

/// Says beforehand what takes long, and refuses what nobody waits for.
void check_duration(const std::vector<Case>& cases, const std::vector<Method>& methods) {
    constexpr double worth_a_word = 20.0, longest = 24.0 * 3600.0;  // s
    constexpr double unit = 4e-9;                                   // s, of step_cost in double
    constexpr double steps_a_limit = 25.0 * 2000.0;                 // runs of noise, and steps in each, about
    double seconds = 0.0;
    for (const Case& one : cases) {
        const Model model = model_of(one.scene);
        for (const Method method : methods) seconds += steps_a_limit * unit * step_cost(model, method);
    }
    const std::string about =
        "about " + (seconds < 6000.0 ? rounded(seconds / 60.0, 2) + " min" : rounded(seconds / 3600.0, 2) + " h");
    if (seconds > longest)
        throw InputError(
            "stability of this grid takes " + about +
            "; choose a smaller one, such as --set flag.columns=20 --set flag.rows=20, or fewer --methods");
    if (seconds > worth_a_word)
        complain("drapeau-lab", fmt::format("{} limits, {}", cases.size() * methods.size(), about));
}

}  // namespace

int stability(const StabilityOptions& options) {
    std::vector<Assignment> assignments;
    for (const std::string& text : options.set) assignments.push_back(assignment_in(text));
    const auto file = find_scene(options.scene);
    const Scene scene = quiet(read_scene(file, assignments));
    auto methods = names_option<Method>("--methods", options.methods, settings::method_names);
    if (methods.empty())
        for (std::size_t n = 0; n < method_count; ++n) methods.push_back(static_cast<Method>(n));
    const std::vector<Case> cases = cases_of(scene, options);
    const std::vector<NamedFile> outputs = asked_for({{"--json", options.json}});
    check_outputs({{"the scene", file.string()}}, outputs);
    if (scene.flag.attach == Attach::all)
        throw InputError("flag.attach: every mass is held, so there is nothing to measure");

    check_duration(cases, methods);
    std::vector<StabilityLimit> limits;
    std::vector<bool> is_of_damping;
    {
        Progress progress;
        const auto count = static_cast<double>(methods.size() * cases.size());
        for (const Method method : methods)
            for (const Case& one : cases) {
                limits.push_back(stability_limit(one.scene, method));
                is_of_damping.push_back(one.is_of_damping);
                progress.show(static_cast<double>(limits.size()) / count);
            }
    }
    const std::string text =
        scene.name +
        ": the largest step at which noise on the cloth at rest does not grow; then its growth in a step "
        "at shares of that\n" +
        table_of(limits, is_of_damping);
    std::fputs(text.c_str(), place_of_table(outputs));
    if (!options.json.empty())
        write_text_file(options.json,
                        [&](const Append& append) { append(as_json(scene.name, limits).dump(2) + "\n"); });
    return exit_good;
}

}  // namespace drapeau::lab
