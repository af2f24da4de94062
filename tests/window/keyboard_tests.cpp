// Keys on keyboards of several layouts, pressed by their place as a hand does, and faster than frames are drawn.
#include "app.hpp"
#include "scenes.hpp"

#include "catch.hpp"

#include <optional>

using namespace drapeau::window_tests;

namespace {

// X's numbers of keys, whatever they type.
const std::string at_a = "38", at_q = "24", at_s = "39", at_t = "28", at_m = "58", at_comma = "59", at_slash = "61",
                  at_semicolon = "47", at_6 = "15", at_equal = "21", on_keypad_decimal = "91";

struct Keyboard {
    std::string layout;
    std::string springs, texture, masses;  // keys that switch them
    std::string step, closer, further;
    std::string quit;
    std::optional<std::string> no_quit;  // Q stands there on a US keyboard
};

std::string value(App& app, const std::string& label) {
    return app.settle().controls.at(label).value;
}

void check_switches(App& app, const std::string& key, const std::string& label) {
    CAPTURE(key, label);
    const std::string before = value(app, label);
    app.press(key);
    CHECK(value(app, label) != before);
    app.press(key);
    CHECK(value(app, label) == before);
}

}  // namespace

TEST_CASE("the keys of the list work on Russian, Greek and French keyboards, each once") {
    const std::string shift = "shift+";
    const std::vector<Keyboard> keyboards{
        {"us", at_s, at_t, at_m, "60", shift + at_equal, "20", at_q, std::nullopt},
        {"ru", at_s, at_t, at_m, at_slash, shift + at_equal, "20", at_q, std::nullopt},
        {"gr", at_s, at_t, at_m, "60", at_equal, "20", at_q, std::nullopt},
        {"fr", at_s, at_t, at_semicolon, shift + at_comma, shift + at_equal, at_6, at_a, at_q},
        {"de", at_s, at_t, at_m, "60", "35", at_slash, at_q, std::nullopt},
    };
    for (const Keyboard& keyboard : keyboards) {
        CAPTURE(keyboard.layout);
        const Screen screen;
        const TemporaryFolder folder;
        screen.use_layout(keyboard.layout);
        App app(screen, {written(folder, "still.toml", still_scene), "--size", "900x640"});
        check_switches(app, keyboard.springs, "Springs");
        check_switches(app, keyboard.texture, "Texture");
        check_switches(app, keyboard.masses, "Masses");

        const double distance = app.settle().number("distance");
        app.press(keyboard.closer);
        CHECK(app.settle().number("distance") < distance);
        app.press(keyboard.further);
        CHECK(app.settle().number("distance") == Approx(distance));

        app.press("space");
        app.wait_until("the pause", [](const Look& look) { return look.number("paused") == 1; });
        app.settle();
        app.settle();
        for (const std::string& key : {keyboard.step, on_keypad_decimal}) {
            CAPTURE(key);
            const double steps = app.look().number("steps");
            app.press(key);
            app.wait_until("a step", [&](const Look& look) { return look.number("steps") > steps; });
            CHECK(app.settle().number("steps") == steps + 1);
        }

        if (keyboard.no_quit) app.press("ctrl+" + *keyboard.no_quit);
        app.check_healthy();
        screen.xdotool({"key", "--delay", "0", "ctrl+" + keyboard.quit});
        CHECK(app.process().wait() == 0);
    }
}

TEST_CASE("what is typed within one frame comes in its order, with Control and without") {
    const Screen screen;
    const TemporaryFolder folder;
    App app(screen, {written(folder, "still.toml", still_scene), "--size", "900x640"});
    app.click("Page: Time");
    app.show("Save as");
    const auto typed = [&](const std::vector<std::string>& keys, const std::string& text) {
        std::vector<std::string> command{"key", "--delay", "0"};
        command.insert(command.end(), keys.begin(), keys.end());
        screen.xdotool(command);
        app.wait_until("'" + text + "'", [&](const Look& look) { return look.controls.at("Save as").value == text; });
    };
    app.click("Save as");
    typed({"a", "shift+b", "c"}, "aBc");
    typed({"ctrl+a", "x", "y", "z"}, "xyz");
    typed({"u", "ctrl+a", "v", "w"}, "vw");
    typed({"BackSpace", "s", "Left", "t"}, "vts");
    app.check_healthy();
}

TEST_CASE("Control and a letter of the text fields are that letter's key on a French and on a Russian keyboard") {
    for (const auto& [layout, all] : {std::pair{"fr", at_q}, std::pair{"ru", at_a}}) {
        CAPTURE(layout);
        const Screen screen;
        const TemporaryFolder folder;
        screen.use_layout(layout);
        App app(screen, {written(folder, "still.toml", still_scene), "--size", "900x640"});
        app.click("Page: Time");
        app.show("Save as");
        app.click("Save as");
        app.press("55");  // V, twice
        app.press("55");
        app.press("ctrl+" + all);
        app.press("BackSpace");
        CHECK(value(app, "Save as").empty());
        app.check_healthy();
    }
}
