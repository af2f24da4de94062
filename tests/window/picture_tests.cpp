// What the picture makes of the cloth: a smooth surface between the masses, shadows of folds, and two sides.
#include "app.hpp"
#include "pixels.hpp"
#include "scenes.hpp"

#include "image/image_file.hpp"

#include "catch.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace drapeau::window_tests;

namespace {

/// Crumpled and far too heavy for its springs to move: `columns` by `rows` masses, `width` by `height` (m).
std::string folded_scene(int columns, int rows, const std::string& width, const std::string& height,
                         const std::string& texture) {
    return "name = \"Folded\"\n[flag]\ncolumns = " + std::to_string(columns) + "\nrows = " + std::to_string(rows) +
           "\nwidth = " + width + "\nheight = " + height + "\nattach = \"none\"\nstart = \"crumpled\"\ntexture = \"" +
           texture + "\"\n[springs]\nmass = 1e5\nstiffness = 1.0\n[time]\ndt = \"auto\"\n";
}

/// An image whose left third is red and transparent, and whose rest is green and opaque.
std::string third_picture(const TemporaryFolder& folder) {
    drapeau::Image image = drapeau::blank_image(60, 40);
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) {
            std::uint8_t* const pixel = image.pixel(column, row);
            const bool left = column < image.width / 3;
            pixel[0] = left ? 200 : 0, pixel[1] = left ? 0 : 200, pixel[2] = 0, pixel[3] = left ? 0 : 255;
        }
    write_png(folder / "third.png", image);
    return folder / "third.png";
}

bool is_green(const Colour& c) {
    return c.green > 2.0 * std::max(c.red, c.blue);
}

/// The left edge of a mask, from one share of its height to another: pixels from its left border, row by row.
std::vector<double> left_edge(const Mask& mask, double from, double to) {
    std::vector<double> edge;
    for (int y = int(from * mask.height); y < int(to * mask.height); ++y)
        for (int x = 0; x < mask.width; ++x)
            if (mask.at(x, y)) {
                edge.push_back(x);
                break;
            }
    return edge;
}

/// The sharpest bend of a line: the greatest change of its slope within twice `reach` pixels.
double sharpest_bend(const std::vector<double>& line, std::size_t reach) {
    double sharpest = 0.0;
    for (std::size_t i = 2 * reach; i + 2 * reach < line.size(); ++i)
        sharpest = std::max(sharpest, std::abs(line[i - reach] - 2.0 * line[i] + line[i + reach]) / double(reach));
    return sharpest;
}

}  // namespace

TEST_CASE("between the masses the surface is smooth, and a switch shows the bare grid") {
    const Screen screen;
    const TemporaryFolder folder;
    // A ribbon, seen from above: its edge is a line through nine masses. In the middle of it nothing hides it.
    App app(screen, {written(folder, "ribbon.toml", folded_scene(9, 2, "0.5", "0.03", "")), "--size", "900x640",
                     "--elevation", "60"});
    app.press("space");
    app.wait_until("the pause", [](const Look& now) { return now.number("paused") == 1; });
    app.wheel(app.look().box("view").at(0.5, 0.5), 8);
    const Box flag = app.settle().box("flag");
    const Box around{flag.x0 - 20, flag.y0 - 20, flag.x1 + 20, flag.y1 + 20};
    const drapeau::Image smooth = app.picture();
    app.click("Page: View");
    app.show("Bare grid");
    app.set("Bare grid", true);
    const drapeau::Image bare = app.picture();
    app.set("Cloth", false);
    const drapeau::Image nothing = app.picture();
    app.set("Cloth", true);
    app.set("Bare grid", false);
    CHECK(changed(smooth, app.picture(), around).count() == 0);

    CHECK(changed(smooth, bare, around).count() > 2000);
    const std::size_t reach = 12;  // pixels; a cell is about 100 long
    const double bend = sharpest_bend(left_edge(changed(nothing, smooth, around), 0.4, 0.8), reach);
    const double kink = sharpest_bend(left_edge(changed(nothing, bare, around), 0.4, 0.8), reach);
    CAPTURE(bend, kink);
    CHECK(bend < 0.67 * kink);
    app.check_healthy();
}

TEST_CASE("a fold that is cut out of the cloth casts no shadow on the rest") {
    const Screen screen;
    const TemporaryFolder folder;
    App app(screen, {written(folder, "folds.toml", folded_scene(40, 20, "1.0", "0.5", third_picture(folder))), "--size",
                     "900x640"});
    app.press("space");
    const Look look = app.wait_until("the pause", [](const Look& now) { return now.number("paused") == 1; });
    const Box flag = look.box("flag");
    const drapeau::Image without = app.picture();
    app.set("Cut out", false);
    const drapeau::Image with = app.picture();
    int shaded = 0;
    for (double y = flag.y0; y < flag.y1; ++y)
        for (double x = flag.x0; x < flag.x1; ++x) {
            const Colour lit = colour_at(without, {x, y}), dark = colour_at(with, {x, y});
            if (is_green(lit) && is_green(dark) && dark.green < 0.8 * lit.green) ++shaded;
        }
    CHECK(shaded > 400);
    app.check_healthy();
}

TEST_CASE("the back of the cloth shows the front in a mirror") {
    const Screen screen;
    const TemporaryFolder folder;
    App app(screen, {written(folder, "still.toml", still_scene), "--size", "900x640", "--azimuth", "180"});
    const Box flag = app.settle().box("flag");
    const drapeau::Image back = app.picture();
    const Colour left = colour_around(back, flag.at(1.0 / 6, 0.5)), right = colour_around(back, flag.at(5.0 / 6, 0.5));
    CHECK(left.red > left.blue + 40);
    CHECK(right.blue > right.red + 20);
    app.check_healthy();
}
