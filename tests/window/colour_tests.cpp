// The views that colour: what stretch, forces and velocities look like where they are known, and that they combine.
#include "app.hpp"
#include "pixels.hpp"
#include "scenes.hpp"

#include "catch.hpp"

#include <algorithm>
#include <cmath>

using namespace drapeau::window_tests;

namespace {

/// The window on the hanging cloth at rest: a vertical spring below row j of 9 carries 8 - j masses, so the stretch at
/// mass row j is (8.5 - j) m g / (k L) = (8.5 - j) 0.196 %.
struct HangingCloth {
    Screen screen;
    TemporaryFolder folder;
    App app{screen, {written(folder, "hanging.toml", hanging_scene), "--size", "900x640"}};

    HangingCloth() {
        app.press("space");
        app.wait_until("the pause", [](const Look& look) { return look.number("paused") == 1; });
        app.click("Page: View");
    }

    void fix(const std::string& range, const std::string& value) {
        app.show(range + " on");
        app.set(range + " on", true);
        app.wait_until("its number", [&](const Look& look) { return look.has(range); });
        app.type_number(range, value);
    }
    /// At a row of masses, between columns.
    Colour at_row(const drapeau::Image& picture, double row) {
        return colour_around(picture, app.look().box("flag").at(0.47, row / 8.0), 3);
    }
};

double apart(const Colour& a, const Colour& b) {
    return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
}

int count(const drapeau::Image& picture, const Box& box, bool (*is)(const Colour&)) {
    int found = 0;
    for (double y = box.y0; y < box.y1; ++y)
        for (double x = box.x0; x < box.x1; ++x) found += is(colour_at(picture, {x, y}));
    return found;
}

bool is_red(const Colour& c) {
    return c.red > 1.6 * std::max(c.green, c.blue);
}
bool is_green(const Colour& c) {
    return c.green > 1.3 * c.red && c.green > 1.2 * c.blue;
}
bool is_yellow(const Colour& c) {
    return c.red > 170 && c.green > 130 && c.blue < 0.55 * c.green;
}
bool is_deep_blue(const Colour& c) {
    return c.red < 90 && c.green < 40 && c.blue > 60;
}

/// Falls without air and is followed by the camera: all masses have the velocity g t.
const std::string falling_scene = R"(name = "Falling"
[flag]
columns = 9
rows = 9
width = 1.0
height = 1.0
attach = "none"
[springs]
mass = 0.01
stiffness = 400.0
[gravity]
[time]
dt = "auto"
[view]
texture = false
)";

/// Held everywhere, in a wind that blows across it.
const std::string windy_scene = R"(name = "Windy"
[flag]
columns = 9
rows = 9
width = 1.0
height = 1.0
attach = "all"
[springs]
mass = 0.01
stiffness = 400.0
drag = 0.01
[wind]
velocity = [4.0, 0.0, 0.0]
[time]
dt = "auto"
[view]
texture = false
)";

}  // namespace

TEST_CASE_METHOD(HangingCloth, "stretch is grey at rest, redder the more is carried, by a scale that can be fixed") {
    app.set("Stretch colours", true);
    CHECK(app.settle().text("legend").find("-2 %, 0 %, +2 %; automatic") != std::string::npos);
    fix("Stretch range", "1");
    CHECK(app.settle().text("legend").find("-1 %, 0 %, +1 %; fixed") != std::string::npos);
    const drapeau::Image narrow = app.picture();
    double before = at_row(narrow, 3.0).green;
    for (const double row : {5.0, 6.5, 7.7}) {  // above row 3.4 it is past the end of the scale
        CAPTURE(row);
        CHECK(at_row(narrow, row).green > before + 20);
        before = at_row(narrow, row).green;
    }
    CHECK(apart(at_row(narrow, 0.7), at_row(narrow, 3.0)) < 12);
    CHECK(at_row(narrow, 1.0).red > 1.8 * at_row(narrow, 1.0).blue);
    CHECK(at_row(narrow, 7.8).vividness() < 0.5 * at_row(narrow, 1.0).vividness());

    // Half of a stretch looks on half of a scale as the whole does on the whole: 2.5 masses and 5 below.
    app.type_number("Stretch range", "2");
    const drapeau::Image wide = app.picture();
    CHECK(apart(at_row(narrow, 6.0), at_row(wide, 3.5)) < 10);
    CHECK(apart(at_row(narrow, 6.0), at_row(wide, 6.0)) > 20);

    app.press("ctrl+z");
    CHECK(app.settle().text("legend").find("+1 %; fixed") != std::string::npos);
    app.set("Stretch range on", false);
    CHECK(app.settle().text("legend").find("+2 %; automatic") != std::string::npos);
    app.press("e");
    CHECK(app.settle().text("legend").empty());
    app.check_healthy();
}

