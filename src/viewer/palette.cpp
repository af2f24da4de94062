#include "palette.hpp"

#include "actions.hpp"
#include "palette_offers.hpp"

#include "io/text.hpp"
#include "scene/settings.hpp"

#include <algorithm>
#include <utility>

namespace drapeau {

namespace {

using namespace settings;

std::string lower(std::string_view text) {
    std::string small(text);
    for (char& c : small)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return small;
}

bool is_letter_or_digit(char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (c & 0x80);
}

/// Whether the letters follow each other in the name, with others between, the first of them at the beginning of a
/// word.
bool holds_in_order(std::string_view name, std::string_view letters) {
    for (std::size_t begin = 0; begin < name.size(); ++begin) {
        if (name[begin] != letters[0] || (begin > 0 && is_letter_or_digit(name[begin - 1]))) continue;
        std::size_t at = begin;
        for (const char c : letters) {
            at = name.find(c, at);
            if (at == std::string_view::npos) break;
            ++at;
        }
        if (at != std::string_view::npos) return true;
    }
    return false;
}

/// Of one word, both in small letters.
int word_score(std::string_view name, std::string_view word, bool beginnings) {
    constexpr int in_front = 8, at_word = 6, within = 4, scattered = 1;
    std::size_t at = name.find(word);
    if (at == 0) return in_front;
    const bool found = at != std::string_view::npos;
    for (; at != std::string_view::npos; at = name.find(word, at + 1))
        if (!is_letter_or_digit(name[at - 1])) return at_word;
    if (beginnings) return 0;
    if (found) return within;
    return word.size() > 1 && holds_in_order(name, word) ? scattered : 0;
}

/// The page with the controls of a table; -1: they are above the pages.
int page_of(std::string_view table, std::string_view key) {
    constexpr std::string_view on_view_page[] = {"background", "wind",        "stretch",       "velocities",
                                                 "colours",    "force_range", "stretch_range", "velocity_range",
                                                 "bare_grid",  "person"};
    if (table == "view" && std::count(std::begin(on_view_page), std::end(on_view_page), key)) return 5;
    if (table == "view") return key == "texture_proportions" ? 0 : -1;
    return table == "flag" ? 0 : table == "wind" ? 2 : table == "time" ? 3 : 1;
}

/// The label of the switch that a table which is off has.
template <class Settings>
std::string switch_of(const std::optional<Settings>&, const char* first_label) {
    if constexpr (requires { Settings::name + 0; }) {
        constexpr bool has_row = std::tuple_size_v<std::decay_t<decltype(keys_of<Settings>)>> == 1;
        return has_row ? first_label : capitalised(Settings::name);
    } else {
        return "Material";  // springs and a fabric take each other's place
    }
}
template <class Settings>
std::string switch_of(const Settings&, const char*) {
    return {};
}

/// A control that stands in the place of another now.
std::string control_of(const Scene& scene, std::string_view key, const char* label) {
    const bool automatic = !scene.time.dt;
    if ((key == "dt" && automatic) || (key == "tolerance" && !automatic)) return "Step chosen automatically";
    return label;
}

std::string value_in(const auto& value, std::string_view absent, std::string_view unit) {
    std::string text(absent.empty() ? "not modelled" : absent);
    if constexpr (requires { value.has_value(); }) {
        if (!value) return text;
        text = value_text(*value);
    } else {
        text = value_text(value);
    }
    return text + (unit.empty() ? "" : " " + std::string(unit));
}

void add_settings(const AppState& app, std::vector<PaletteItem>& items) {
    each_table(app.scene, [&](const std::string& table, const auto& settings, const auto& keys) {
        if (table.empty()) return;  // a name has no control
        const auto* values = listed(settings);
        const std::string turned_on_by = switch_of(settings, std::get<0>(keys).about.label);
        each_key(keys, [&](const auto& field) {
            const std::string name = full_name(table, field.key);
            std::string control = turned_on_by, detail = name + ": off";
            if (values) {
                control = control_of(app.scene, field.key, field.about.label);
                detail = name + " = " + value_in(values->*field.member, field.absent, field.about.unit);
            }
            PaletteItem& item = items.emplace_back();
            item.kind = PaletteItem::Kind::setting;
            item.label = field.about.label;
            item.detail = detail;
            item.about = field.about.help;
            item.mark.control = control;
            item.mark.page = page_of(table, field.key);
        });
    });
}

void add_actions(std::vector<PaletteItem>& items) {
    for (const Action& action : actions()) {
        const bool of_keys_alone = action.key == "Esc" || action.key == "Enter" || action.key == "Ctrl P";
        if (of_keys_alone) continue;
        PaletteItem& item = items.emplace_back();
        item.label = capitalised(action.does);
        item.detail = action.key;
        item.action = &action;
    }
}

void add_files(const AppState& app, std::vector<PaletteItem>& items) {
    const auto add = [&](PaletteItem::Kind kind, const std::string& label, const std::string& path) {
        PaletteItem& item = items.emplace_back();
        item.kind = kind;
        item.label = label;
        item.detail = kind == PaletteItem::Kind::scene ? "scene" : "flag";
        item.path = path;
    };
    for (const std::string& name : app.scene_names) add(PaletteItem::Kind::scene, name, name);
    const auto& scenes = app.remembered.recent_scenes;
    const auto scene_labels = shown_names(scenes, false, app.scene_names);
    for (std::size_t i = 0; i < scenes.size(); ++i) add(PaletteItem::Kind::scene, scene_labels[i], scenes[i]);
    for (const auto& file : app.texture_files) add(PaletteItem::Kind::image, file.stem().string(), file.string());
    const auto& images = app.remembered.recent_images;
    const auto image_labels = shown_names(images, true);
    for (std::size_t i = 0; i < images.size(); ++i) add(PaletteItem::Kind::image, image_labels[i], images[i]);
}

}  // namespace

bool Mark::means(std::string_view label) const {
    if (!label.starts_with(control)) return false;
    const std::string_view rest = label.substr(control.size());
    return rest.empty() || rest == " on" || rest == " along" || rest == " speed";
}

std::vector<PaletteItem> palette_items(const AppState& app) {
    std::vector<PaletteItem> items;
    add_actions(items);
    add_settings(app, items);
    add_buttons(app, items);
    add_choices(app, items);
    add_files(app, items);
    return items;
}

int match_score(std::string_view name, std::string_view typed, bool beginnings) {
    const std::string small = lower(name), words = lower(typed);
    int score = 1;
    for (std::size_t at = 0; at < words.size();) {
        const std::size_t end = std::min(words.find(' ', at), words.size());
        if (end > at) {
            const int found = word_score(small, std::string_view(words).substr(at, end - at), beginnings);
            if (!found) return 0;
            score += found;
        }
        at = end + 1;
    }
    return score;
}

std::vector<PaletteItem> matching(std::vector<PaletteItem> items, std::string_view typed) {
    std::vector<std::pair<int, PaletteItem>> scored;
    for (PaletteItem& item : items) {
        // A key such as flag.columns is as good a name as a label, only a little less so.
        const std::string key =
            item.keywords.empty() ? item.detail.substr(0, item.detail.find_first_of(" :")) : item.keywords;
        const int by_label = 2 * match_score(item.label, typed), by_key = 2 * match_score(key, typed) - 1;
        const int by_all = match_score(item.label + ' ' + key + ' ' + item.about, typed, true);
        const int score = std::max({by_label, by_key, by_all});
        if (score > 0) scored.emplace_back(score, std::move(item));
    }
    std::stable_sort(scored.begin(), scored.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<PaletteItem> found;
    for (auto& entry : scored) found.push_back(std::move(entry.second));
    return found;
}

void choose(const PaletteItem& item, AppState& app) {
    app.palette.open = false;
    switch (item.kind) {
        case PaletteItem::Kind::action:
            app.palette.wanted = item.action;
            break;
        case PaletteItem::Kind::setting:
            app.mark = item.mark;
            if (!app.panel_open()) app.toggle_panel();
            break;
        case PaletteItem::Kind::scene:
            app.commands.load_scene = item.path;
            break;
        case PaletteItem::Kind::image:
            app.commands.load_texture = item.path;
            break;
        case PaletteItem::Kind::choice:
            item.sets(app);
            if (app.mark && !app.panel_open()) app.toggle_panel();
            break;
    }
}

}  // namespace drapeau
