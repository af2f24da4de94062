#include "stability.hpp"

#include "gnuplot.hpp"
#include "io/error.hpp"
#include "io/terminal.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "merge.hpp"
#include "outputs.hpp"
#include "program.hpp"
#include "progress.hpp"
#include "run/engine.hpp"
#include "exit_status.hpp"
#include "scene/file.hpp"
#include "stability_plot.hpp"
#include "stability_records.hpp"
#include "text_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace drapeau::lab {

namespace {

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

std::string table_of(const StabilityMap& map) {
    const std::vector<StabilityLimit>& limits = map.limits;
    std::string text;
    for (const bool damping : {false, true}) {
        std::vector<Row> rows{{"method", "stiffness", "damping", "measured", "theory", "off", "0.5 x", "0.9 x",
                               "0.99 x", "1.01 x", "1.1 x", "2 x"}};
        for (std::size_t n = 0; n < limits.size(); ++n) {
            if (map.points[n].is_of_damping != damping) continue;
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
void check_duration(const std::vector<StabilityPoint>& points) {
    constexpr double worth_a_word = 20.0, longest = 24.0 * 3600.0;  // s
    constexpr double unit = 4e-9;                                   // s, of step_cost in double
    constexpr double steps_a_limit = 25.0 * 2000.0;                 // runs of noise, and steps in each, about
    double seconds = 0.0;
    for (const StabilityPoint& point : points)
        seconds += steps_a_limit * unit * step_cost(model_of(point.scene), point.method);
    if (seconds > longest)
        throw InputError(
            "stability of this grid takes about " + duration(seconds) +
            "; choose a smaller one, such as --set flag.columns=20 --set flag.rows=20, fewer --methods, or "
            "one --shard of many");
    if (seconds > worth_a_word)
        complain(program, fmt::format("{}, about {}", counted(points.size(), "limit"), duration(seconds)));
}

int report(const StabilityMap& map, const SweepOutputs& outputs) {
    const std::string text =
        map.scene.name +
        ": the largest step at which noise on the cloth at rest does not grow; then its growth in a step "
        "at shares of that\n" +
        table_of(map);
    std::fputs(text.c_str(), place_of_table(outputs.files()));
    if (!outputs.json.empty())
        write_text_file(outputs.json,
                        [&](const Append& append) { append(as_json(map.scene.name, map.limits).dump(2) + "\n"); });
    if (!outputs.plot.empty()) plot(outputs.plot, stability_script(map));
    return exit_good;
}

/// Those of the points that a shard takes, and of these the ones that the file lacks.
std::vector<StabilityPoint> missing_in(const PartFile* file, const std::vector<StabilityPoint>& points,
                                       const Shard& shard) {
    std::vector<StabilityPoint> missing;
    for (const std::size_t n : shard.places(points.size()))
        if (!(file && file->has(points[n].key))) missing.push_back(points[n]);
    return missing;
}

/// Measures the points one after the other; `take` is given each.
template <class Take>
void measure(const std::vector<StabilityPoint>& points, const Take& take) {
    Progress progress;
    double done = 0.0;
    for (const StabilityPoint& point : points) {
        take(point, stability_limit(point.scene, point.method));
        progress.show(++done / static_cast<double>(points.size()));
    }
}

void check_scene_moves(const Scene& scene) {
    if (scene.flag.attach == Attach::all)
        throw InputError("flag.attach: every mass is held, so there is nothing to measure");
}

int in_parts(StabilityMap& map, const StabilityOptions& options, const SweepOutputs& outputs, const Shard& shard) {
    PartFile file(options.part, identity_of(map.scene, options), shard);
    const std::vector<StabilityPoint> missing = missing_in(&file, map.points, shard);
    complain(program, fmt::format("shard {}: {} of {} to be measured", shard.text(), missing.size(),
                                  counted(missing_in(nullptr, map.points, shard).size(), "limit")));
    measure(missing, [&](const StabilityPoint& point, const StabilityLimit& limit) {
        file.add(point.key, nullptr, result_json(limit));
    });
    if (!shard.is_whole()) return say_shard_is_done(file.part());
    map.limits = limits_in(file.part(), map.points);
    return report(map, outputs);
}

}  // namespace

int stability(const StabilityOptions& options) {
    std::vector<Assignment> assignments;
    for (const std::string& text : options.set) assignments.push_back(assignment_in(text));
    const auto scene_file = find_scene(options.scene);
    StabilityMap map;
    map.scene = quiet(read_scene(scene_file, assignments));
    map.points = points_of(map.scene, options);
    const SweepOutputs outputs{options.json, "", options.plot, scene_file};
    const Shard shard = checked_shard(options.part, outputs);
    check_scene_moves(map.scene);
    check_duration(missing_in(nullptr, map.points, shard));
    if (!options.part.file.empty()) return in_parts(map, options, outputs, shard);
    measure(map.points, [&](const StabilityPoint&, const StabilityLimit& limit) { map.limits.push_back(limit); });
    return report(map, outputs);
}

int merge_stability(const Joined& joined, const MergeOptions& merging) {
    if (!merging.write.empty()) throw InputError("--write: a stability map has no setting to save");
    StabilityMap map;
    map.scene = parse_scene(joined.all.sweep.scene, joined.all.file + ", its scene");
    map.points = points_of(map.scene, options_of_stability(joined.all.sweep));
    check_scene_moves(map.scene);
    if (const auto missing = joined.missing(keys_of(map.points))) {
        complain(program, *missing);
        return exit_not_met;
    }
    map.limits = limits_in(joined.all, map.points);
    return report(map, {merging.json, "", merging.plot, {}});
}

}  // namespace drapeau::lab
