// Files chosen in the window: read beside the picture, saved over others only if a person agrees.
#include "app.hpp"
#include "pixels.hpp"
#include "scenes.hpp"

#include "catch.hpp"

#include <chrono>

using namespace drapeau::window_tests;

namespace {

struct FlyingFlag {
    Screen screen;
    TemporaryFolder folder;
    App app{screen, without_cloth("report")};

    void wait_for_message(const std::string& part) {
        app.wait_until("a message with '" + part + "'",
                       [&part](const Look& look) { return look.text("message").find(part) != std::string::npos; });
    }
    void wait_for_question(const std::string& part) {
        app.wait_until("a question with '" + part + "'", [&part](const Look& look) {
            return part.empty() ? look.text("question").empty() : look.text("question").find(part) != std::string::npos;
        });
    }
};

/// Copies of copies, 10^12 rectangles: it is drawn until its limit of 10 s of processor time is over.
std::string slow_picture(const TemporaryFolder& folder) {
    std::string copies = R"(<g id="a0"><rect width="3" height="2"/></g>)";
    for (int i = 1; i <= 12; ++i) {
        copies += "<g id=\"a" + std::to_string(i) + "\">";
        for (int copy = 0; copy < 10; ++copy) copies += "<use xlink:href=\"#a" + std::to_string(i - 1) + "\"/>";
        copies += "</g>";
    }
    return written(folder, "slow.svg",
                   "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
                   "viewBox=\"0 0 3 2\">" +
                       copies + "</svg>");
}

/// An image whose right half is transparent.
std::string half_picture(const TemporaryFolder& folder) {
    drapeau::Image image = drapeau::blank_image(60, 40);
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width / 2; ++column) {
            std::uint8_t* const pixel = image.pixel(column, row);
            pixel[0] = 220, pixel[1] = 30, pixel[2] = 30, pixel[3] = 255;
        }
    write_png(folder / "half.png", image);
    return folder / "half.png";
}

}  // namespace

TEST_CASE_METHOD(FlyingFlag, "the flag goes on flying while an image is loaded, and a newer choice takes its place") {
    app.show("Image file");
    app.type("Image file", slow_picture(folder));
    const Look begun = app.wait_until("loading", [](const Look& look) { return look.text("loading") == "slow.svg"; });
    const Look flying = app.wait_until(
        "time to pass", [&](const Look& look) { return look.number("time") > begun.number("time") + 0.5; });
    CHECK(flying.text("loading") == "slow.svg");
    CHECK(flying.text("texture") == begun.text("texture"));
    app.type("Image file", "japan");
    app.wait_until("the newer image", [](const Look& look) { return look.text("texture").ends_with("japan.png"); });
    CHECK(app.look().text("loading").empty());
    CHECK(app.look().text("message").empty());
    app.check_healthy();
}

TEST_CASE_METHOD(FlyingFlag, "the window closes at once while an image is loaded") {
    app.show("Image file");
    app.type("Image file", slow_picture(folder));
    app.wait_until("loading", [](const Look& look) { return !look.text("loading").empty(); });
    const auto begin = std::chrono::steady_clock::now();
    screen.xdotool({"key", "ctrl+q"});
    CHECK(app.process().wait() == 0);
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(4));
}

TEST_CASE_METHOD(FlyingFlag, "the message of a file that cannot be loaded goes when another can") {
    app.show("Image file");
    app.type("Image file", written(folder, "text.png", "no picture"));
    wait_for_message("text.png");
    app.type("Image file", "japan");
    app.wait_until("the image", [](const Look& look) { return look.text("texture").ends_with("japan.png"); });
    CHECK(app.settle().text("message").empty());

    app.click("Page: Time");
    app.show("Scene file");
    app.type("Scene file", written(folder, "broken.toml", "colour = 1\n"));
    wait_for_message("broken.toml");
    app.type("Scene file", "drum");
    app.wait_until("the drum", [](const Look& look) { return look.text("scene") == "Drum"; });
    CHECK(app.settle().text("message").empty());
    app.check_healthy();
}

TEST_CASE_METHOD(FlyingFlag, "a file that exists is overwritten only if a person agrees") {
    const std::string foreign = written(folder, "foreign.toml", "precious");
    app.click("Page: Time");
    app.show("Save as");
    for (const bool by_key : {true, false}) {
        app.type("Save as", foreign);
        wait_for_question("foreign.toml exists and is not a scene.");
        by_key ? app.press("Escape") : app.click("Cancel");
        wait_for_question("");
        CHECK(read_text(foreign) == "precious");
        CHECK(app.settle().text("message").empty());
    }
    app.type("Save as", foreign);
    wait_for_question("foreign.toml");
    app.press("Return");
    wait_for_message("Saved ");
    CHECK(read_text(foreign).find("[springs]") != std::string::npos);

    // Written by this session: it is saved again without a question.
    app.press("Escape");
    app.wait_until("the message is closed", [](const Look& look) { return look.text("message").empty(); });
    app.show("Save scene");  // a little further down
    app.click("Save scene");
    wait_for_message("Saved ");
    CHECK(app.look().text("question").empty());

    const std::string other = written(folder, "other.toml", read_text(foreign));
    app.type("Save as", other);
    wait_for_question("other.toml exists. Overwrite it?");
    app.click("Overwrite");
    wait_for_message("other.toml");
    app.check_healthy();
}

