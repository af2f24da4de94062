#include "scene/file.hpp"
#include "scene/settings.hpp"

#include <algorithm>

namespace drapeau {

namespace {

/// One line "key = value  # comment", comments aligned; nothing for an absent optional that has no word.
template <class Settings, class Value>
void write_field(std::string& text, const Settings& settings, const settings::Key<Settings, Value>& field) {
    const Value& value = settings.*field.member;
    std::string line = std::string(field.key) + " = ";
    if constexpr (requires { value.has_value(); }) {
        if (!value && field.absent.empty()) return;
        line += value ? settings::value_text(*value) : in_quotes(field.absent);
    } else {
        line += settings::value_text(value);
    }
    constexpr std::size_t comment_column = 32;
    line.resize(std::max(line.size() + 2, comment_column), ' ');
    text += line + "# " + settings::comment_of(field.about) + "\n";
}

}  // namespace

std::string write_scene(const Scene& scene) {
    std::string text = "# A scene of drapeau: what is listed is modelled, what is left out is not.\n";
    settings::each_table(scene, [&](const std::string& table, const auto& settings, const auto& keys, bool) {
        const auto* values = settings::listed(settings);
        if (!values) return;
        if (!table.empty()) text += "\n[" + table + "]\n";
        settings::each_key(keys, [&](const auto& field) { write_field(text, *values, field); });
    });
    return text;
}

}  // namespace drapeau
