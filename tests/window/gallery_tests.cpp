// The galleries of flags and scenes, and files that are dropped on the window.
#include "app.hpp"
#include "dropping.hpp"
#include "pixels.hpp"
#include "scenes.hpp"

#include "catch.hpp"

#include <algorithm>

using namespace drapeau::window_tests;

namespace {

struct Gallery {
    Screen screen;
    TemporaryFolder folder;
    App app;

    explicit Gallery(const std::string& size = "900x640")
        : app(screen, {written(folder, "still.toml", still_scene), "--size", size}) {}

    /// Of one colour, in a file of a name that a URI has to escape.
    std::string green_picture(const std::string& name) {
        drapeau::Image image = drapeau::blank_image(30, 20);
        for (std::size_t i = 0; i < image.rgba.size(); i += 4)
            image.rgba[i] = 10, image.rgba[i + 1] = 160, image.rgba[i + 2] = 40, image.rgba[i + 3] = 255;
        write_png(folder / name, image);
        return folder / name;
    }
    void wait_for_texture(const std::string& ending) {
        app.wait_until("the image " + ending, [&](const Look& look) { return look.text("texture").ends_with(ending); });
    }
    Point on_the_flag() { return app.look().box("flag").at(0.5, 0.5); }
};

struct WideGallery : Gallery {
    WideGallery() : Gallery("1280x800") {}  // every scene is in sight
};

bool is_near(const Colour& a, const Colour& b) {
    return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)}) < 12.0;
}

}  // namespace

TEST_CASE_METHOD(Gallery, "the gallery shows each flag as it is, and a click puts it on") {
    app.show("Flag: ireland");
    const Colour green{0x16, 0x9b, 0x62}, white{255, 255, 255}, orange{255, 0x88, 0x3e};
    const Box box = app.settle().controls.at("Flag: ireland").box;
    drapeau::Image picture = app.picture();
    const auto begin = std::chrono::steady_clock::now();
    while (!is_near(colour_around(picture, box.at(0.25, 0.5), 1), green)) {  // it is made once it comes into sight
        REQUIRE(std::chrono::steady_clock::now() - begin < patience);
        picture = app.picture();
    }
    CHECK(is_near(colour_around(picture, box.at(0.5, 0.5), 1), white));
    CHECK(is_near(colour_around(picture, box.at(0.78, 0.5), 1), orange));

    CHECK(app.look().controls.at("Flag: ireland").value == "0");
    app.click("Flag: ireland");
    wait_for_texture("ireland.png");
    const Look look = app.settle();
    CHECK(look.controls.at("Flag: ireland").value == "1");
    const Colour seen = colour_around(app.picture(), look.box("flag").at(1.0 / 6, 0.5));
    CHECK(seen.green > seen.red + 40);
    app.check_healthy();
}

TEST_CASE_METHOD(Gallery, "the gallery scrolls with its page from plain cloth to the last flag") {
    app.show("Flag: none");
    app.click("Flag: none");
    app.wait_until("plain cloth", [](const Look& look) { return look.text("texture").empty(); });
    app.show("Flag: uv-grid");
    app.click("Flag: uv-grid");
    wait_for_texture("uv-grid.png");
    CHECK(app.settle().controls.at("Flag: uv-grid").value == "1");
    app.check_healthy();
}

TEST_CASE_METHOD(Gallery, "an image dropped on the window lies on the flag and stays in the gallery") {
    const std::string file = green_picture("a b%41\xc3\xa9.png");
    drop_files(screen, app, on_the_flag(), {file});
    wait_for_texture(file);
    const Colour seen = colour_around(app.picture(), on_the_flag());
    CHECK(seen.green > seen.red + 60);
    CHECK(app.look().text("message").empty());

    // It is there to be put on again after another.
    app.show("Flag: ukraine");
    app.click("Flag: ukraine");
    wait_for_texture("ukraine.png");
    app.wheel(app.look().box("panel").at(0.5, 0.5), 30);
    app.show("Flag: a b%41\xc3\xa9.png");
    app.click("Flag: a b%41\xc3\xa9.png");
    wait_for_texture(file);
    app.check_healthy();
}

TEST_CASE_METHOD(Gallery, "a scene dropped on the window opens, and what is neither gives a message") {
    std::string scene = still_scene;
    scene.replace(scene.find("Still"), 5, "Dropped");
    drop_files(screen, app, on_the_flag(), {written(folder, "dropped scene.toml", scene)});
    app.wait_until("the scene", [](const Look& look) { return look.text("scene") == "Dropped"; });
    const std::string before = app.look().text("texture");

    drop_files(screen, app, on_the_flag(), {written(folder, "neither.txt", "neither")});
    app.wait_until("a message",
                   [](const Look& look) { return look.text("message").find("neither.txt") != std::string::npos; });
    CHECK(app.look().text("scene") == "Dropped");
    CHECK(app.look().text("texture") == before);
    app.check_healthy();
}

TEST_CASE_METHOD(WideGallery,
                 "the gallery of scenes opens the one that is clicked, and is closed by Escape or its button") {
    const auto closed = [](const Look& look) { return !look.has("Close scenes"); };
    const auto opened = [](const Look& look) { return look.has("Close scenes"); };
    app.click("Scenes");
    app.wait_until("the gallery", opened);
    app.press("Escape");
    app.wait_until("it to be closed", closed);
    app.press("o");
    const Look look = app.wait_until("the gallery", opened);
    for (const std::string scene : {"report", "storm", "spring", "halfmast"}) CHECK(look.has("Open: " + scene));
    CHECK(look.box("view").contains(look.controls.at("Open: storm").box.at(0.5, 0.5)));
    app.click("Close scenes");
    app.wait_until("it to be closed", closed);
    CHECK(app.look().text("scene") == "Still");

    app.press("o");
    app.wait_until("the gallery", opened);
    app.click("Open: spring");
    app.wait_until("the scene", [](const Look& now) { return now.text("scene") == "Spring"; });
    CHECK(closed(app.settle()));
    app.check_healthy();
}
