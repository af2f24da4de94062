// What the mouse does to the cloth and to the wind: pulling, reading, and the views that go with it.
#include "app.hpp"
#include "pixels.hpp"
#include "still_flag.hpp"

#include "catch.hpp"

#include <cmath>
#include <sstream>

using namespace drapeau::window_tests;

namespace {

struct Report {
    Screen screen;
    App app{screen, {"report", "--size", "900x640"}};
};

Point point_in(const Look& look, const std::string& state) {
    std::istringstream words(look.text(state));
    Point p;
    words >> p.x >> p.y;
    return p;
}

double apart(Point a, Point b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace

TEST_CASE_METHOD(Report, "a shift drag takes hold of the cloth and pulls it along, and let go it flies on") {
    const Look before = app.settle();
    const Point place = before.box("flag").at(0.75, 0.5);
    screen.xdotool({"keydown", "shift"});
    app.move_to(place);
    screen.xdotool({"mousedown", "1"});
    const Look held = app.wait_until("a hold", [](const Look& look) { return !look.text("held").empty(); });
    CHECK(apart(point_in(held, "held"), place) < 60);

    const Point there{place.x - 80, place.y - 110};
    app.move_to(there);
    const Look pulled = app.wait_until("the cloth to follow", [&](const Look& look) {
        return !look.text("held").empty() && apart(point_in(look, "held"), there) < 0.5 * apart(place, there);
    });
    CHECK(pulled.number("pull") > 0.01);
    CHECK(pulled.text("azimuth") == before.text("azimuth"));

    screen.xdotool({"mouseup", "1"});
    screen.xdotool({"keyup", "shift"});
    const double then =
        app.wait_until("the hand to be off",
                       [](const Look& look) { return look.text("held").empty() && look.number("pull") == 0; })
            .number("time");
    const Look later =
        app.wait_until("the flag to fly on", [&](const Look& look) { return look.number("time") > then + 0.7; });
    CHECK(later.number("diverged") == 0);
    CHECK(later.box("flag").width() > 0.5 * before.box("flag").width());
    app.check_healthy();
}

TEST_CASE_METHOD(Report, "Escape lets go while the button is down, and a paused flag waits for its hand") {
    app.press("space");
    const Look before = app.wait_until("the pause", [](const Look& look) { return look.number("paused") == 1; });
    const Point place = before.box("flag").at(0.6, 0.5);
    screen.xdotool({"keydown", "shift"});
    app.move_to(place);
    screen.xdotool({"mousedown", "1"});
    const Look held = app.wait_until("a hold", [](const Look& look) { return !look.text("held").empty(); });
    app.move_to({place.x + 50, place.y - 90});
    CHECK(app.settle().text("held") == held.text("held"));
    app.press("Escape");
    CHECK(app.settle().text("held").empty());
    CHECK(app.settle().text("time") == before.text("time"));
    screen.xdotool({"mouseup", "1"});
    screen.xdotool({"keyup", "shift"});
    app.check_healthy();
}

TEST_CASE_METHOD(StillFlag,
                 "a click on the cloth reads a mass, or a spring where they are shown, and a drag does not") {
    const Box flag = app.settle().box("flag");
    app.drag(flag.at(0.4, 0.5), flag.at(0.5, 0.5));
    CHECK(app.settle().text("readout").empty());
    app.press("Home");

    app.click(app.settle().box("flag").at(0.35, 0.52));
    const Look mass = app.wait_until("a readout", [](const Look& look) { return look.has("Read: Speed"); });
    CHECK(mass.text("readout") == "Mass: column 1, row 1");
    CHECK(mass.controls.at("Read: Speed").value == "0.00 m/s");
    CHECK(mass.controls.at("Read: Springs' pull").value == "0.000 N");
    CHECK(mass.controls.at("Read: Upwards, y").value == "-0.500 m");
    app.press("Escape");
    CHECK(app.settle().text("readout").empty());

    app.press("s");
    app.click(app.settle().box("flag").at(0.5, 0.49));
    const Look spring = app.wait_until("a readout", [](const Look& look) { return look.has("Read: Length"); });
    CHECK(spring.text("readout") == "Spring: 1, 1 to 2, 1");
    CHECK(spring.controls.at("Read: Length").value == "500.00 mm");
    CHECK(spring.controls.at("Read: Stretch").value.find('%') != std::string::npos);
    CHECK(spring.controls.at("Read: Force").value.find('N') != std::string::npos);

    const Box view = spring.box("view");
    app.click(Point{view.x0 + 20, view.y0 + 20});
    CHECK(app.settle().text("readout").empty());
    app.check_healthy();
}

TEST_CASE_METHOD(StillFlag,
                 "the wheel comes closer to what is under the mouse, and A turns slowly until it is pressed again") {
    const Box before = app.settle().box("flag");
    const Point corner{before.x1, before.y0};
    app.wheel(corner, 3);
    const Box after = app.settle().box("flag");
    CHECK(after.width() > 1.2 * before.width());
    CHECK(apart({after.x1, after.y0}, corner) < 0.1 * before.width());

    app.press("Home");
    const double azimuth = app.settle().number("azimuth");
    app.press("a");
    app.wait_until("a turn", [&](const Look& look) { return std::abs(look.number("azimuth") - azimuth) > 2; });
    app.press("a");
    const Look stopped = app.settle();
    CHECK(stopped.number("orbits") == 0);
    CHECK(app.settle().text("azimuth") == stopped.text("azimuth"));
    app.check_healthy();
}

TEST_CASE_METHOD(Report, "the compass sets the wind, which W shows, and U and L haul the flag along its pole") {
    app.click("Page: Wind");
    const Look look = app.wait_until("the compass", [](const Look& now) { return now.has("Wind compass"); });
    const Box dial = look.controls.at("Wind compass").box;
    const Point middle = dial.at(0.5, 0.5);
    // 0.26 of the side is 38.5 of the 62 units that are 40 m/s; speed grows with the square.
    app.drag(middle, {middle.x, middle.y + 0.26 * dial.height()});
    const Look blown = app.settle();
    const double expected = 40.0 * std::pow(0.26 * 148.0 / 62.0, 2);
    const std::string& set = blown.controls.at("Wind compass").value;
    CHECK(std::stod(set) == Approx(expected).margin(1.0));
    CHECK(std::stod(set.substr(set.find(',') + 1)) == Approx(90.0).margin(2.0));
    CHECK(blown.controls.at("Reading: Beaufort").value == "7 near gale");

    app.press("w");
    CHECK(app.settle().text("wind_shown").find("m/s") != std::string::npos);
    app.press("w");
    CHECK(app.settle().text("wind_shown").empty());

    const double top = app.settle().box("flag").y0;
    for (int n = 0; n < 4; ++n) app.press("l");
    app.wait_until("the flag to be lower", [&](const Look& now) { return now.box("flag").y0 > top + 25; });
    for (int n = 0; n < 4; ++n) app.press("u");
    app.wait_until("the flag to be up again", [&](const Look& now) { return now.box("flag").y0 < top + 12; });
    app.check_healthy();
}
