// What the switches of the view show, looked for where it must appear.
#include "app.hpp"
#include "pixels.hpp"
#include "still_flag.hpp"

#include "catch.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

using namespace drapeau::window_tests;

namespace {

struct ViewOfStillFlag : StillFlag {
    /// Around the flag, with room for the lines of its border.
    Box around_flag() {
        const Box flag = app.settle().box("flag");
        return {flag.x0 - 8, flag.y0 - 8, flag.x1 + 8, flag.y1 + 8};
    }
};

constexpr int cells = 3 * 2;  // of the still flag

struct Thirds {
    Colour left, middle, right;
};

Thirds thirds(const drapeau::Image& picture, const Box& flag) {
    return {colour_around(picture, flag.at(1.0 / 6, 0.5)), colour_around(picture, flag.at(0.5, 0.5)),
            colour_around(picture, flag.at(5.0 / 6, 0.5))};
}

/// How red the reddest tenth of the pixels of `lines` is, red above the mean of green and blue, in the rows from one
/// share of the height to another. The rest are springs across, which carry nothing, and edges mixed with what is
/// behind.
double redness(const drapeau::Image& picture, const Mask& lines, const Box& box, double from, double to) {
    std::vector<double> all;
    for (int y = int(from * lines.height); y < int(to * lines.height); ++y) {
        for (int x = 0; x < lines.width; ++x) {
            if (!lines.at(x, y)) continue;
            const Colour c = colour_at(picture, {double(int(box.x0) + x), double(int(box.y0) + y)});
            all.push_back(c.red - 0.5 * (c.green + c.blue));
        }
    }
    REQUIRE(all.size() > 100);
    std::sort(all.begin(), all.end());
    const auto tenth = all.end() - std::ptrdiff_t(all.size() / 10);
    return std::accumulate(tenth, all.end(), 0.0) / double(all.end() - tenth);
}

}  // namespace

TEST_CASE_METHOD(ViewOfStillFlag, "springs outline every cell, and diagonals divide each into four") {
    app.set("Texture", false);
    const Box box = around_flag();
    const drapeau::Image plain = app.picture();

    app.set("Springs", true);
    const drapeau::Image structural = app.picture();
    const int smallest = int(0.2 * box.width() * box.height() / cells / 4);
    CHECK(enclosed_pieces(changed(plain, structural, box), smallest) == cells);

    app.set("Diagonals", true);
    CHECK(enclosed_pieces(changed(plain, app.picture(), box), smallest) == 4 * cells);

    // And back: nothing of the diagonals stays.
    app.set("Diagonals", false);
    CHECK(changed(structural, app.picture(), box).count() == 0);
    app.check_healthy();
}

TEST_CASE_METHOD(ViewOfStillFlag, "the texture puts its colours in their places, and without it the cloth is plain") {
    const Box flag = app.settle().box("flag");
    const Thirds france = thirds(app.picture(), flag);
    CHECK(france.left.blue > france.left.red + 30);
    CHECK(france.middle.vividness() < 40);
    CHECK(france.middle.red > 120);
    CHECK(france.right.red > france.right.blue + 60);

    app.set("Texture", false);
    const Thirds plain = thirds(app.picture(), flag);
    for (const Colour& other : {plain.left, plain.right}) {
        CHECK(other.red == Approx(plain.middle.red).margin(12));
        CHECK(other.green == Approx(plain.middle.green).margin(12));
        CHECK(other.blue == Approx(plain.middle.blue).margin(12));
    }

    app.set("Texture", true);
    const Thirds again = thirds(app.picture(), flag);
    CHECK(again.left.blue == Approx(france.left.blue).margin(2));
    CHECK(again.right.red == Approx(france.right.red).margin(2));
    app.check_healthy();
}

