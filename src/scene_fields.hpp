// The keys of a scene file, one row each: the row drives reading, writing, checking and every message about the key.
// To add a key, add its member to drapeau/scene.hpp and its row here; to add a table, a tuple of rows and a line in
// each_table.
#pragma once

#include "scene.hpp"
#include "text.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

namespace drapeau::scene_fields {

/// Names of the values of an enumeration, in the enumeration's own order.
inline constexpr std::array<std::string_view, 7> attach_names{"hoist", "grommets", "top", "corner",
                                                              "edges", "all",      "none"};
inline constexpr std::array<std::string_view, 3> start_names{"flat", "hanging", "crumpled"};
inline constexpr std::array<std::string_view, 2> method_names{"forward-euler", "semi-implicit-euler"};
inline constexpr std::array<std::string_view, 2> precision_names{"float", "double"};

inline std::span<const std::string_view> names_of(Attach) {
    return attach_names;
}
inline std::span<const std::string_view> names_of(Start) {
    return start_names;
}
inline std::span<const std::string_view> names_of(Method) {
    return method_names;
}
inline std::span<const std::string_view> names_of(Precision) {
    return precision_names;
}

/// What the format reserves but this version does not have yet: tables, keys and methods.
inline constexpr std::array<std::string_view, 6> later_tables{"fabric", "face_pressure", "bending",
                                                              "ground", "pole",          "limit"};
inline constexpr std::array<std::string_view, 2> later_keys{"wind.travelling", "time.tolerance"};
inline constexpr std::array<std::string_view, 4> later_methods{"leapfrog", "rk4", "implicit-euler", "xpbd"};

/// Numbers from `lowest` to `highest`, both allowed.
struct Range {
    double lowest = 0.0;
    double highest = 0.0;

