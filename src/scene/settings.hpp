// The settings of a scene, one row each. The row drives reading, writing and checking scene files, every message about
// the key, --set on the command lines, the panel's control and docs/scene.md. To add a setting, add its member to the
// settings or the term it belongs to and its row here. A term or limit with a table of its own needs a tuple of rows,
// keys_of<Term>; the list of terms does the rest.
#pragma once

#include "io/text.hpp"
#include "scene/scene.hpp"

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

namespace drapeau::settings {

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

/// What a setting is, for people.
struct About {
    const char* label;          // of its control
    std::string_view unit;      // "" for what has none
    std::string_view help;      // one line for the reader of a scene file
    std::string_view tip = "";  // what a larger value does, in sentences
};

/// The control of a number: its ends, inside the range that files may use, and how it is shown.
struct Control {
    Range range{};
    bool logarithmic = false;
    std::string_view number = "%.3g";  // printf
    double shown_per_unit = 1.0;       // 1000 shows metres as millimetres
    std::string_view unit = "";        // shown; "" is the setting's own
    double usual = 0.0;                // what an optional setting is when it is switched on
};

template <class Settings, class Value>
struct Key {
    std::string_view key;
    Value Settings::*member;
    About about;
    Range range{};  // of numbers, and of each of three
    Control control{};
    std::string_view absent = "";  // the word a file says for an absent optional; without one the key is left out
    bool required = false;         // the file must say it
};
template <class Settings, class Value, class... Rest>
Key(std::string_view, Value Settings::*, Rest...) -> Key<Settings, Value>;

// A seed is any whole number that TOML can hold.
inline constexpr std::int64_t max_seed = std::numeric_limits<std::int64_t>::max();

inline constexpr std::tuple scene_keys{
    Key{"name", &Scene::name, About{"Name", "", "shown in the window's title"}},
};

inline constexpr std::tuple flag_keys{
    Key{"columns", &FlagSettings::columns,
        About{"Columns", "", "masses along the fly, away from the pole",
              "More columns show finer folds, take more time and make the flag heavier: every mass weighs the same."},
        Range{1, 4096}, Control{{1, 200}}},
    Key{"rows", &FlagSettings::rows,
        About{"Rows", "", "masses along the hoist, down the pole", "More rows do the same."}, Range{1, 4096},
        Control{{1, 200}}},
    Key{"width", &FlagSettings::width,
        About{"Width", "m", "along the fly, at rest", "A wider flag has longer springs, not more of them."},
        Range{1e-3, 1e3}, Control{{0.1, 5}, false, "%.2f"}},
    Key{"height", &FlagSettings::height,
        About{"Height", "m", "along the hoist, at rest", "A higher flag has longer springs, not more of them."},
        Range{1e-3, 1e3}, Control{{0.1, 5}, false, "%.2f"}},
    Key{"attach", &FlagSettings::attach,
        About{"Held by", "",
              "hoist, grommets (the two hoist corners), top, corner, sides (hoist and fly), edges, all or none",
              "Which masses are held in place."}},
    Key{"start", &FlagSettings::start,
        About{"Starts", "", "flat, hanging (settled without wind) or crumpled", "How the flag begins, after Restart."}},
    Key{"prestretch", &FlagSettings::prestretch,
        About{"Prestretch", "", "share; 0.1 starts 10 % longer than rest",
              "A larger share gives the flag more elastic energy to begin with, after Restart."},
        Range{-0.9, 10}, Control{{0, 50}, false, "%.0f", 100, "%"}},
    Key{"disturbance", &FlagSettings::disturbance,
        About{"Disturbance", "m", "ripples of a flat start; 0 keeps it in its plane",
              "A flat flag without ripples stays in its plane for ever, unless something pushes it out. auto: a "
              "nanometre "
              "where nothing does."},
        Range{0, 1}, Control{{0, 50}, false, "%.3g", 1000, "mm", 0.002}, "auto"},
    Key{"texture", &FlagSettings::texture, About{"Image", "", "image file, beside this file or in assets/flags"}},
};

inline constexpr Range stiffness_range{1e-9, 1e9}, damping_range{0, 1e6};
inline constexpr Control stiffness_control{{1, 20000}, true, "%.4g", 1, "", 100};

inline constexpr std::tuple springs_keys{
    Key{"mass", &SpringSettings::mass,
        About{"Mass", "kg", "of every mass",
              "Heavier cloth swings more slowly, stretches more under its weight and allows a larger step."},
        Range{1e-9, 1e3}, Control{{0.01, 100}, true, "%.3g", 1000, "g"}, "", true},
    Key{"stiffness", &SpringSettings::stiffness,
        About{"Stiffness", "N/m", "of springs between side neighbours (k)",
              "Stiffer cloth stretches less and needs a smaller step."},
        stiffness_range, stiffness_control, "", true},
    Key{"diagonal_stiffness", &SpringSettings::diagonal_stiffness,
        About{"Diagonal stiffness", "N/m", "of springs between diagonal neighbours (k_d)",
              "They resist shear. Stiffer springs need a smaller step."},
        stiffness_range, stiffness_control},
    Key{"damping", &SpringSettings::damping,
        About{
            "Damping", "N·s/m", "along every spring (c)",
            "It damps vibration along springs and leaves motion of the whole flag alone. More damping needs a smaller "
            "step."},
        damping_range, Control{{1e-5, 1}, true, "%.3g", 1, "", 0.002}},
    Key{"drag", &SpringSettings::drag,
        About{"Air drag", "N·s/m", "of every mass against the air (d)",
              "Wind pushes through it. More drag makes the cloth follow the air more closely."},
        damping_range, Control{{1e-6, 0.1}, true, "%.3g", 1, "", 0.0006}},
    Key{"friction", &SpringSettings::friction,
        About{"Friction", "N·s/m", "of every mass, whatever the air does (c_f)", "More friction slows all motion."},
        damping_range, Control{{1e-6, 0.1}, true, "%.3g", 1, "", 0.0001}},
};

/// The keys of a term's or limit's own table, and what a reader of its table should know.
template <class Term>
inline constexpr std::tuple keys_of{};
template <class Term>
inline constexpr std::string_view remark_on = "";

template <>
inline constexpr std::tuple keys_of<Gravity>{
    Key{"acceleration", &Gravity::acceleration,
        About{"Gravity", "m/s²", "y is up", "-9.81 upwards is the Earth's, -1.62 the Moon's."}, Range{-1e4, 1e4},
        Control{{-30, 30}, false, "%.2f"}},
};

template <>
inline constexpr std::string_view remark_on<Wind> = "Wind pushes through air drag, so it needs springs.drag.";
template <>
inline constexpr std::tuple keys_of<Wind>{
    Key{"velocity", &Wind::velocity,
        About{"Wind", "m/s", "the mean; x away from the pole, y up, z towards the viewer",
              "Faster wind lifts the flag and stretches its springs more."},
        Range{-1e6, 1e6}, Control{{-40, 40}, false, "%.1f"}},
    Key{"gusts", &Wind::gusts,
        About{"Gusts", "m/s", "rms on each axis, added to the mean",
              "Higher is more violent; across the flag, it flaps more."},
        Range{0, 1e6}, Control{{0, 15}, false, "%.1f"}},
    Key{"period", &Wind::period,
        About{"Gust period", "s", "how fast gusts change", "A longer period makes them change more slowly."},
        Range{1e-3, 1e6}, Control{{0.1, 20}, true, "%.2f"}},
    Key{"travelling", &Wind::travelling,
        About{"Travelling gusts", "", "gusts run along the flag with the mean wind; false: the same everywhere",
              "They move at 1 m/s at least, and reach the pole before the fly. Travelling gusts take more time."}},
    Key{"seed", &Wind::seed,
        About{"Seed", "", "a different seed gives different gusts", "The same seed always repeats them."},
        Range{0, static_cast<double>(max_seed)}, Control{{1, 100}}},
};

template <>
inline constexpr std::tuple keys_of<StretchLimit>{
    Key{"stretch", &StretchLimit::stretch,
        About{"Stretch limit", "", "share; 0.05: no spring longer than 1.05 times its rest length",
              "After every step, springs that are longer are shortened. A higher limit lets the cloth stretch more; a "
              "limit well below the stretch without one takes many times as long."},
        Range{0, 10}, Control{{2, 50}, false, "%.1f", 100, "%"}, "", true},
};

inline constexpr Range dt_range{1e-9, 1e3};  // s

inline constexpr std::tuple time_keys{
    Key{"method", &TimeSettings::method, About{"Method", "", "how a step is taken; docs/model.md lists the methods"}},
    Key{"dt", &TimeSettings::dt,
        About{"Step size", "s", "\"auto\" is a share of the largest stable step",
              "A larger step takes less time and is less accurate; above the stability limit the run diverges. The "
              "window "
              "rounds it down to a whole number of steps per 1/60 s."},
        dt_range, Control{{0.01, 1000.0 / 60.0}, true, "%.4g", 1000, "ms"}, "auto"},
    Key{"precision", &TimeSettings::precision,
        About{"Precision", "", "float or double",
              "Floating-point type. double takes about twice the time and matters in long or very accurate runs."}},
};

inline constexpr std::tuple view_keys{
    Key{"texture", &ViewSettings::texture, About{"Texture", "", "the image on the cloth", "Off: plain cloth. Key T"}},
    Key{"cut_out", &ViewSettings::cut_out,
        About{"Cut out", "", "no cloth where the image is transparent",
              "The flag has its image's outline; off: pale cloth. The simulated cloth is rectangular either way."}},
    Key{"cloth", &ViewSettings::cloth, About{"Cloth", "", "the surface between the masses", "Key C"}},
    Key{"springs", &ViewSettings::springs, About{"Springs", "", "every spring as a line", "Key S"}},
    Key{"forces", &ViewSettings::forces,
        About{"Force colours", "", "springs coloured by their force, white to red",
              "A scale in newtons stands below the flag. Key F"}},
    Key{"masses", &ViewSettings::masses, About{"Masses", "", "every mass as a point", "Key M"}},
    Key{"texture_proportions", &ViewSettings::texture_proportions,
        About{"Shaped like its image", "", "the flag takes the proportions of its image",
              "The width follows from the height."}},
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

/// "flag.columns", or the key alone before the first table.
inline std::string full_name(std::string_view table, std::string_view key) {
    return std::string(table) + (table.empty() ? "" : ".") + std::string(key);
}

/// What a scene file says beside the value: "m, along the fly".
inline std::string comment_of(const About& about) {
    return std::string(about.unit) + (about.unit.empty() ? "" : ", ") + std::string(about.help);
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

// What a key allows, in words.

inline std::string range_text(const Range& range) {
    return " from " + shortest(range.lowest) + " to " + shortest(range.highest);
}
inline std::string values_text(bool, const Range&) {
    return "true or false";
}
inline std::string values_text(int, const Range& range) {
    return "a whole number" + range_text(range);
}
inline std::string values_text(std::uint64_t, const Range&) {
    return "a whole number from 0 to " + std::to_string(max_seed);
}
inline std::string values_text(double, const Range& range) {
    return "a number" + range_text(range);
}
inline std::string values_text(const std::string&, const Range&) {
    return "one line of text of at most 4096 bytes in quotes";
}
inline std::string values_text(const glm::dvec3&, const Range& range) {
    return "three numbers" + range_text(range);
}
template <class Enum>
requires std::is_enum_v<Enum> std::string values_text(Enum value, const Range&) {
    return choices(names_of(value));
}
template <class Settings, class Value>
std::string values_text(const Key<Settings, Value>& field) {
    return values_text(Value{}, field.range);
}
template <class Settings, class Value>
std::string values_text(const Key<Settings, std::optional<Value>>& field) {
    return (field.absent.empty() ? "" : in_quotes(field.absent) + " or ") + values_text(Value{}, field.range);
}
/// The same as a sentence that follows "key = value: ".
template <class Settings, class Value>
std::string allowed_text(const Key<Settings, Value>& field) {
    constexpr bool several = std::is_same_v<Value, glm::dvec3>;
    return values_text(field) + (several ? " are allowed, such as [0, 1.5, 0]" : " is allowed");
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

}  // namespace drapeau::settings
