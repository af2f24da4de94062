#include "palette_offers.hpp"

#include "app_state.hpp"

#include "scene/settings.hpp"

#include <fmt/format.h>

#include <functional>
#include <type_traits>
#include <utility>

namespace drapeau {

namespace {

using namespace settings;
using Subject = Measuring::Subject;

constexpr int flag_page = 0, time_page = 3, trade_page = 4;

PaletteItem& add(std::vector<PaletteItem>& items, PaletteItem::Kind kind, const std::string& label,
                 const std::string& keywords) {
    PaletteItem& item = items.emplace_back();
    item.kind = kind;
    item.label = label;
    item.keywords = keywords;
    return item;
}

/// What a button does, here as there.
void add_deed(std::vector<PaletteItem>& items, const std::string& label, const std::string& keywords,
              std::function<void(AppState&)> sets) {
    PaletteItem& item = add(items, PaletteItem::Kind::choice, label, keywords);
    item.sets = std::move(sets);
}

/// A control that is turned to; a button is pressed too.
void add_control(std::vector<PaletteItem>& items, const std::string& label, const std::string& keywords,
                 const std::string& control, int page, bool presses = false) {
    PaletteItem& item = add(items, PaletteItem::Kind::setting, label, keywords);
    item.mark.control = control;
    item.mark.page = page;
    item.mark.presses = presses;
}

/// One of a list; the one that is chosen now says so.
void add_choice(std::vector<PaletteItem>& items, const std::string& list, const std::string& key, std::string_view name,
                bool chosen, std::function<void(AppState&)> sets) {
    PaletteItem& item =
        add(items, PaletteItem::Kind::choice, list + ": " + std::string(name), key + ": " + std::string(name));
    item.detail = chosen ? key + ", chosen" : key;
    const std::string said = item.label;
    item.sets = [sets = std::move(sets), said](AppState& app) {
        sets(app);
        say(app, Message::Cause::typed, said, false);
    };
}

template <class Value>
void set_choice(AppState& app, const std::string& table, std::string_view key, int index) {
    each_table(app.scene, [&](const std::string& name, auto& settings, const auto& keys) {
        if (name != table) return;
        auto* values = listed(settings);
        if (!values) return;
        each_key(keys, [&](const auto& field) {
            if constexpr (std::is_same_v<std::decay_t<decltype(values->*field.member)>, Value>)
                if (field.key == key) values->*field.member = Value(index);
        });
    });
}

void add_lists_of_settings(const AppState& app, std::vector<PaletteItem>& items) {
    each_table(app.scene, [&](const std::string& table, const auto& settings, const auto& keys) {
        const auto* values = listed(settings);
        if (!values) return;
        each_key(keys, [&](const auto& field) {
            using Value = std::decay_t<decltype(values->*field.member)>;
            if constexpr (std::is_enum_v<Value>) {
                const auto names = names_of(Value{});
                for (int i = 0; i < int(names.size()); ++i)
                    add_choice(items, field.about.label, full_name(table, field.key), names[std::size_t(i)],
                               i == int(values->*field.member), [table, key = field.key, i](AppState& to) {
                                   const auto before = to.scene.fabric ? to.scene.fabric->name : FabricName{};
                                   set_choice<Value>(to, table, key, i);
                                   if (to.scene.fabric) bring_fabric(to, before);
                               });
            }
        });
    });
}

}  // namespace

void add_buttons(const AppState& app, std::vector<PaletteItem>& items) {
    add_control(items, "Save scene", "save as toml file button", "Save scene", time_page, true);
    add_control(items, "Save as", "name of the scene file to save", "Save as", time_page);
    add_control(items, "Scene file", "open a scene by its path", "Scene file", time_page);
    add_control(items, "Image file", "open an image by its path", "Image file", flag_page);
    add_control(items, "Gallery of flags", "images to choose from", "Gallery", flag_page);
    add_control(items, "Timeline", "scrub, look back", "Timeline", -1);
    add_control(items, "Accuracy", "trade, tolerance", "Accuracy", trade_page);
    add_deed(items, "Gallery of scenes", "scenes to choose from", [](AppState& to) { to.scenes_shown = true; });
    add_deed(items, "Save shape", "obj, export the mesh", [](AppState& to) { to.commands.save_shape = true; });
    add_deed(items, "Film", "record a video, mp4, gif", [](AppState& to) { to.film.open = true; });
    add_deed(items, "Reset all", "settings back to the scene's values", [](AppState& to) { to.scene = to.origin; });
    add_deed(items, "Measure settings", "trade speed for accuracy", [](AppState& to) {
        to.commands.measure = Subject::trade;
        to.mark = Mark{.control = "Progress", .page = trade_page};
    });
    add_deed(items, "Price each part", "cost and effect of each part", [](AppState& to) {
        to.commands.measure = Subject::prices;
        to.mark = Mark{.control = "Progress", .page = trade_page};
    });
    add_deed(items, "Plots", "live plots, curves, energy over time", [](AppState& to) {
        to.playback.plots = !to.playback.plots;
        to.mark = Mark{.control = "Plots"};
    });
    if (app.findings.under_way)
        add_deed(items, "Stop measuring", "", [](AppState& to) { to.commands.stop_measuring = true; });
    if (app.film.under_way) add_deed(items, "Stop film", "", [](AppState& to) { to.commands.stop_film = true; });
    if (app.scene.view.reference)
        add_deed(items, "Compare anew", "reference begins again",
                 [](AppState& to) { to.commands.restart_reference = true; });
    if (app.status.divergence)
        add_deed(items, "Use the safe step", "", [](AppState& to) { to.commands.use_safe_step = true; });
}

void add_choices(const AppState& app, std::vector<PaletteItem>& items) {
    add_lists_of_settings(app, items);
    add_choice(items, "Material", "material", "springs", app.scene.springs.has_value(), [](AppState& to) {
        if (to.scene.fabric) give_as_springs(to.scene);
        to.diagonals.reset();
    });
    add_choice(items, "Material", "material", "fabric", app.scene.fabric.has_value(), [](AppState& to) {
        if (to.scene.springs) give_as_fabric(to.scene);
        to.diagonals.reset();
    });
    for (int i = 0; i < int(film_sizes.size()); ++i) {
        const auto& size = film_sizes[std::size_t(i)];
        const std::string name = size.x == 0 ? "the window's" : fmt::format("{} x {}", size.x, size.y);
        add_choice(items, "Film size", "film size", name, app.film.size == i, [i](AppState& to) { to.film.size = i; });
    }
    for (int i = 0; i < int(film_rates.size()); ++i)
        add_choice(items, "Frame rate", "film frame rate", fmt::format("{} frames/s", film_rates[std::size_t(i)]),
                   app.film.rate == i, [i](AppState& to) { to.film.rate = i; });
}

}  // namespace drapeau