TEST_CASE_METHOD(FlyingFlag, "a scene is not saved over the image on its flag") {
    const std::string image = half_picture(folder), before = read_text(image);
    app.show("Image file");
    app.type("Image file", image);
    app.wait_until("the image", [&](const Look& look) { return look.text("texture") == image; });
    app.click("Page: Time");
    app.show("Save as");
    app.type("Save as", image);
    wait_for_message("half.png: the image on the flag");
    CHECK(app.look().text("question").empty());
    CHECK(read_text(image) == before);
    // The failure goes with the next success.
    app.type("Save as", folder / "good.toml");
    wait_for_message("Saved ");
    app.check_healthy();
}

TEST_CASE("a flag that starts hanging settles in sight, and the window lives meanwhile") {
    const Screen screen;
    const TemporaryFolder folder;
    const std::string slow =
        "name = \"Slow\"\n[flag]\ncolumns = 200\nrows = 200\nattach = \"grommets\"\nstart = \"hanging\"\n"
        "[springs]\nmass = 1e-5\nstiffness = 1000.0\ndiagonal_stiffness = 500.0\n[gravity]\n";
    App app(screen, {"drum", "--size", "900x800"});
    app.click("Page: Time");
    app.show("Scene file");
    const auto is_settling = [](const Look& look) { return look.number("settling") == 1; };
    const auto open_slow = [&] {
        app.type("Scene file", written(folder, "slow.toml", slow));
        return app.wait_until("settling", is_settling);
    };
    // How long it settles is the machine's affair: what was seen until its end counts.
    const Look first = open_slow();
    Look last = first;
    app.wait_until("the flag at rest", [&](const Look& look) {
        if (!is_settling(look)) return true;
        last = look;
        return false;
    });
    CHECK(last.number("time") == first.number("time"));
    CHECK(last.number("frame") > first.number("frame"));
    // Another scene does not wait for it.
    open_slow();
    app.type("Scene file", "report");
    app.wait_until("the report", [](const Look& look) { return look.text("scene") == "Report"; });
    CHECK(app.settle().number("settling") == 0);
    app.check_healthy();
}

TEST_CASE("why a run stopped can be read again after its message was closed") {
    const Screen screen;
    const TemporaryFolder folder;
    App app(screen, {written(folder, "apart.toml", diverging_scene()), "--size", "900x640"});
    const Look apart =
        app.wait_until("the end of the run", [](const Look& look) { return look.number("diverged") == 1; });
    CHECK(!apart.has("Stopped"));
    app.press("Escape");
    app.wait_until("the line", [](const Look& look) { return look.has("Stopped") && look.text("message").empty(); });
    app.click("Stopped");
    app.wait_until("the message", [&](const Look& look) {
        return look.text("message") == apart.text("message") && !look.has("Stopped");
    });
    app.click("Use the safe step");
    app.wait_until("it to go on", [&](const Look& look) {
        return look.number("diverged") == 0 && look.number("time") > apart.number("time") + 0.1;
    });
    CHECK(app.look().text("message").empty());
    CHECK(!app.look().has("Stopped"));
    app.check_healthy();
}

TEST_CASE("where an image is transparent there is no cloth and no shadow, or pale cloth if that is wished") {
    const Screen screen;
    const TemporaryFolder folder;
    half_picture(folder);
    std::string scene = still_scene;  // held at its top, so that it stands over ground
    scene.replace(scene.find("france.png"), std::string("france.png").size(), "half.png");
    scene.replace(scene.find("\"none\""), std::string("\"none\"").size(), "\"top\"");
    for (const std::string azimuth : {"0", "180"}) {
        CAPTURE(azimuth);
        App app(screen, {written(folder, "half.toml", scene), "--size", "900x640", "--azimuth", azimuth});
        const Look look = app.settle();
        const Box flag = look.box("flag"), view = look.box("view");
        const Box below{view.x0, flag.y1 + 4.0, view.x1, view.y1};
        const bool front = azimuth == "0";
        const Point opaque = flag.at(front ? 0.25 : 0.75, 0.5), open = flag.at(front ? 0.75 : 0.25, 0.5);
        const drapeau::Image cut = app.picture();
        app.set("Cut out", false);
        const drapeau::Image whole = app.picture();
        app.set("Cloth", false);
        const drapeau::Image nothing = app.picture();
        const Colour red = colour_around(cut, opaque), pale = colour_around(whole, open);
        CHECK(red.red > red.blue + 60);
        CHECK(pale.red > 100.0);
        CHECK(pale.vividness() < 60.0);
        CHECK(changed(cut, nothing, {open.x - 5, open.y - 5, open.x + 5, open.y + 5}, 2).count() == 0);
        if (!front) continue;  // the shadow falls out of sight
        // Half a flag throws about half its shadow.
        const int half = changed(cut, nothing, below).count(), full = changed(whole, nothing, below).count();
        CHECK(full > 200);
        CHECK(half > full / 4);
        CHECK(half < full * 3 / 4);
        app.check_healthy();
    }
}
