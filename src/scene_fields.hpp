// The keys of a scene file, one row each: the row drives reading, writing, checking and every message about the key.
// To add a key, add its member to the settings or the term it belongs to and its row here. A term or limit with a table
// of its own needs a tuple of rows, keys_of<Term>; the list of terms does the rest.
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
inline constexpr std::array<std::string_view, 8> attach_names{"hoist", "grommets", "top", "corner",
                                                              "sides", "edges",    "all", "none"};
inline constexpr std::array<std::string_view, 3> start_names{"flat", "hanging", "crumpled"};
inline constexpr auto method_names = []<std::size_t... n>(std::index_sequence<n...>) {
    return std::array<std::string_view, method_count>{std::tuple_element_t<n, Methods>::name...};
}
(std::make_index_sequence<method_count>());
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
inline constexpr std::array<std::string_view, 5> later_tables{"fabric", "face_pressure", "bending", "ground", "pole"};
inline constexpr std::array<std::string_view, 1> later_keys{"time.tolerance"};
inline constexpr std::array<std::string_view, 2> later_methods{"implicit-euler", "xpbd"};

/// Numbers from `lowest` to `highest`, both allowed.
struct Range {
    double lowest = 0.0;
    double highest = 0.0;

    bool contains(double value) const { return value >= lowest && value <= highest; }  // false for NaN
};

template <class Settings, class Value>
struct Key {
    std::string_view key;
    Value Settings::*member;
    std::string_view comment;      // one line for the reader of the file, its unit first
    Range range{};                 // of numbers, and of each of three
    std::string_view absent = "";  // the word a file says for an absent optional; without one the key is left out
    bool required = false;         // the file must say it
};
template <class Settings, class Value, class... Rest>
Key(std::string_view, Value Settings::*, Rest...) -> Key<Settings, Value>;

// A seed is any whole number that TOML can hold.
inline constexpr std::int64_t max_seed = std::numeric_limits<std::int64_t>::max();

inline constexpr std::tuple scene_keys{
    Key{"name", &Scene::name, "shown in the window's title"},
};

inline constexpr std::tuple flag_keys{
    Key{"columns", &FlagSettings::columns, "masses along the fly, away from the pole", Range{1, 4096}},
    Key{"rows", &FlagSettings::rows, "masses along the hoist, down the pole", Range{1, 4096}},
    Key{"width", &FlagSettings::width, "m, along the fly", Range{1e-3, 1e3}},
    Key{"height", &FlagSettings::height, "m, along the hoist", Range{1e-3, 1e3}},
    Key{"attach", &FlagSettings::attach,
        "hoist, grommets (the two hoist corners), top, corner, sides (hoist and fly), edges, all or none"},
    Key{"start", &FlagSettings::start, "flat, hanging (settled without wind) or crumpled"},
    Key{"prestretch", &FlagSettings::prestretch, "share; 0.1 starts 10 % longer than rest", Range{-0.9, 10}},
    Key{"disturbance", &FlagSettings::disturbance, "m, ripples of a flat start; 0 keeps it in its plane", Range{0, 1}},
    Key{"texture", &FlagSettings::texture, "picture, beside this file or in assets/flags"},
};

inline constexpr std::tuple springs_keys{
    Key{"mass", &SpringSettings::mass, "kg, of every mass", Range{1e-9, 1e3}, "", true},
    Key{"stiffness", &SpringSettings::stiffness, "N/m, of springs between side neighbours", Range{1e-9, 1e9}, "", true},
    Key{"diagonal_stiffness", &SpringSettings::diagonal_stiffness, "N/m, of springs between diagonal neighbours",
        Range{1e-9, 1e9}},
    Key{"damping", &SpringSettings::damping, "N s/m, along every spring", Range{0, 1e6}},
    Key{"drag", &SpringSettings::drag, "N s/m, of every mass against the air", Range{0, 1e6}},
    Key{"friction", &SpringSettings::friction, "N s/m, of every mass, whatever the air does", Range{0, 1e6}},
};

/// The keys of a term's or limit's own table.
template <class Term>
inline constexpr std::tuple keys_of{};

template <>
inline constexpr std::tuple keys_of<Gravity>{
    Key{"acceleration", &Gravity::acceleration, "m/s2; y is up", Range{-1e4, 1e4}},
};

