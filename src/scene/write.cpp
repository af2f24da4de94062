#include "scene/file.hpp"
#include "scene/settings.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace drapeau {

namespace {

/// Whether the name of a fabric says the value.
template <class Value>
bool is_implied(const Fabric& fabric, const settings::Key<Fabric, Value>& field) {
    return field.key != "name" && fabric.*field.member == fabric_of(fabric.name).*field.member;
}
template <class Settings, class Value>
bool is_implied(const Settings&, const settings::Key<Settings, Value>&) {
    return false;
}

/// The line of a key; nothing for an absent optional that has no word.
template <class Settings, class Value>
std::optional<SceneLine> line_of(const std::string& table, const Settings& settings,
                                 const settings::Key<Settings, Value>& field) {
    const Value& value = settings.*field.member;
    SceneLine line{table, std::string(field.key), "", std::string(field.about.unit), settings::comment_of(field.about)};
    if constexpr (requires { value.has_value(); }) {
        if (!value && field.absent.empty()) return {};
        line.value = value ? settings::value_text(*value) : in_quotes(field.absent);
    } else {
        line.value = settings::value_text(value);
    }
    return line;
}

}  // namespace

std::string SceneLine::text(const std::string& note) const {
    if (key.empty()) return "[" + table + "]";
    constexpr std::size_t comment_column = 32;
    std::string line = key + " = " + value;
    line.resize(std::max(line.size() + 2, comment_column), ' ');
    return line + "# " + note;
}

std::vector<SceneLine> scene_lines(const Scene& scene, bool with_implied) {
    std::vector<SceneLine> lines;
    settings::each_table(scene, [&](const std::string& table, const auto& settings, const auto& keys) {
        const auto* values = settings::listed(settings);
        if (!values) return;
        if (!table.empty()) lines.push_back({table, "", "", "", ""});
        settings::each_key(keys, [&](const auto& field) {
            if (is_implied(*values, field) && !with_implied) return;
            if (auto line = line_of(table, *values, field)) lines.push_back(std::move(*line));
        });
    });
    return lines;
}

std::string write_scene(const Scene& scene) {
    std::string text = scene_heading;
    for (const SceneLine& line : scene_lines(scene))
        text += (line.key.empty() ? "\n" : "") + line.text(line.comment) + "\n";
    return text;
}

}  // namespace drapeau
