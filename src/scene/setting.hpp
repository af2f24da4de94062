// Setting: what is known of one, and its value in words: as it stands in a file, what is allowed, whether one is.
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
inline constexpr std::array<std::string_view, 3> background_names{"sky", "studio", "transparent"};
inline constexpr std::array<std::string_view, 2> colours_names{"red", "viridis"};

inline constexpr std::array<std::string_view, 5> fabric_names{"knitted-polyester", "woven-polyester", "nylon", "silk",
                                                              "canvas"};

inline std::span<const std::string_view> names_of(Attach) {
    return attach_names;
}
inline std::span<const std::string_view> names_of(Start) {
    return start_names;
}
inline std::span<const std::string_view> names_of(FabricName) {
    return fabric_names;
}
inline std::span<const std::string_view> names_of(Method) {
    return method_names;
}
inline std::span<const std::string_view> names_of(Precision) {
    return precision_names;
}
inline std::span<const std::string_view> names_of(Background) {
    return background_names;
}
inline std::span<const std::string_view> names_of(Colours) {
    return colours_names;
}

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

/// "flag.columns", or the key alone before the first table.
inline std::string full_name(std::string_view table, std::string_view key) {
    return std::string(table) + (table.empty() ? "" : ".") + std::string(key);
}

/// What a scene file says beside the value: "m, along the fly".
inline std::string comment_of(const About& about) {
    return std::string(about.unit) + (about.unit.empty() ? "" : ", ") + std::string(about.help);
}

// A seed is any whole number that TOML can hold.
inline constexpr std::int64_t max_seed = std::numeric_limits<std::int64_t>::max();

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
