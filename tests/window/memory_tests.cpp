// What the window remembers: settings to go back to, files saved elsewhere, what is kept between runs; and how all of
// it is found.
#include "app.hpp"
#include "still_flag.hpp"

#include "catch.hpp"

#include <filesystem>

using namespace drapeau::window_tests;
namespace fs = std::filesystem;

namespace {

struct MemoryOfStillFlag : StillFlag {
    void wait_for(const std::string& state, const std::string& part) {
        app.wait_until("'" + part + "' in " + state, [&](const Look& look) {
            return part.empty() ? look.text(state).empty() : look.text(state).find(part) != std::string::npos;
        });
    }
    void wait_for_columns(int columns) {
        app.wait_until(std::to_string(columns) + " columns",
                       [columns](const Look& look) { return look.number("columns") == columns; });
    }
    void type_keys(const std::string& text) { screen.xdotool({"type", "--delay", "5", text}); }
};

std::string still_with(const std::string& before, const std::string& after) {
    std::string scene = still_scene;
    return scene.replace(scene.find(before), before.size(), after);
}

/// 10^12 rectangles: it is drawn until its limit of 10 s is over.
std::string svg_of_copies_of_copies() {
    std::string text = R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" )"
                       R"(viewBox="0 0 9 9"><defs><rect id="a0" width="9" height="9"/>)";
    for (int level = 1; level <= 12; ++level) {
        text += "<g id=\"a" + std::to_string(level) + "\">";
        for (int copy = 0; copy < 10; ++copy) text += "<use xlink:href=\"#a" + std::to_string(level - 1) + "\"/>";
        text += "</g>";
    }
    return text + "</defs><use xlink:href=\"#a12\"/></svg>";
}

/// As editors save: a new file takes the name of the old one.
void save_by_renaming(const fs::path& file, const std::string& text) {
    const fs::path aside = file.string() + "~";
    write_text(aside, text);
    fs::rename(aside, file);
}

void quit(App& app, const Screen& screen) {
    screen.xdotool({"key", "ctrl+q"});
    CHECK(app.process().wait() == 0);
    CHECK(app.process().errors().empty());
}

}  // namespace

TEST_CASE_METHOD(MemoryOfStillFlag, "settings are undone and redone by keys and buttons") {
    const Box columns = app.look().controls.at("Columns").box;
    app.drag(columns.at(0.1, 0.5), columns.at(0.3, 0.5));
    const double dragged =
        app.wait_until("more columns",
                       [](const Look& look) { return look.number("columns") > 20 && look.text("undo") == "Columns"; })
            .number("columns");
    app.press("m");
    CHECK(app.settle().text("undo") == "Masses");
    app.press("ctrl+z");
    CHECK(app.settle().controls.at("Masses").value == "0");
    app.press("ctrl+z");
    wait_for_columns(4);
    CHECK(app.settle().text("undo").empty());
    CHECK(app.look().text("redo") == "Columns");
    app.press("ctrl+y");
    wait_for_columns(int(dragged));
    app.press("ctrl+shift+z");
    app.wait_until("the masses", [](const Look& look) { return look.controls.at("Masses").value == "1"; });
    app.click("Undo");
    app.click("Undo");
    wait_for_columns(4);
    app.click("Redo");
    wait_for_columns(int(dragged));

    // While a text is typed the key is the text's.
    app.show("Image file");
    app.click("Image file");
    type_keys("ab");
    app.wait_until("the text", [](const Look& look) { return look.controls.at("Image file").value == "ab"; });
    app.press("ctrl+z");
    app.wait_until("less text", [](const Look& look) { return look.controls.at("Image file").value != "ab"; });
    CHECK(app.settle().number("columns") == dragged);
    app.check_healthy();
}

TEST_CASE_METHOD(MemoryOfStillFlag, "an image is undone too") {
    const std::string before = app.look().text("texture");
    app.show("Image file");
    app.type("Image file", "japan");
    wait_for("texture", "japan.png");
    wait_for("undo", "Image");
    app.press("ctrl+z");
    app.wait_until("the image before", [&](const Look& look) { return look.text("texture") == before; });
    app.press("ctrl+y");
    wait_for("texture", "japan.png");
    app.check_healthy();
}