TEST_CASE_METHOD(HangingCloth, "viridis colours springs, cloth and legend from dark blue to yellow") {
    app.set("Force colours", true);
    const Look look = app.settle();
    const Box flag = look.box("flag"), view = look.box("view");
    const Box legend{view.x0, view.y1 - 90, view.x1, view.y1};
    const drapeau::Image red = app.picture();
    CHECK(count(red, flag, is_red) > 50);
    CHECK(count(red, legend, is_yellow) == 0);
    app.click("Colours");
    app.wait_until("the list", [](const Look& now) { return now.has("Colours: viridis"); });
    app.click("Colours: viridis");
    app.wait_until("the choice",
                   [](const Look& now) { return now.has("Colours") && now.controls.at("Colours").value == "viridis"; });
    app.move_to({view.x1 - 3, view.y0 + 3});
    app.settle();
    const drapeau::Image safe = app.picture();
    CHECK(count(safe, flag, is_red) == 0);
    CHECK(count(safe, legend, is_red) == 0);
    CHECK(count(safe, legend, is_yellow) > 100);
    CHECK(count(safe, legend, is_deep_blue) > 100);

    app.set("Force colours", false);
    app.set("Stretch colours", true);
    fix("Stretch range", "1");
    const drapeau::Image cloth = app.picture();
    CHECK(at_row(cloth, 1.0).red > 2.0 * at_row(cloth, 1.0).blue);   // yellow
    CHECK(at_row(cloth, 7.8).green > 1.5 * at_row(cloth, 7.8).red);  // the middle's teal
    app.check_healthy();
}

TEST_CASE_METHOD(HangingCloth, "a force scale that is fixed is told so, undone, and saved with the scene") {
    app.set("Force colours", true);
    CHECK(app.settle().text("legend").find("automatic") != std::string::npos);
    const double automatic = app.look().number("force_scale");
    const drapeau::Image before = app.picture();
    fix("Force range", "40");
    const Look fixed = app.settle();
    CHECK(fixed.text("legend") == "Force of a spring, |k (l - L)|: 0 N, 20 N, 40 N; fixed");
    CHECK(fixed.number("force_scale") == 40.0);
    const Box flag = fixed.box("flag");
    CHECK(count(app.picture(), flag, is_red) < 0.1 * count(before, flag, is_red));  // what pulls with 0.8 N is white

    app.press("ctrl+c");
    app.settle();
    app.press("ctrl+z");
    app.press("ctrl+z");
    CHECK(app.settle().number("force_scale") == automatic);
    CHECK(app.look().text("legend").find("automatic") != std::string::npos);
    app.press("ctrl+v");  // the scene as text has it
    app.wait_until("the scene", [](const Look& look) { return look.number("force_scale") == 40.0; });
    app.check_healthy();
}

TEST_CASE_METHOD(HangingCloth, "a reference is dashed behind force colours, which stay to be read") {
    app.set("Force colours", true);
    const Box flag = app.settle().box("flag");
    const int red = count(app.picture(), flag, is_red);
    app.press("g");
    app.wait_until("the reference", [](const Look& look) { return look.number("reference_mm") >= 0; });
    app.settle();
    const drapeau::Image both = app.picture();
    CHECK(count(both, flag, is_red) > 0.5 * red);  // though at rest it is just where the cloth is
    app.set("Force colours", false);
    CHECK(count(app.picture(), flag, is_green) > 1000);
    app.check_healthy();
}

TEST_CASE("velocities are lines as long as the flag is fast, at the moment that is looked at") {
    const Screen screen;
    const TemporaryFolder folder;
    App app(screen, {written(folder, "falling.toml", falling_scene), "--size", "900x640"});
    app.wait_until("half a second", [](const Look& look) { return look.number("time") > 0.5; });
    app.press("space");
    app.wait_until("the pause", [](const Look& look) { return look.number("paused") == 1; });
    const Box view = app.settle().box("view");
    const Box scene{view.x0, view.y0, view.x1, view.y1 - 90};
    CHECK(count(app.picture(), scene, is_yellow) < 20);
    app.press("v");
    app.wait_until("velocities", [](const Look& look) { return !look.text("legend").empty(); });
    app.settle();
    CHECK(app.look().text("legend").find("m/s; automatic") != std::string::npos);
    const int now = count(app.picture(), scene, is_yellow);
    CHECK(now > 300);
    // Fixed at ten times the speed, lines are at most a tenth as long.
    app.click("Page: View");
    app.show("Velocity range on");
    app.set("Velocity range on", true);
    app.wait_until("its number", [](const Look& look) { return look.has("Velocity range"); });
    app.type_number("Velocity range", "50");
    CHECK(app.settle().text("legend").find("0 m/s, 25 m/s, 50 m/s; fixed") != std::string::npos);
    CHECK(count(app.picture(), scene, is_yellow) < 0.5 * now);
    app.set("Velocity range on", false);
    // A kept moment shows its own: near the start all but none.
    app.press("Prior");
    const Look early = app.wait_until("an early moment", [](const Look& look) { return !look.text("shown").empty(); });
    CHECK(early.number("time") < 0.2);
    app.settle();
    CHECK(count(app.picture(), scene, is_yellow) < 0.5 * now);
    app.press("v");
    CHECK(app.settle().text("legend").empty());
    app.check_healthy();
}

TEST_CASE("the cloth hides streaks of the wind that are behind it") {
    const Screen screen;
    const TemporaryFolder folder;
    App app(screen, {written(folder, "windy.toml", windy_scene), "--size", "900x640"});
    app.press("space");
    app.wait_until("the pause", [](const Look& look) { return look.number("paused") == 1; });
    const Box flag = app.settle().box("flag");
    const auto streaks = [&] {
        app.set("Wind shown", false);
        const drapeau::Image without = app.picture();
        app.set("Wind shown", true);
        return changed(without, app.picture(), flag, 3).count();
    };
    app.click("Page: View");
    const int before_cloth = streaks();
    app.set("Cloth", false);
    const int all = streaks();
    CAPTURE(before_cloth, all);
    CHECK(before_cloth > 0);
    CHECK(before_cloth < 0.8 * all);
    app.check_healthy();
}
