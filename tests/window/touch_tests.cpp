// What the mouse and the window's edges do to the view.
#include "app.hpp"
#include "pixels.hpp"
#include "still_flag.hpp"

#include "catch.hpp"

#include <algorithm>
#include <cmath>

using namespace drapeau::window_tests;

namespace {

/// A place on the panel where there is no control.
Point bare_place(const Look& look) {
    const Box panel = look.box("panel");
    for (double down = 0.02; down < 1.0; down += 0.01) {
        for (double across = 0.02; across < 1.0; across += 0.02) {
            const Point p = panel.at(across, down);
            const bool on_control = std::any_of(look.controls.begin(), look.controls.end(), [p](const auto& named) {
                const Box& box = named.second.box;
                return Box{box.x0 - 4, box.y0 - 4, box.x1 + 4, box.y1 + 4}.contains(p);
            });
            if (!on_control) return p;
        }
    }
    FAIL("the panel is full of controls");
    return {};
}

void check_same_view(const Look& before, const Look& after) {
    for (const std::string state : {"azimuth", "elevation", "distance", "target_x", "target_y", "target_z", "flag"}) {
        CAPTURE(state);
        CHECK(before.text(state) == after.text(state));
    }
}

}  // namespace

TEST_CASE_METHOD(StillFlag, "a left drag on the flag turns it") {
    const Look before = app.settle();
    const Box flag = before.box("flag");
    const drapeau::Image picture_before = app.picture();

    const Point start = flag.at(0.5, 0.5);
    app.drag(start, {start.x + 150, start.y + 40});
    const Look after = app.settle();
    CHECK(std::abs(after.number("azimuth") - before.number("azimuth")) > 10);
    CHECK(std::abs(after.number("elevation") - before.number("elevation")) > 2);
    CHECK(after.number("distance") == Approx(before.number("distance")));

    // Seen more from the side, the flag is narrower, and sky stands where its edge was.
    const bool turned_away = std::abs(after.number("azimuth")) > std::abs(before.number("azimuth"));
    if (turned_away) {
        CHECK(after.box("flag").width() < flag.width() - 5);
    } else {
        CHECK(after.box("flag").width() > flag.width() + 5);
    }
    CHECK(changed(picture_before, app.picture(), flag).count() > 0.05 * flag.width() * flag.height());
    app.check_healthy();
}

TEST_CASE_METHOD(StillFlag, "a drag that begins on the panel never turns the flag") {
    const Look before = app.settle();
    app.drag(bare_place(before), before.box("flag").at(0.5, 0.5));
    check_same_view(before, app.settle());
    app.check_healthy();
}

TEST_CASE_METHOD(StillFlag, "the wheel brings the flag nearer, a right drag moves it, a double click puts it back") {
    const Look before = app.settle();
    const Point middle = before.box("flag").at(0.5, 0.5);

    app.wheel(middle, 3);
    const Look nearer = app.settle();
    CHECK(nearer.number("distance") < 0.95 * before.number("distance"));
    CHECK(nearer.box("flag").width() > 1.03 * before.box("flag").width());

    app.drag(middle, {middle.x + 60, middle.y + 30}, Button::right);
    const Look moved = app.settle();
    CHECK(moved.number("azimuth") == Approx(nearer.number("azimuth")));
    // The flag follows the hand.
    CHECK(moved.box("flag").at(0.5, 0.5).x - nearer.box("flag").at(0.5, 0.5).x == Approx(60).margin(12));
    CHECK(moved.box("flag").at(0.5, 0.5).y - nearer.box("flag").at(0.5, 0.5).y == Approx(30).margin(12));

    app.double_click(middle);
    app.wait_until("the view to be as at first", [&](const Look& look) {
        return std::abs(look.number("distance") - before.number("distance")) < 1e-4 &&
               std::abs(look.number("azimuth") - before.number("azimuth")) < 1e-4 &&
               std::abs(look.number("target_x") - before.number("target_x")) < 1e-4;
    });
    CHECK_FALSE(app.settle().has("Close readout"));  // which the first click alone would have opened
    app.check_healthy();
}

TEST_CASE_METHOD(StillFlag, "the picture follows the window's size") {
    app.settle();
    for (const auto& [width, height] : {std::pair{820, 520}, std::pair{1150, 700}, std::pair{640, 800}}) {
        CAPTURE(width, height);
        app.resize(width, height);
        const std::string size = std::to_string(width) + "x" + std::to_string(height);
        app.wait_until("the window to be " + size, [&](const Look& look) {
            return look.text("window") == size && look.text("framebuffer") == size;
        });
        const Look look = app.settle();
        const Box view = look.box("view"), flag = look.box("flag");
        CHECK(flag.width() > 0.2 * view.width());
        CHECK(view.contains(flag.at(0.1, 0.1)));
        CHECK(view.contains(flag.at(0.9, 0.9)));
        CHECK(flag.width() / flag.height() == Approx(1.5).margin(0.25));
        // Blue is where the flag says it is.
        const Colour hoist = colour_around(app.picture(), flag.at(0.15, 0.5));
        CHECK(hoist.blue > hoist.red + 30);
    }
    app.check_healthy();
}