TEST_CASE_METHOD(MemoryOfStillFlag,
                 "a scene file that is saved elsewhere takes effect, a broken one is told and harms nothing") {
    app.wheel(app.look().box("view").at(0.5, 0.5), 2);
    const std::string camera = app.settle().text("distance");
    app.press("m");
    write_text(file, still_with("columns = 4", "columns = 5"));
    wait_for_columns(5);
    wait_for("message", "still.toml was saved");
    CHECK(app.settle().controls.at("Columns").value == "5");
    CHECK(app.look().controls.at("Masses").value == "1");  // the file says nothing else of it than before
    CHECK(app.look().text("distance") == camera);

    save_by_renaming(file, still_with("columns = 4", "columns = many"));
    wait_for("message", "still.toml:3:");
    CHECK(app.settle().number("columns") == 5);
    // One whose image is not there changes nothing either.
    const std::string texture = app.look().text("texture");
    save_by_renaming(file, still_with("france.png", "lost.png"));
    wait_for("message", "still.toml:9: flag.texture = \"lost.png\"");
    CHECK(app.settle().number("columns") == 5);
    CHECK(app.look().text("texture") == texture);
    // Nor does one whose image is none; with another that is one, both come together.
    write_text(folder / "broken.png", "no picture");
    std::string other = still_with("columns = 4", "columns = 3");
    save_by_renaming(file, other.replace(other.find("france.png"), 10, "broken.png"));
    wait_for("message", "broken.png");
    CHECK(app.settle().text("message").find("still.toml:9: ") != std::string::npos);
    CHECK(app.look().number("columns") == 5);
    CHECK(app.look().text("texture") == texture);
    save_by_renaming(file, other.replace(other.find("broken.png"), 10, "japan.png"));
    wait_for_columns(3);
    wait_for("texture", "japan.png");
    app.press("ctrl+z");
    wait_for_columns(5);
    wait_for("texture", "france.png");
    // One that is broken ends the waiting for the image of the one before.
    write_text(folder / "slow.svg", svg_of_copies_of_copies());
    save_by_renaming(file, other.replace(other.find("japan.png"), 9, "slow.svg"));
    wait_for("loading", "slow.svg");
    save_by_renaming(file, still_with("columns = 4", "columns = = 4"));
    wait_for("message", "still.toml:3:");
    wait_for("loading", "");
    CHECK(app.settle().text("message").find("still.toml:3:") != std::string::npos);
    CHECK(app.look().number("columns") == 5);
    write_text(file, "");
    save_by_renaming(file, still_with("columns = 4", "columns = 6"));
    wait_for_columns(6);
    CHECK(app.settle().text("message").find("still.toml:3:") == std::string::npos);

    // At rest too, where no frame is drawn until something happens.
    app.press("space");
    app.press("Escape");
    app.wait_until("rest", [](const Look& look) { return look.number("resting") == 1; });
    save_by_renaming(file, still_with("columns = 4", "columns = 7"));
    wait_for_columns(7);

    // What was set in the panel comes back by undoing.
    app.type_number("Rows", "9");
    app.wait_until("nine rows", [](const Look& look) { return look.number("rows") == 9; });
    write_text(file, still_with("columns = 4", "columns = 8"));
    wait_for_columns(8);
    CHECK(app.settle().number("rows") == 3);
    CHECK(app.look().text("message").find("Ctrl Z") != std::string::npos);
    app.press("ctrl+z");
    app.wait_until("what was set",
                   [](const Look& look) { return look.number("columns") == 7 && look.number("rows") == 9; });
    app.check_healthy();
}

TEST_CASE_METHOD(MemoryOfStillFlag, "the palette finds a setting and turns to it, and carries out an action") {
    app.press("h");
    app.wait_until("no panel", [](const Look& look) { return look.text("panel").empty(); });
    app.press("ctrl+p");
    app.wait_until("the palette", [](const Look& look) { return look.text("palette") == "1" && look.has("Find"); });
    app.settle();
    type_keys("tolerance");
    app.wait_until("the setting", [](const Look& look) { return look.has("Found: Tolerance"); });
    app.press("Return");
    app.wait_until("its page", [](const Look& look) {
        return look.text("palette") == "0" && look.has("Page: Time") && look.controls.at("Page: Time").value == "1" &&
               look.has("Tolerance on");
    });

    app.press("ctrl+p");
    app.wait_until("the palette", [](const Look& look) { return look.has("Find"); });
    app.settle();
    type_keys("pause");
    app.wait_until("the action", [](const Look& look) {
        return look.has("Found: Pause, go on") && look.controls.at("Found: Pause, go on").value == "1";
    });
    app.press("Return");
    app.wait_until("the pause", [](const Look& look) { return look.number("paused") == 1; });

    app.press("ctrl+p");
    app.wait_until("the palette", [](const Look& look) { return look.has("Find"); });
    app.settle();
    type_keys("m");
    app.wait_until("masses", [](const Look& look) { return look.has("Found: Masses"); });
    app.press("Escape");
    wait_for("palette", "0");
    CHECK(app.settle().controls.at("Masses").value == "0");  // the letter was the text's
    app.press("ctrl+p");
    app.wait_until("the palette", [](const Look& look) { return look.has("Find"); });
    app.settle();
    type_keys("japan");
    app.wait_until("the flag", [](const Look& look) { return look.has("Found: japan"); });
    app.click("Found: japan");
    wait_for("texture", "japan.png");
    app.check_healthy();
}

