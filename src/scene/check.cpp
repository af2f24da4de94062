#include "scene/check.hpp"

#include "io/error.hpp"
#include "io/text.hpp"
#include "scene/file.hpp"
#include "scene/material.hpp"
#include "scene/settings.hpp"
#include "scene/surroundings.hpp"

#include <algorithm>

#include <unistd.h>

namespace drapeau {

namespace {

/// A run may take 4 GiB, or what the machine has if that is less.
double memory_allowed() {
    constexpr double most = 4.0 * 1024.0 * 1024.0 * 1024.0;
    const double machine = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    return machine > 0.0 ? std::min(most, machine) : most;
}

/// A value as it was given; one that was computed, and has more digits than anybody types, rounded and with its unit.
template <class Value>
std::string given_text(const Value& value, const settings::About& about) {
    std::string text = settings::value_text(value);
    if constexpr (std::is_same_v<Value, double>) {
        constexpr std::size_t typed_at_most = 15;
        if (text.size() > typed_at_most) text = quantity(value, about.unit);
    }
    return text;
}

std::optional<SceneFault> find_value_out_of_range(const Scene& scene) {
    using namespace settings;
    std::optional<SceneFault> fault;
    each_table(scene, [&](const std::string& table, const auto& settings, const auto& keys) {
        const auto* values = listed(settings);
        if (!values) return;
        each_key(keys, [&](const auto& field) {
            const auto& value = values->*field.member;
            if (fault || is_allowed(value, field.range)) return;
            std::string text;
            if constexpr (requires { value.has_value(); }) {
                text = given_text(*value, field.about);
            } else if constexpr (!std::is_enum_v<std::decay_t<decltype(value)>>) {
                text = given_text(value, field.about);
            }
            fault = SceneFault{table, std::string(field.key), text, allowed_text(field)};
        });
    });
    return fault;
}

/// Springs could not resist as the fabric does in every direction.
std::optional<SceneFault> find_fault_of_cells(const Scene& scene) {
    if (!scene.fabric) return {};
    const FlagSettings& flag = scene.flag;
    if (flag.columns == 1 || flag.rows == 1) {
        return SceneFault{"flag", flag.rows == 1 ? "rows" : "columns", "1",
                          "a fabric has two rows and columns at least; give a chain as [springs]"};
    }
    if (do_cells_fit(scene)) return {};
    const auto grid = fitting_grid(scene);
    const std::string nearest = grid ? "; the nearest grid that has them is " + std::to_string(grid->first) + " x " +
                                           std::to_string(grid->second)
                                     : ", and no grid has them";
    const double longest = longest_cell(*scene.fabric);
    return SceneFault{"fabric", "diagonal_share", shortest(*scene.fabric->diagonal_share),
                      "its springs need cells at most " + rounded(longest, longest < 1.1 ? 5 : 3) +
                          " times as long as wide, or as wide as long" + nearest};
}

/// Ground above what is held would tear at the flag for ever.
std::optional<SceneFault> find_fault_of_ground(const Scene& scene) {
    const auto& ground = scene.limits.get<Ground>();
    const Attach attach = scene.flag.attach;
    if (!ground || attach == Attach::none) return {};
    const bool by_its_top = attach == Attach::top || attach == Attach::corner;
    const double foot = hoisted_height(scene) - (by_its_top ? 0.0 : extent_of(scene.flag).height);
    constexpr double rounding = 1e-9;  // m
    if (ground->height <= foot + rounding) return {};
    return SceneFault{"ground", "height", given_text(ground->height, settings::About{"Ground", "m", ""}),
                      "at most " + rounded(foot, 4) + " m, the lowest that is held of the flag, is allowed"};
}

}  // namespace

std::string SceneFault::text() const {
    const std::string name = table + (table.empty() || key.empty() ? "" : ".") + key;
    if (name.empty()) return allowed;
    return name + (value.empty() ? "" : " = " + one_line(value, 60)) + ": " + allowed;
}

double memory_of(double masses, Precision precision, bool has_added_air) {
    // What a method keeps at most, what terms push with and what contacts remember, the states that a diverged run may
    // return to and is explained from, the pictures' snapshots and a state handed out; and to measure the error
    // (error_estimate.hpp) as much as a method keeps, in double, a state to begin from, three ends and a state handed
    // out.
    const double added_air = has_added_air ? 16 + 4 * 9 : 0;  // what it works with and holds; the latter is kept too
    const double numbers_kept = 3.0 * (max_fields + 2) + 4 * 6 + added_air;
    constexpr double snapshots = 3 * 3 * sizeof(float);
    constexpr double handed_out = 6 * sizeof(double);
    const double number = precision == Precision::double_precision ? sizeof(double) : sizeof(float);
    constexpr double error = (max_fields + 8) * 3 * sizeof(double);
    return masses * (numbers_kept * number + snapshots + handed_out + error);
}

bool feels_wind(const Scene& scene) {
    const auto& air = scene.terms.get<Air>();
    return scene.drag() || (air && (air->pressure || air->skin || air->added));
}

std::optional<SceneFault> find_fault(const Scene& scene) {
    if (!scene.springs && !scene.fabric)
        return SceneFault{"", "", "", "the material is missing: [springs] or [fabric]"};
    if (scene.springs && scene.fabric) {
        return SceneFault{"", "", "", two_materials};
    }
    const FlagSettings& flag = scene.flag;
    const std::string longer_side = flag.columns >= flag.rows ? "columns" : "rows";
    const std::string longer_count = std::to_string(std::max(flag.columns, flag.rows));
    const double masses = std::max(1.0, 1.0 * flag.columns) * std::max(1.0, 1.0 * flag.rows);
    const auto& air = scene.terms.get<Air>();
    const double memory = memory_of(masses, scene.time.precision, air && air->added);
    std::string too_much;
    if (memory > memory_allowed()) {
        too_much = "the grid would take " + memory_text(memory) + " of memory and " + memory_text(memory_allowed()) +
                   " is allowed";
    }

    if (auto fault = find_value_out_of_range(scene)) {
        if (fault->table == "flag" && fault->key == longer_side && !too_much.empty()) fault->allowed += "; " + too_much;
        return fault;
    }
    if (!too_much.empty()) return SceneFault{"flag", longer_side, longer_count, too_much};
    if (flag.columns == 1 && flag.rows == 1) {
        return SceneFault{"flag", "columns", "1",
                          "with one row at least two columns are needed: one mass has no spring"};
    }
    if (scene.time.tolerance && scene.time.dt) {
        return SceneFault{"time", "tolerance", settings::value_text(*scene.time.tolerance),
                          "goes with time.dt = \"auto\" only, and the step is given"};
    }
    if (auto fault = find_fault_of_cells(scene)) return fault;
    if (auto fault = find_fault_of_ground(scene)) return fault;
    if (scene.wind() && !feels_wind(scene)) {
        const std::string drag = scene.fabric ? "fabric.drag_per_area" : "springs.drag";
        return SceneFault{"wind", "", "",
                          "nothing would feel it; give " + drag + " or [air] too, or leave the wind out"};
    }
    return std::nullopt;
}

void check_scene(const Scene& scene) {
    if (const auto fault = find_fault(scene)) throw InputError(fault->text());
}

}  // namespace drapeau