template <>
inline constexpr std::tuple keys_of<Wind>{
    Key{"velocity", &Wind::velocity, "m/s, the mean; x away from the pole, y up, z towards the viewer",
        Range{-1e6, 1e6}},
    Key{"gusts", &Wind::gusts, "m/s, rms on each axis", Range{0, 1e6}},
    Key{"period", &Wind::period, "s, how fast gusts change", Range{1e-3, 1e6}},
    Key{"travelling", &Wind::travelling, "gusts run along the flag with the mean wind; false: the same everywhere"},
    Key{"seed", &Wind::seed, "a different seed gives different gusts", Range{0, static_cast<double>(max_seed)}},
};

template <>
inline constexpr std::tuple keys_of<StretchLimit>{
    Key{"stretch", &StretchLimit::stretch, "share; 0.05: no spring longer than 1.05 times its rest length",
        Range{0, 10}, "", true},
};

inline constexpr Range dt_range{1e-9, 1e3};  // s

inline constexpr std::tuple time_keys{
    Key{"method", &TimeSettings::method, "how a step is taken; docs/model.md lists the methods"},
    Key{"dt", &TimeSettings::dt, "s; \"auto\" is a share of the largest stable step", dt_range, "auto"},
    Key{"precision", &TimeSettings::precision, "float or double"},
};

inline constexpr std::tuple view_keys{
    Key{"texture", &ViewSettings::texture, "the picture on the cloth"},
    Key{"cut_out", &ViewSettings::cut_out, "no cloth where the picture is transparent"},
    Key{"cloth", &ViewSettings::cloth, "the cloth itself"},
    Key{"springs", &ViewSettings::springs, "springs as lines"},
    Key{"forces", &ViewSettings::forces, "springs coloured by their force"},
    Key{"masses", &ViewSettings::masses, "masses as points"},
    Key{"texture_proportions", &ViewSettings::texture_proportions, "the flag takes the proportions of its picture"},
};

/// Calls visit for the table of a term or limit, if it has one.
template <class Listed, class Visit>
void visit_table_of(Listed& listed, Visit&& visit) {
    using Term = typename std::remove_const_t<Listed>::value_type;
    if constexpr (requires { Term::table; }) visit(Term::table, listed, keys_of<Term>, false);
}

/// Calls visit(table name, settings or optional settings, its keys, whether a file must have it) in the order of a
/// file. The keys before the first table have the name "".
template <class AnyScene, class Visit>
void each_table(AnyScene& scene, Visit&& visit) {
    visit("", scene, scene_keys, false);
    visit("flag", scene.flag, flag_keys, false);
    visit("springs", scene.springs, springs_keys, true);
    Terms::for_all(scene.terms, [&](auto& term) { visit_table_of(term, visit); });
    Limits::for_all(scene.limits, [&](auto& limit) { visit_table_of(limit, visit); });
    visit("time", scene.time, time_keys, false);
    visit("view", scene.view, view_keys, false);
}

template <class Keys, class Visit>
void each_key(const Keys& keys, Visit&& visit) {
    std::apply([&](const auto&... field) { (visit(field), ...); }, keys);
}

template <class Keys>
std::vector<std::string_view> names_in(const Keys& keys) {
    std::vector<std::string_view> names;
    each_key(keys, [&](const auto& field) { names.push_back(field.key); });
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
    return "a whole number from 0 to " + std::to_string(max_seed) + " is allowed";
}
inline std::string allowed_text(double, const Range& range) {
    return "a number" + range_text(range) + " is allowed";
}
inline std::string allowed_text(const std::string&, const Range&) {
    return "one line of text of at most 4096 bytes in quotes is allowed";
}
inline std::string allowed_text(const glm::dvec3&, const Range& range) {
    return "three numbers" + range_text(range) + " are allowed, such as [0, 1.5, 0]";
}
template <class Enum>
requires std::is_enum_v<Enum> std::string allowed_text(Enum value, const Range&) {
    return choices(names_of(value)) + " is allowed";
}
template <class Settings, class Value>
std::string allowed_text(const Key<Settings, Value>& field) {
    return allowed_text(Value{}, field.range);
}
template <class Settings, class Value>
std::string allowed_text(const Key<Settings, std::optional<Value>>& field) {
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
    return value <= static_cast<std::uint64_t>(max_seed);
}
inline bool is_allowed(double value, const Range& range) {
    return range.contains(value);
}
inline bool is_allowed(const std::string& value, const Range&) {
    return value.size() <= 4096 && is_utf8(value) && one_line(value, 4096) == value;
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
