// What the desktop brings along: text of another size, small windows, names in any script, a window manager that died,
// windows that nobody sees.
#include "app.hpp"
#include "image/image_file.hpp"
#include "pixels.hpp"
#include "scenes.hpp"

#include "catch.hpp"

#include <thread>

using namespace drapeau::window_tests;

namespace {

/// The flag is in the part of the window that the panel leaves, and large enough to be looked at.
void check_flag_seen(const Look& look) {
    const Box view = look.box("view"), flag = look.box("flag");
    CHECK(flag.width() > 0.2 * view.width());
    CHECK(view.contains(flag.at(0.05, 0.05)));
    CHECK(view.contains(flag.at(0.95, 0.95)));
    if (!look.text("panel").empty()) CHECK(look.box("panel").x1 <= view.x0);
}

void check_steps_aside(App& app) {
    const Look closed = app.settle();
    CHECK(closed.text("panel").empty());
    CHECK(closed.box("view").x0 == 0);
    check_flag_seen(closed);

    app.click("Panel");
    const Look opened = app.wait_until("the panel", [](const Look& look) { return !look.text("panel").empty(); });
    check_flag_seen(opened);
    app.click("Close panel");
    app.wait_until("it to be closed", [](const Look& look) { return look.text("panel").empty(); });
    app.press("h");
    app.wait_until("the panel again", [](const Look& look) { return !look.text("panel").empty(); });
}

/// The wheel over a control scrolls the whole panel, down to the last reading.
void check_scrolls_as_one(App& app) {
    const Look above = app.settle();
    CHECK(above.has("Close panel"));
    app.wheel(above.controls.at("Page: Flag").box.at(0.5, 0.5), -1);
    CHECK(!app.settle().has("Close panel"));
    app.show("Reading: Stretch");
}

drapeau::Image cut(const drapeau::Image& picture, const Box& box) {
    drapeau::Image part{.width = int(box.width()), .height = int(box.height()), .rgba = {}};
    for (int y = 0; y < part.height; ++y) {
        const auto start =
            picture.rgba.begin() + (std::ptrdiff_t(int(box.y0) + y) * picture.width + std::ptrdiff_t(box.x0)) * 4;
        part.rgba.insert(part.rgba.end(), start, start + std::ptrdiff_t(part.width) * 4);
    }
    return part;
}

/// How the list of scenes shows the scene in a file of this name.
drapeau::Image shown_name(const Screen& screen, const std::string& name) {
    const TemporaryFolder folder;
    App app(screen, {written(folder, name + ".toml", still_scene), "--size", "900x640"});
    const Control list = app.settle().controls.at("Scene");
    CHECK(list.value == name);
    drapeau::Image shown = cut(app.picture(), list.box);
    app.check_healthy();
    return shown;
}

}  // namespace

TEST_CASE("the window grows with the desktop's text, and the panel leaves half of it to the flag") {
    const Screen screen;
    const TemporaryFolder folder;
    screen.use_dpi(192);
    App app(screen, {written(folder, "still.toml", still_scene)});
    const Look look = app.settle();
    CHECK(look.text("window") == "1280x1024");  // all there is
    CHECK(look.box("view").width() >= 640);
    CHECK(look.box("panel").width() > 500);
    check_flag_seen(look);
    app.check_healthy();
}

TEST_CASE("a size given on the command line is kept whatever the desktop's text") {
    const Screen screen;
    const TemporaryFolder folder;
    screen.use_dpi(144);
    CHECK(App(screen, {written(folder, "still.toml", still_scene), "--size", "900x640"}).look().text("window") ==
          "900x640");
}

TEST_CASE("a panel that would take most of the window steps aside and is opened by its button or by H") {
    const Screen screen;
    const TemporaryFolder folder;
    const std::string scene = written(folder, "still.toml", still_scene);
    {
        App app(screen, {scene});
        app.resize(480, 360);
        app.wait_until("the small window", [](const Look& look) { return look.text("framebuffer") == "480x360"; });
        check_steps_aside(app);
        check_scrolls_as_one(app);
        app.check_healthy();
    }
    screen.use_dpi(288);
    App app(screen, {scene});
    check_steps_aside(app);
    check_scrolls_as_one(app);
    app.check_healthy();
}

