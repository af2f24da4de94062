// Palette: everything can be found by its name, and what fits best comes first.
#include "catch.hpp"

#include "scene/settings.hpp"
#include "viewer/actions.hpp"

#include <algorithm>
#include <set>

using namespace drapeau;

namespace {

std::string first(const AppState& app, const std::string& typed) {
    const auto found = matching(palette_items(app), typed);
    return found.empty() ? "" : found.front().label;
}

}  // namespace

TEST_CASE("names are found by words, by parts of words and by letters in their order", "[palette]") {
    CHECK(match_score("Wind speed", "") > 0);
    CHECK(match_score("Wind speed", "WIND") > match_score("Wind speed", "spe"));
    CHECK(match_score("Wind speed", "spe") > match_score("Wind speed", "ind"));
    CHECK(match_score("Wind speed", "ind") > match_score("Wind speed", "wsp"));
    CHECK(match_score("Wind speed", "wsp") > 0);
    CHECK(match_score("Wind speed", "speed wind") > 0);
    CHECK(match_score("Wind speed", "wind rows") == 0);
    CHECK(match_score("Wind speed", "x") == 0);
    CHECK(match_score("Wind speed", "ide") == 0);  // no word begins so
    CHECK(match_score("", "a") == 0);
    CHECK(match_score("a", std::string(10000, 'a')) == 0);
}

TEST_CASE("every setting is found first by its key, every action by what it does", "[palette]") {
    AppState app;
    settings::each_table(app.scene, [&](const std::string& table, const auto&, const auto& keys) {
        if (table.empty()) return;
        settings::each_key(keys, [&](const auto& field) {
            const std::string key = settings::full_name(table, field.key);
            CAPTURE(key);
            const auto found = matching(palette_items(app), key);
            REQUIRE(!found.empty());
            CHECK(found.front().label == field.about.label);
            CHECK(found.front().detail.starts_with(key));
        });
    });
    for (const Action& action : actions()) {
        if (action.key == "Esc" || action.key == "Enter" || action.key == "Ctrl P") continue;
        CHECK(first(app, action.does) == capitalised(action.does));
    }
}

TEST_CASE("a setting is found by its table and by what it is said to do, after those with the name", "[palette]") {
    AppState app;
    CHECK(first(app, "time step") == "Step size");
    CHECK(first(app, "largest stable") == "Step size");
    CHECK(first(app, "step") != "Method");  // of which it is only said
    CHECK(match_score("the largest stable step", "stable step", true) > 0);
    CHECK(match_score("the largest stable step", "table", true) == 0);
}

TEST_CASE("scenes and flags are found by name and opened", "[palette]") {
    AppState app;
    app.scene_names = {"report", "storm"};
    app.texture_files = {"/flags/japan.png"};
    app.remembered.recent_scenes = {"/mine/kite.toml"};
    choose(matching(palette_items(app), "storm").front(), app);
    CHECK(app.commands.load_scene == "storm");
    choose(matching(palette_items(app), "kite").front(), app);
    CHECK(app.commands.load_scene == "/mine/kite.toml");
    choose(matching(palette_items(app), "japan").front(), app);
    CHECK(app.commands.load_texture == "/flags/japan.png");
}

TEST_CASE("a setting that is off turns to the switch that brings it, one that is automatic to that choice",
          "[palette]") {
    AppState app;
    app.panel_shown = false;
    const auto mark_of = [&](const std::string& key) {
        choose(matching(palette_items(app), key).front(), app);
        return *app.mark;
    };
    CHECK(mark_of("air.density").means("Air on faces"));
    CHECK(app.panel_open());
    CHECK(mark_of("fabric.density").means("Material"));
    CHECK(mark_of("gravity.acceleration").means("Gravity on"));
    CHECK(mark_of("time.dt").means("Step chosen automatically"));
    CHECK(mark_of("springs.damping").means("Damping on"));
    CHECK(mark_of("springs.damping").means("Damping"));
    CHECK_FALSE(mark_of("springs.damping").means("Damping time"));
    app.scene.time.dt = 1e-3;
    app.scene.wind().emplace();
    CHECK(mark_of("time.dt").means("Step size"));
    CHECK(mark_of("wind.velocity").means("Wind speed"));
    CHECK(mark_of("flag.columns").page == 0);
}

TEST_CASE("every press does one thing, and everything in the list of keys can be pressed", "[palette]") {
    std::set<std::tuple<Key, char32_t, char, bool, bool>> all;
    for (const Action& action : actions()) {
        CAPTURE(action.does);
        CHECK(action.key.empty() == action.presses.empty());
        for (const Press& press : action.presses)
            CHECK(all.emplace(press.key, press.typed, press.letter, press.control, press.shift).second);
    }
    using Kind = InputEvent::Kind;
    const auto does = [](const InputEvent& event) {
        const Action* action = action_of(event, 0);
        return action ? action->does : "";
    };
    CHECK(does({.kind = Kind::key, .control = true, .letter = 'z'}) == "undo the last setting");
    CHECK(does({.kind = Kind::key, .control = true, .shift = true, .letter = 'z'}) == "redo it");
    CHECK(does({.kind = Kind::key, .control = true, .letter = 'y'}) == "redo it");
    CHECK(does({.kind = Kind::key, .letter = 'z'}).empty());
    CHECK(does({.kind = Kind::key, .shift = true, .letter = 's'}) == "springs");
    CHECK(does({.kind = Kind::key, .control = true, .letter = 's'}).empty());
    CHECK(does({.kind = Kind::key}).empty());
}