    bool contains(double value) const { return value >= lowest && value <= highest; }  // false for NaN
};

template <class Settings, class Value>
struct Field {
    std::string_view key;
    Value Settings::*member;
    std::string_view comment;      // one line for the reader of the file, its unit first
    Range range{};                 // of numbers, and of each of three
    std::string_view absent = "";  // the word a file says for an absent optional; without one the key is left out
    bool required = false;         // the file must say it
};
template <class Settings, class Value, class... Rest>
Field(std::string_view, Value Settings::*, Rest...) -> Field<Settings, Value>;

// A seed is any whole number that TOML can hold.
inline constexpr std::int64_t greatest_seed = std::numeric_limits<std::int64_t>::max();

inline constexpr std::tuple scene_keys{
    Field{"name", &Scene::name, "shown in the window's title"},
};

inline constexpr std::tuple flag_keys{
    Field{"columns", &FlagSettings::columns, "masses along the fly, away from the pole", Range{1, 4096}},
    Field{"rows", &FlagSettings::rows, "masses along the hoist, down the pole", Range{1, 4096}},
    Field{"width", &FlagSettings::width, "m, along the fly", Range{1e-3, 1e3}},
    Field{"height", &FlagSettings::height, "m, along the hoist", Range{1e-3, 1e3}},
    Field{"attach", &FlagSettings::attach, "hoist, grommets (the two hoist corners), top, corner, edges, all or none"},
    Field{"start", &FlagSettings::start, "flat, hanging (settled without wind) or crumpled"},
    Field{"prestretch", &FlagSettings::prestretch, "share; 0.1 starts 10 % longer than rest", Range{-0.9, 10}},
    Field{"texture", &FlagSettings::texture, "picture, beside this file or in assets/flags"},
};

inline constexpr std::tuple springs_keys{
    Field{"mass", &SpringSettings::mass, "kg, of every mass", Range{1e-9, 1e3}, "", true},
    Field{"stiffness", &SpringSettings::stiffness, "N/m, of springs between side neighbours", Range{1e-9, 1e9}, "",
          true},
    Field{"diagonal_stiffness", &SpringSettings::diagonal_stiffness, "N/m, of springs between diagonal neighbours",
          Range{1e-9, 1e9}},
    Field{"damping", &SpringSettings::damping, "N s/m, along every spring", Range{0, 1e6}},
    Field{"drag", &SpringSettings::drag, "N s/m, of every mass against the air", Range{0, 1e6}},
    Field{"friction", &SpringSettings::friction, "N s/m, of every mass, whatever the air does", Range{0, 1e6}},
};

inline constexpr std::tuple gravity_keys{
    Field{"acceleration", &GravitySettings::acceleration, "m/s2; y is up", Range{-1e4, 1e4}},
};

inline constexpr std::tuple wind_keys{
    Field{"velocity", &WindSettings::velocity, "m/s, the mean; x away from the pole, y up, z towards the viewer",
          Range{-1e6, 1e6}},
    Field{"gusts", &WindSettings::gusts, "m/s, rms on each axis", Range{0, 1e6}},
    Field{"period", &WindSettings::period, "s, how fast gusts change", Range{1e-3, 1e6}},
    Field{"seed", &WindSettings::seed, "another number, other gusts", Range{0, static_cast<double>(greatest_seed)}},
};

inline constexpr std::tuple time_keys{
    Field{"method", &TimeSettings::method, "forward-euler or semi-implicit-euler"},
    Field{"dt", &TimeSettings::dt, "s; \"auto\" is the largest step known to be stable", Range{1e-9, 1e3}, "auto"},
    Field{"precision", &TimeSettings::precision, "float or double"},
};

inline constexpr std::tuple view_keys{
    Field{"texture", &ViewSettings::texture, "the picture on the cloth"},
    Field{"cloth", &ViewSettings::cloth, "the cloth itself"},
    Field{"springs", &ViewSettings::springs, "springs as lines"},
    Field{"forces", &ViewSettings::forces, "springs coloured by their force"},
    Field{"masses", &ViewSettings::masses, "masses as points"},
    Field{"texture_proportions", &ViewSettings::texture_proportions, "the flag takes the proportions of its picture"},
};

/// Calls visit(table name, settings or optional settings, its keys, whether a file must have it) in the order of a
/// file. The keys before the first table have the name "".
template <class AnyScene, class Visit>
void each_table(AnyScene& scene, Visit&& visit) {
    visit("", scene, scene_keys, false);
    visit("flag", scene.flag, flag_keys, false);
    visit("springs", scene.springs, springs_keys, true);
    visit("gravity", scene.gravity, gravity_keys, false);
    visit("wind", scene.wind, wind_keys, false);
    visit("time", scene.time, time_keys, false);
    visit("view", scene.view, view_keys, false);
}

template <class Keys, class Visit>
void each_field(const Keys& keys, Visit&& visit) {
    std::apply([&](const auto&... field) { (visit(field), ...); }, keys);
}

template <class Keys>
std::vector<std::string_view> names_in(const Keys& keys) {
    std::vector<std::string_view> names;
    each_field(keys, [&](const auto& field) { names.push_back(field.key); });
    return names;
}

/// Settings a scene may list or not, seen alike: a pointer, null when not listed.
template <class Settings>
auto* listed(Settings& settings) {
    return &settings;
}
template <class Settings>
auto* listed(std::optional<Settings>& settings) {
    return settings ? &*settings : nullptr;
}
template <class Settings>
auto* listed(const std::optional<Settings>& settings) {
    return settings ? &*settings : nullptr;
}

// A value as it stands in a file.

inline std::string value_text(bool value) {
    return value ? "true" : "false";
}
inline std::string value_text(int value) {
    return std::to_string(value);
}
inline std::string value_text(std::uint64_t value) {
    return std::to_string(value);
}
inline std::string value_text(double value) {
    return shortest(value);
}
inline std::string value_text(const std::string& value) {
    return in_quotes(value);
}
inline std::string value_text(const glm::dvec3& value) {
    return "[" + shortest(value.x) + ", " + shortest(value.y) + ", " + shortest(value.z) + "]";
}
template <class Enum>
requires std::is_enum_v<Enum> std::string value_text(Enum value) {
    return in_quotes(names_of(value)[static_cast<std::size_t>(value)]);
}

// What a key allows, in words that follow "key = value: ".

inline std::string range_text(const Range& range) {
    return " from " + shortest(range.lowest) + " to " + shortest(range.highest);
}
inline std::string allowed_text(bool, const Range&) {
    return "true or false is allowed";
}
inline std::string allowed_text(int, const Range& range) {
    return "a whole number" + range_text(range) + " is allowed";
}
inline std::string allowed_text(std::uint64_t, const Range&) {
    return "a whole number from 0 to " + std::to_string(greatest_seed) + " is allowed";
}
inline std::string allowed_text(double, const Range& range) {
    return "a number" + range_text(range) + " is allowed";
}
inline std::string allowed_text(const std::string&, const Range&) {
    return "one line of text of at most 200 bytes in quotes is allowed";
}
inline std::string allowed_text(const glm::dvec3&, const Range& range) {
    return "three numbers" + range_text(range) + " are allowed, such as [0, 1.5, 0]";
}
template <class Enum>
requires std::is_enum_v<Enum> std::string allowed_text(Enum value, const Range&) {
    return choices(names_of(value)) + " is allowed";
}
template <class Settings, class Value>
std::string allowed_text(const Field<Settings, Value>& field) {
    return allowed_text(Value{}, field.range);
}
template <class Settings, class Value>
std::string allowed_text(const Field<Settings, std::optional<Value>>& field) {
    return (field.absent.empty() ? "" : in_quotes(field.absent) + " or ") + allowed_text(Value{}, field.range);
}

// Whether a value is allowed.

inline bool is_allowed(bool, const Range&) {
    return true;
}
inline bool is_allowed(int value, const Range& range) {
    return range.contains(value);
}
inline bool is_allowed(std::uint64_t value, const Range&) {
    return value <= static_cast<std::uint64_t>(greatest_seed);
}
inline bool is_allowed(double value, const Range& range) {
    return range.contains(value);
}
inline bool is_allowed(const std::string& value, const Range&) {
    return value.size() <= 200 && is_utf8(value) && one_line(value, 200) == value;
}
inline bool is_allowed(const glm::dvec3& value, const Range& range) {
    return range.contains(value.x) && range.contains(value.y) && range.contains(value.z);
}
template <class Enum>
requires std::is_enum_v<Enum>
bool is_allowed(Enum value, const Range&) {
    return static_cast<std::size_t>(value) < names_of(value).size();
}
template <class Value>
bool is_allowed(const std::optional<Value>& value, const Range& range) {
    return !value || is_allowed(*value, range);
}

}  // namespace drapeau::scene_fields