TEST_CASE("what a small window says leaves the button that opens the panel free") {
    const Screen screen;
    const TemporaryFolder folder;
    App app(screen, {written(folder, "apart.toml", diverging_scene()), "--size", "480x360"});
    const auto button_is_free = [&](const Look& look) {
        const Box button = look.controls.at("Panel").box, said = look.box("message_box");
        CHECK(said.y0 >= button.y1);
        CHECK(said.y1 <= look.box("view").y1);
        CHECK(said.x0 < button.x1);  // else it would be free anyhow
    };
    app.wait_until("the end of the run", [](const Look& look) { return look.number("diverged") == 1; });
    button_is_free(app.settle());
    app.press("Escape");
    app.wait_until("the line", [](const Look& look) { return look.has("Stopped"); });
    button_is_free(app.settle());
    app.check_healthy();
}

TEST_CASE("names in other scripts are shown in their own letters") {
    const Screen screen;
    // Letters of one width; whatever the font lacks looks alike.
    for (const auto& [one, other] :
         {std::pair{"ШШШ", "ЩЩЩ"}, std::pair{"ΞΞΞ", "ΣΣΣ"}, std::pair{"ŁŁŁ", "ĽĽĽ"}, std::pair{"→→→", "←←←"}}) {
        CAPTURE(one, other);
        const drapeau::Image a = shown_name(screen, one), b = shown_name(screen, other);
        CHECK(a.rgba != b.rgba);
    }
}

TEST_CASE("the list of scenes shows what a name holds, without obeying it") {
    const Screen screen;
    const TemporaryFolder folder;
    App app(screen, {written(folder, "a\tb##c\x1b\xff.toml", still_scene), "--size", "900x640"});
    const std::string shown = "a\\tb##c\\x1b\\xff";
    CHECK(app.settle().controls.at("Scene").value == shown);
    app.click("Scene");
    app.wait_until("the list", [&](const Look& look) { return look.has("Scene: " + shown); });
    app.check_healthy();
}

TEST_CASE("a window manager that died is no reason to fail, least of all for a picture") {
    const Screen screen;
    const TemporaryFolder folder;
    const std::string scene = written(folder, "still.toml", still_scene), picture = folder / "picture.png";
    screen.leave_dead_window_manager();
    const Finished done =
        run({program(), scene, "--frames", "1", "--size", "320x240", "--screenshot", picture}, screen.surroundings());
    CAPTURE(done.errors);
    CHECK(done.status == 0);
    CHECK(done.errors.empty());
    CHECK(drapeau::load_image(picture).width == 320);

    screen.leave_dead_window_manager();
    App app(screen, {scene});
    app.check_healthy();
}

TEST_CASE("a server that starts anew when it is left alone is never left alone while the window begins") {
    const Screen screen(Screen::Alone::starts_anew);
    const TemporaryFolder folder;
    const std::string scene = written(folder, "still.toml", still_scene);
    for (int n = 0; n < 20; ++n) {
        const Finished done =
            run({program(), scene, "--frames", "1", "--size", "160x120", "--screenshot", folder / "picture.png"},
                screen.surroundings());
        CAPTURE(n, done.errors);
        REQUIRE(done.status == 0);
        std::this_thread::sleep_for(Seconds(0.2));  // it begins anew once the program has left
    }
}

TEST_CASE("a paused window draws no frames until something happens") {
    const Screen screen;
    App app(screen, {"report", "--size", "900x640"});
    const auto rests = [](const Look& look) { return look.text("resting") == "1"; };
    CHECK(app.settle().text("resting") == "0");
    app.press("space");
    const Look paused = app.wait_until("its rest", rests);
    std::this_thread::sleep_for(Seconds(1.0));
    CHECK(app.look().number("frame") == paused.number("frame"));

    app.press("period");
    app.wait_until("a step", [&](const Look& look) { return look.number("steps") == paused.number("steps") + 1; });
    app.press("s");
    CHECK(app.look().controls.at("Springs").value == "1");
    app.wait_until("its rest", rests);

    // A message that goes by itself goes from a window at rest.
    app.press("p");
    app.wait_until("a message", [](const Look& look) { return look.text("message").starts_with("Saved"); });
    app.wait_until("it to be gone", [](const Look& look) { return look.text("message").empty(); });

    const Look before = app.wait_until("its rest", rests);
    app.press("space");
    app.wait_until("time to pass", [&](const Look& look) { return look.number("time") > before.number("time"); });
    app.check_healthy();
}

TEST_CASE("a window that nobody sees goes on with the run and draws next to nothing") {
    const Screen screen;
    App app(screen, {"report", "--size", "900x640"});
    app.settle();
    app.hide();
    const Look hidden = app.wait_until("its rest", [](const Look& look) { return look.text("resting") == "1"; });
    const Look later = app.wait_until(
        "a second of the run", [&](const Look& look) { return look.number("time") > hidden.number("time") + 1.0; });
    // Sixty are drawn where it is seen.
    CHECK(later.number("frame") - hidden.number("frame") < 30);
}
