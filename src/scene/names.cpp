// The names of settings in scene files and on the command line.
#include "scene/file.hpp"
#include "scene/settings.hpp"

namespace drapeau {

namespace {

template <class Enum>
std::string_view name_in_list(Enum value) {
    const auto names = settings::names_of(value);
    const auto index = static_cast<std::size_t>(value);
    return index < names.size() ? names[index] : "?";
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
    return choices(settings::method_names);
}

}  // namespace drapeau