TEST_CASE("force colours are redder where springs carry more, with a legend in newtons") {
    const Screen screen;
    const TemporaryFolder folder;
    App app(screen, {written(folder, "hanging.toml", hanging_scene), "--size", "900x640"});
    app.set("Texture", false);
    app.set("Cloth", false);
    app.press("space");
    const Look before = app.wait_until("the pause", [](const Look& look) { return look.number("paused") == 1; });
    const Box flag = before.box("flag");
    const drapeau::Image without = app.picture();

    app.set("Force colours", true);
    const Look look = app.wait_until("a scale", [](const Look& now) { return now.number("force_scale") > 0; });
    const drapeau::Image with = app.picture();

    // A vertical spring carries what hangs below it: eight masses under the first, one under the last.
    const Mask lines = changed(without, with, flag);
    const double above = redness(with, lines, flag, 0.08, 0.25), below = redness(with, lines, flag, 0.75, 0.92);
    CHECK(above > below + 25);

    // Below the flag a bar runs from white to red.
    const Box view = look.box("view");
    const Box legend{view.x0, view.y1 - 90, view.x1, view.y1};
    CHECK(changed(without, with, legend).count() > 2000);
    bool white = false, red = false;
    for (double y = legend.y0; y < legend.y1; ++y) {
        for (double x = legend.x0; x < legend.x1; ++x) {
            const Colour c = colour_at(with, {x, y});
            white |= c.red > 240 && c.green > 240 && c.blue > 240;
            red |= c.red > 200 && c.green < 60 && c.blue < 60;
        }
    }
    CHECK(white);
    CHECK(red);

    // Off again, the picture is as before.
    app.set("Force colours", false);
    CHECK(changed(without, app.picture(), view).count() == 0);
    app.check_healthy();
}

TEST_CASE_METHOD(ViewOfStillFlag, "every key of the view does what its switch does") {
    app.click("Page: View");
    for (const auto& [key, label] : {std::pair{"t", "Texture"}, std::pair{"s", "Springs"}, std::pair{"d", "Diagonals"},
                                     std::pair{"f", "Force colours"}, std::pair{"m", "Masses"}, std::pair{"c", "Cloth"},
                                     std::pair{"g", "Reference"}, std::pair{"w", "Wind shown"},
                                     std::pair{"e", "Stretch colours"}, std::pair{"v", "Velocities"}}) {
        CAPTURE(key);
        const std::string before = app.settle().controls.at(label).value;
        app.press(key);
        CHECK(app.settle().controls.at(label).value != before);
        app.press(key);
        CHECK(app.settle().controls.at(label).value == before);
    }
    app.press("F1");
    CHECK(app.settle().number("help") == 1);
    app.press("Escape");
    CHECK(app.settle().number("help") == 0);

    const double narrow = app.settle().box("view").width();
    app.press("h");
    CHECK(app.settle().box("view").width() > narrow + 100);
    CHECK(app.settle().text("panel").empty());
    app.check_healthy();

    screen.xdotool({"key", "ctrl+q"});
    CHECK(app.process().wait() == 0);
    CHECK(app.process().errors().empty());
}

TEST_CASE("a reference flies along as a wireframe, and its distance is shown in millimetres") {
    const Screen screen;
    App app(screen, {"report", "--size", "900x640"});
    CHECK(app.settle().number("reference_mm") == -1.0);
    app.press("g");
    const auto apart = [](const Look& look) { return look.number("reference_mm") > 0.0; };
    app.wait_until("a distance", apart);
    CHECK(app.look().controls.at("Reading: Reference").value.find("mm") != std::string::npos);
    app.press("space");
    app.wait_until("the pause", [](const Look& look) { return look.number("paused") == 1; });
    app.settle();
    const Box flag = app.settle().box("flag");
    const auto with = app.picture();
    app.press("g");
    CHECK(app.settle().number("reference_mm") == -1.0);
    // Its lines are gone: 75 of them, of which one along and one across are the least.
    CHECK(changed(with, app.picture(), flag).count() > flag.width() + flag.height());
    app.check_healthy();
}
