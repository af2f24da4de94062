#include "stability_records.hpp"

#include "basis_records.hpp"
#include "lists.hpp"
#include "scene/file.hpp"
#include "scene/settings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <stdexcept>

namespace drapeau::lab {

namespace {

/// Options whose texts belong to the identity.
constexpr TextOption<StabilityOptions> texts[] = {{"--methods", &StabilityOptions::methods},
                                                  {"--stiffness", &StabilityOptions::stiffness},
                                                  {"--damping", &StabilityOptions::damping}};

constexpr const char* every_step = "every step";  // in place of an infinite limit

std::vector<double> values_in(const std::string& option, const std::string& list, const settings::Range& range,
                              const char* unit) {
    std::vector<double> values;
    for (const std::string& item : items_of(list)) values.push_back(number_option(option, item, range, unit));
    return values;
}

Scene with_springs(const Scene& scene, double stiffness, std::optional<double> damping) {
    Scene other = scene;
    if (other.fabric) {
        other.fabric->stretch_modulus *= stiffness / model_of(scene).springs.stiffness;
        other.fabric->damping_time = damping ? std::optional(*damping / stiffness) : std::nullopt;
        return other;  // its springs are within their own range, whatever fabric that is
    }
    other.springs->stiffness = stiffness;
    if (auto& diagonal = other.springs->diagonal_stiffness) *diagonal *= stiffness / scene.springs->stiffness;
    other.springs->damping = damping;
    check_scene(other);
    return other;
}

Json seconds_json(double seconds) {
    return std::isinf(seconds) ? Json(every_step) : Json(seconds);
}
double seconds_in(const Json& json) {
    return json == every_step ? static_cast<double>(INFINITY) : amount(json);
}

}  // namespace

std::vector<StabilityPoint> points_of(const Scene& scene, const StabilityOptions& options) {
    const Springs springs = model_of(scene).springs;
    const double k = springs.stiffness, critical = std::sqrt(k * springs.mass);
    auto methods = names_option<Method>("--methods", options.methods, settings::method_names);
    auto stiffness = values_in("--stiffness", options.stiffness, settings::stiffness_range, "N/m");
    auto damping = values_in("--damping", options.damping, settings::damping_range, "N s/m");
    if (methods.empty())
        for (std::size_t n = 0; n < method_count; ++n) methods.push_back(static_cast<Method>(n));
    if (stiffness.empty())
        for (const double factor : {0.01, 0.1, 1.0, 10.0, 100.0})
            if (settings::stiffness_range.contains(factor * k)) stiffness.push_back(factor * k);
    if (damping.empty()) damping = {0.0, 0.01 * critical, 0.1 * critical};

    std::vector<StabilityPoint> points;
    for (const Method method : methods) {
        for (std::size_t n = 0; n < stiffness.size(); ++n)
            points.push_back({method, with_springs(scene, stiffness[n], springs.damping), false,
                              fmt::format("{} stiffness {}: {} N/m", name_of(method), n + 1, stiffness[n])});
        for (std::size_t n = 0; n < damping.size(); ++n)
            points.push_back({method, with_springs(scene, k, damping[n]), true,
                              fmt::format("{} damping {}: {} N s/m", name_of(method), n + 1, damping[n])});
    }
    return points;
}

SweepIdentity identity_of(const Scene& scene, const StabilityOptions& options) {
    return {"stability", DRAPEAU_VERSION, write_scene(scene), texts_json<StabilityOptions>(options, texts)};
}

StabilityOptions options_of_stability(const SweepIdentity& sweep) {
    StabilityOptions options;
    use_options(sweep, [&](const Json& json) { read_texts<StabilityOptions>(json, options, texts); });
    return options;
}

std::vector<std::string> keys_of(const std::vector<StabilityPoint>& points) {
    std::vector<std::string> keys;
    for (const StabilityPoint& point : points) keys.push_back(point.key);
    return keys;
}

Json result_json(const StabilityLimit& limit) {
    Json map = Json::array();
    for (const GrowthAt& at : limit.map) map.push_back({at.dt, at.per_step});
    return {{"measured_s", seconds_json(limit.measured)},
            {"theory_s", seconds_json(limit.theory)},
            {"unseen_below_s", limit.unseen},
            {"growth", map}};
}

StabilityLimit limit_in(const Json& json, const StabilityPoint& point) {
    const Springs springs = model_of(point.scene).springs;
    StabilityLimit limit{point.method,
                         springs.stiffness,
                         springs.damping.value_or(0.0),
                         seconds_in(json.at("measured_s")),
                         seconds_in(json.at("theory_s")),
                         seconds_in(json.at("unseen_below_s")),
                         {}};
    for (const Json& at : json.at("growth")) limit.map.push_back({known_amount(at.at(0)), number(at.at(1))});
    if (std::isinf(limit.measured) && limit.map.empty()) throw std::out_of_range("growth");
    return limit;
}

std::vector<StabilityLimit> limits_in(const Part& part, const std::vector<StabilityPoint>& points) {
    std::vector<StabilityLimit> limits;
    for (const StabilityPoint& point : points)
        use_point(part, point.key,
                  [&](const PointRecord& record) { limits.push_back(limit_in(record.result, point)); });
    return limits;
}

}  // namespace drapeau::lab