TEST_CASE_METHOD(MemoryOfStillFlag, "a scene is copied as text and pasted, and what is no scene is refused in a line") {
    app.press("ctrl+c");
    wait_for("message", "Copied");
    app.type_number("Columns", "12");
    wait_for_columns(12);
    app.press("ctrl+v");
    wait_for_columns(4);
    wait_for("message", "Pasted: Still");
    app.press("ctrl+z");
    wait_for_columns(12);

    app.show("Image file");
    app.click("Image file");
    type_keys("nonsense");
    app.wait_until("the text", [](const Look& look) { return look.controls.at("Image file").value == "nonsense"; });
    app.press("ctrl+a");
    app.press("ctrl+c");
    app.press("Escape");
    app.press("ctrl+v");
    wait_for("message", "pasted text:1:");
    CHECK(app.look().text("message").find("\\n") == std::string::npos);
    CHECK(app.settle().number("columns") == 12);
    app.check_healthy();
}

TEST_CASE("the window's size, panel, page and recent files are remembered until they are forgotten") {
    const Screen screen;
    const TemporaryFolder home, folder;
    const fs::path settings = home / "config" / "drapeau" / "settings.toml";
    {
        App app(screen, {written(folder, "mine.toml", still_scene)}, &home);
        app.click("Page: Wind");
        app.resize(1000, 700);
        app.wait_until("the size", [](const Look& look) { return look.text("window") == "1000x700"; });
        app.settle();
        quit(app, screen);
    }
    {
        App app(screen, {"spring"}, &home);
        const Look look = app.wait_until("the size", [](const Look& now) { return now.text("window") == "1000x700"; });
        CHECK(look.controls.at("Page: Wind").value == "1");
        app.click("Scene");
        app.wait_until("the recent file", [](const Look& now) { return now.has("Scene: mine"); });
        app.settle();
        app.click("Scene: mine");
        app.wait_until("the scene", [](const Look& now) { return now.text("scene") == "Still"; });

        app.click("Page: Time");
        app.show("Reset to defaults");
        app.click("Reset to defaults");
        app.wait_until("the question", [](const Look& now) { return now.has("Forget"); });
        app.press("Escape");
        CHECK(read_text(settings).find("mine.toml") != std::string::npos);
        app.show("Reset to defaults");
        app.click("Reset to defaults");
        app.wait_until("the question", [](const Look& now) { return now.has("Forget"); });
        app.press("Return");
        app.wait_until("the answer", [](const Look& now) { return now.text("message").starts_with("Forgotten"); });
        app.press("h");
        app.settle();
        quit(app, screen);
    }
    CHECK(read_text(settings).find("mine.toml") == std::string::npos);
    App app(screen, {"spring"}, &home);
    CHECK(app.settle().text("window") == "1280x800");
    CHECK(app.look().text("panel").empty());
    quit(app, screen);
}

TEST_CASE("settings that cannot be read are put aside with a message, and pictures take no notice of any") {
    const Screen screen;
    const TemporaryFolder home;
    const fs::path settings = home / "config" / "drapeau" / "settings.toml";
    fs::create_directories(settings.parent_path());
    write_text(settings, "width = nan");
    const Finished picture = run({program(), "spring", "--frames", "1"}, at_home_in(home, screen.surroundings()));
    CHECK(picture.status == 0);
    CHECK(read_text(settings) == "width = nan");
    {
        App app(screen, {"spring"}, &home);
        const Look look = app.wait_until("the message", [](const Look& now) {
            return now.text("message").find("settings.toml") != std::string::npos;
        });
        CHECK(look.text("message").find("settings.toml.bad") != std::string::npos);
        CHECK(look.text("window") == "1280x800");
        app.press("Escape");
        app.click("Page: Wind");
        app.settle();
        quit(app, screen);
    }
    CHECK(read_text(settings.string() + ".bad") == "width = nan");
    CHECK(read_text(settings).find("page = \"Wind\"") != std::string::npos);
}

TEST_CASE("without a place for settings the window opens, works and ends as ever") {
    const Screen screen;
    const TemporaryFolder home;
    write_text(home / "config", "a file where the folder should be");
    App app(screen, {"spring"}, &home);
    app.click("Page: Wind");
    app.wait_until("one line", [](const Look& look) { return look.text("message").starts_with("Not remembered"); });
    app.check_healthy();
    quit(app, screen);
    CHECK(read_text(home / "config") == "a file where the folder should be");
}
