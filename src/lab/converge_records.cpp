#include "converge_records.hpp"

#include "basis_records.hpp"
#include "converge_conclusion.hpp"
#include "run/error_estimate.hpp"
#include "scene/file.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace drapeau::lab {

namespace {

using Flag = StepRung::Flag;
using Kind = ConvergePoint::Kind;

constexpr TextOption<ConvergeOptions> texts[] = {{"--methods", &ConvergeOptions::methods},
                                                 {"--grids", &ConvergeOptions::grids},
                                                 {"--levels", &ConvergeOptions::levels}};

Flag flag_in(const Json& json) {
    for (const Flag flag : {Flag::first, Flag::asymptotic, Flag::pre_asymptotic, Flag::chaos, Flag::limit,
                            Flag::rounding, Flag::diverged})
        if (json.get<std::string>() == name_of(flag)) return flag;
    throw std::out_of_range("a flag");
}

Json steps_json(const MethodConvergence& found) {
    Json json{{"left_out", found.left_out}, {"runs", Json::array()}};
    for (const StepRung& rung : found.rungs)
        json["runs"].push_back({{"steps_a_batch", rung.steps_a_batch},
                                {"difference_m", rung.difference},
                                {"error_m", rung.error},
                                {"order", rung.order},
                                {"alignment", rung.alignment},
                                {"flag", name_of(rung.flag)},
                                {"below_resolution", rung.is_below_resolution}});
    return json;
}

MethodConvergence steps_in(const Json& json, Method method) {
    MethodConvergence found{.method = method,
                            .declared = order_of(method),
                            .rungs = {},
                            .left_out = json.at("left_out").get<std::string>()};
    for (const Json& rung : json.at("runs"))
        found.rungs.push_back({count(rung.at("steps_a_batch")), amount(rung.at("difference_m")),
                               amount(rung.at("error_m")), number(rung.at("order")), number(rung.at("alignment")),
                               flag_in(rung.at("flag")), rung.at("below_resolution").get<bool>()});
    return found;
}

Json level_json(const std::optional<GridLevel>& level) {
    if (!level) return {{"difference_m", nullptr}, {"held", false}};
    Json growth = nullptr;
    if (level->growth) growth = {{"last_m", level->growth->last}, {"rate_per_s", level->growth->rate}};
    return {{"difference_m", level->difference},
            {"compressed_share", level->compressed_share},
            {"fold_wavelength_m", level->fold_wavelength},
            {"fold_cells", level->fold_cells},
            {"error_in_time_m", level->error_in_time},
            {"limit_active", level->is_limit_active},
            {"growth", growth}};
}

/// Nothing if it did not hold.
std::optional<GridLevel> level_in(const Json& json, const std::pair<int, int>& grid) {
    if (json.contains("held")) return {};
    GridLevel level;
    level.columns = grid.first, level.rows = grid.second;
    level.difference = amount(json.at("difference_m"));
    level.compressed_share = known_amount(json.at("compressed_share"));
    level.fold_wavelength = amount(json.at("fold_wavelength_m"));
    level.fold_cells = amount(json.at("fold_cells"));
    level.error_in_time = amount(json.at("error_in_time_m"));
    level.is_limit_active = json.at("limit_active").get<bool>();
    if (const Json& growth = json.at("growth"); !growth.is_null())
        level.growth = {known_amount(growth.at("last_m")), known_amount(growth.at("rate_per_s"))};
    return level;
}

}  // namespace

SweepIdentity identity_of(const ConvergeOptions& options, const ConvergeRequest& request) {
    Json json = texts_json<ConvergeOptions>(options, texts);
    json.update(comparison_json(options));
    return {"converge", DRAPEAU_VERSION, write_scene(request.scene), json};
}

ConvergeOptions options_of_converge(const SweepIdentity& sweep) {
    ConvergeOptions options;
    use_options(sweep, [&](const Json& json) {
        read_texts<ConvergeOptions>(json, options, texts);
        read_comparison_json(json, options);
    });
    return options;
}

std::vector<std::string> keys_of(const std::vector<ConvergePoint>& points) {
    std::vector<std::string> keys;
    for (const ConvergePoint& point : points) keys.push_back(point.key);
    return keys;
}

Json result_of(ConvergeSweep& sweep, const ConvergePoint& point, const std::function<void()>& tick) {
    const GridRequest grids = sweep.counted_grid_request();
    switch (point.kind) {
        case Kind::steps:
            return steps_json(sweep.steps_of(sweep.request().methods[point.place], tick));
        case Kind::grid:
            if (point.place >= affordable_grids(grids)) return level_json({});
            return level_json(converge_at(grids, point.place, tick));
        case Kind::light_borders:
            break;
    }
    const bool is_wanted = wants_light_borders(grids, point.place);
    return {{"difference_m", is_wanted ? light_difference_at(grids, point.place, tick) : NAN}};
}

ConvergeFindings findings_in(const Part& part, const ConvergeSweep& sweep) {
    const ConvergeRequest& request = sweep.request();
    ConvergeFindings found = sweep.found();
    std::vector<std::optional<GridLevel>> levels(request.grids.size());
    for (const ConvergePoint& point : sweep.points())
        use_point(part, point.key, [&](const PointRecord& record) {
            const Json& json = record.result;
            if (point.kind == Kind::steps) found.steps.push_back(steps_in(json, request.methods[point.place]));
            if (point.kind == Kind::grid) levels[point.place] = level_in(json, request.grids[point.place]);
            if (point.kind != Kind::light_borders) return;
            const double difference = amount(json.at("difference_m"));
            if (levels[point.place]) levels[point.place]->light_difference = difference;
        });
    std::vector<GridLevel> held;
    for (std::size_t n = 0; n < levels.size() && levels[n]; ++n) held.push_back(*levels[n]);
    found.grids = converge_from(sweep.counted_grid_request(), std::move(held));
    return found;
}

}  // namespace drapeau::lab
