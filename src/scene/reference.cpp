#include "scene/reference.hpp"

#include "scene/settings.hpp"

namespace drapeau {

namespace {

using namespace settings;

constexpr const char* introduction = R"(# The settings of a scene

A scene is a TOML file. What it lists is modelled, what it leaves out is not and costs nothing; its material, as
`[springs]` or as `[fabric]`, is the least it says. Both programs read scenes and take single settings instead with
`--set KEY=VALUE` (`drapeau storm --set flag.columns=90 --set springs.drag=off`); the window saves a scene with all that
its controls were set to. `off` takes out a table, or a setting whose default is to be left out, and says false; `on` lists
a table with its defaults, and says true. Options such as `--dt` win over `--set`.

`drapeau-lab settings` prints this page.
)";

template <class Settings, class Value>
std::string default_text(const Settings& settings, const Key<Settings, Value>& field) {
    if (field.required) return "must be given";
    const Value& value = settings.*field.member;
    if constexpr (requires { value.has_value(); }) {
        if (!value) return field.absent.empty() ? "left out" : "`" + in_quotes(field.absent) + "`";
        return "`" + value_text(*value) + "`";
    } else {
        return "`" + value_text(value) + "`";
    }
}

template <class Settings, class Value>
std::string line_of(const Settings& settings, const Key<Settings, Value>& field) {
    const About& about = field.about;
    return "| `" + std::string(field.key) + "` | " + std::string(about.unit) + " | " + default_text(settings, field) +
           " | " + values_text(field) + " | " + as_sentence(about.help) + (about.tip.empty() ? "" : " ") +
           as_sentence(about.tip) + " |\n";
}

template <class Settings>
std::string remark_of(const std::optional<Settings>&) {
    constexpr std::string_view remark = remark_on<Settings>;
    constexpr bool is_material = std::is_same_v<Settings, SpringSettings> || std::is_same_v<Settings, Fabric>;
    return (is_material ? "" : "May be left out. ") + std::string(remark) + (remark.empty() ? "" : " ");
}
template <class Settings>
std::string remark_of(const Settings&) {
    return "";
}

}  // namespace

std::string settings_reference() {
    Scene scene;  // with its defaults
    std::string text = introduction;
    each_table(scene, [&](const std::string& table, auto& settings, const auto& keys) {
        const std::string remark = remark_of(settings);
        if constexpr (requires { settings.has_value(); }) settings.emplace();
        text += table.empty() ? "\n## Before the first table\n\n" : "\n## [" + table + "]\n\n";
        if (!remark.empty()) text += remark.substr(0, remark.size() - 1) + "\n\n";
        text += "| Key | Unit | Default | Allowed | What it is |\n|---|---|---|---|---|\n";
        each_key(keys, [&](const auto& field) { text += line_of(*listed(settings), field); });
    });
    return text;
}

}  // namespace drapeau
