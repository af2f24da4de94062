// The names of settings in scene files and on the command line.
#include "error.hpp"
#include "scene_fields.hpp"
#include "scene_file.hpp"

#include <algorithm>

namespace drapeau {

namespace {

template <class Enum>
std::string_view name_in_list(Enum value) {
    const auto names = scene_fields::names_of(value);
    const auto index = static_cast<std::size_t>(value);
    return index < names.size() ? names[index] : "?";
}

template <class Enum>
Enum value_named(std::string_view name, const std::string& what) {
    const auto names = scene_fields::names_of(Enum{});
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<Enum>(found - names.begin());

    std::string reason;
    const auto& later = scene_fields::later_methods;
    if (std::is_same_v<Enum, Method> && std::find(later.begin(), later.end(), name) != later.end()) {
        reason = "not available in this version; ";
    }
    throw InputError(what + " = " + one_line(in_quotes(name), 60) + ": " + reason + choices(names) + " is allowed");
}

}  // namespace

std::string_view name_of(Attach attach) {
    return name_in_list(attach);
}
std::string_view name_of(Start start) {
    return name_in_list(start);
}
std::string_view name_of(Method method) {
    return name_in_list(method);
}
std::string_view name_of(Precision precision) {
    return name_in_list(precision);
}

std::string method_choices() {
    return choices(scene_fields::method_names);
}

Attach attach_named(std::string_view name, const std::string& what) {
    return value_named<Attach>(name, what);
}
Start start_named(std::string_view name, const std::string& what) {
    return value_named<Start>(name, what);
}
Method method_named(std::string_view name, const std::string& what) {
    return value_named<Method>(name, what);
}
Precision precision_named(std::string_view name, const std::string& what) {
    return value_named<Precision>(name, what);
}

}  // namespace drapeau
