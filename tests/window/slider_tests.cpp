// Sliders: numbers beside their bars, and typed; tips beside the panel; the palette's buttons and choices; small
// windows, of which every part can be reached.
#include "app.hpp"
#include "still_flag.hpp"

#include "catch.hpp"

#include <thread>

using namespace drapeau::window_tests;

namespace {

struct BarePanel {
    Screen screen;
    TemporaryFolder folder;
    std::string file = written(folder, "bare.toml", still_scene + "[view]\ncloth = false\n");
    App app;

    explicit BarePanel(const std::string& size = "900x640") : app(screen, {file, "--size", size}) {
        app.press("space");
        app.wait_until("the pause", [](const Look& look) { return look.number("paused") == 1; });
    }

    std::string value(const std::string& label) { return app.settle().controls.at(label).value; }
    void wait_for_value(const std::string& label, const std::string& wanted) {
        app.wait_until("'" + label + "' to be " + wanted,
                       [&](const Look& look) { return look.has(label) && look.controls.at(label).value == wanted; });
    }
    void type_keys(const std::vector<std::string>& keys) {
        std::vector<std::string> command{"key", "--delay", "0"};
        command.insert(command.end(), keys.begin(), keys.end());
        screen.xdotool(command);
    }
    void find(const std::string& text) {
        screen.xdotool({"key", "--delay", "0", "ctrl+p"});
        screen.xdotool({"type", "--delay", "0", text});
        app.wait_until("'" + text + "'",
                       [&](const Look& look) { return look.has("Find") && look.controls.at("Find").value == text; });
        app.settle();
        app.press("Return");
        app.wait_until("the palette to be gone", [](const Look& look) { return look.number("palette") == 0; });
    }
};

bool overlap(const Box& a, const Box& b) {
    return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

/// Numbers begin in one column right of their bars, and end within the panel; nothing lies over them.
void check_numbers(const Look& look) {
    const Box panel = look.box("panel");
    const std::string sign = "Number: ";
    double column = 0.0;
    for (const auto& [label, number] : look.controls) {
        if (!label.starts_with(sign) || label == "Number: Timeline") continue;
        CAPTURE(label, number.value);
        const Control& bar = look.controls.at(label.substr(sign.size()));
        CHECK(number.box.x0 >= bar.box.x1);
        CHECK(number.box.x1 <= panel.x1 - 20.0);
        CHECK(bar.box.width() >= 30.0);
        if (column > 0.0) CHECK(number.box.x0 == Approx(column).margin(1.0));
        column = number.box.x0;
        for (const auto& [other, control] : look.controls)
            if (other != label) CHECK_FALSE(overlap(control.box, number.box));
    }
    CHECK(column > 0.0);
}

}  // namespace

TEST_CASE("numbers stand beside their bars in one column, in windows and texts of any size") {
    for (const auto& [size, dots_per_inch] : {std::pair{"1280x800", 96}, {"900x640", 96}, {"1280x800", 192}}) {
        CAPTURE(size, dots_per_inch);
        const Screen screen;
        const TemporaryFolder folder;
        screen.use_dpi(dots_per_inch);
        App app(screen, {written(folder, "bare.toml", still_scene + "[view]\ncloth = false\n"), "--size", size});
        for (const std::string page : {"Page: Flag", "Page: Springs"}) {
            app.click(page);
            app.show(page == "Page: Flag" ? "Number: Width" : "Number: Stiffness");
            check_numbers(app.settle());
        }
        app.check_healthy();
    }
}

TEST_CASE_METHOD(BarePanel, "a double click on a bar types its number, and the value is what is typed, in one change") {
    const Box bar = app.settle().controls.at("Width").box;
    for (const std::string delay : {"60", "0"}) {  // slower and faster than frames
        CAPTURE(delay);
        app.move_to(bar.at(0.8, 0.5));
        screen.xdotool({"click", "--repeat", "2", "--delay", delay, "1"});
        const Look open = app.wait_until(
            "the field", [](const Look& look) { return look.has("Width") && !look.has("Number: Width"); });
        CHECK(open.controls.at("Width").value == "1.5");
        CHECK(open.text("undo").empty());
        screen.xdotool({"type", "--delay", "0", "0.875"});        // it takes the place of the number
        CHECK(app.settle().controls.at("Width").value == "1.5");  // until the number is whole
        app.press("Return");
        wait_for_value("Number: Width", "0.88 m");
        app.press("ctrl+z");
        wait_for_value("Width", "1.5");
        app.wait_until("nothing more to undo", [](const Look& look) { return look.text("undo").empty(); });
    }
    app.double_click(bar.at(0.3, 0.5));
    app.wait_until("the field", [](const Look& look) { return !look.has("Number: Width"); });
    app.press("Escape");
    app.wait_until("the bar", [](const Look& look) { return look.has("Number: Width"); });
    CHECK(value("Width") == "1.5");
    CHECK(app.look().text("undo").empty());

    // What was begun is left by Escape, and what is beyond the bar is told.
    app.double_click(bar.at(0.3, 0.5));
    app.wait_until("the field", [](const Look& look) { return !look.has("Number: Width"); });
    type_keys({"9", "Escape"});
    app.wait_until("the bar", [](const Look& look) { return look.has("Number: Width"); });
    CHECK(value("Width") == "1.5");
    CHECK(app.look().text("undo").empty());
    app.double_click(bar.at(0.3, 0.5));
    app.wait_until("the field", [](const Look& look) { return !look.has("Number: Width"); });
    type_keys({"9", "9", "9", "9", "Return"});
    app.wait_until("a message", [](const Look& look) {
        return look.text("message") == "Width = 9999 m: 0.001 m to 1000 m is allowed, 1000 m is taken.";
    });
    CHECK(value("Number: Width") == "1000.00 m");
    app.type_number("Width", "20");  // more than its bar has, no more than a scene may have
    wait_for_value("Number: Width", "20.00 m");

    // With a unit of its own, as with another prefix; not with one of something else.
    app.double_click(bar.at(0.3, 0.5));
    app.wait_until("the field", [](const Look& look) { return !look.has("Number: Width"); });
    screen.xdotool({"type", "--delay", "0", "150 cm"});
    app.press("Return");
    wait_for_value("Number: Width", "1.50 m");
    app.double_click(bar.at(0.3, 0.5));
    app.wait_until("the field", [](const Look& look) { return !look.has("Number: Width"); });
    screen.xdotool({"type", "--delay", "0", "2 ft"});
    app.press("Return");
    app.wait_until("a message", [](const Look& look) {
        return look.text("message") == "Width = 2 ft: no number of m; it stays 1.5 m.";
    });
    CHECK(value("Number: Width") == "1.50 m");
    app.check_healthy();
}

TEST_CASE_METHOD(BarePanel, "a click on a number types it, Tab goes on to the next, and a click on a bar sets it") {
    app.click("Number: Width");
    app.wait_until("the field", [](const Look& look) { return !look.has("Number: Width"); });
    type_keys({"2", "Tab"});
    app.wait_until("the next field", [](const Look& look) { return !look.has("Number: Height"); });
    type_keys({"3", "Return"});
    wait_for_value("Number: Height", "3.00 m");
    CHECK(value("Number: Width") == "2.00 m");

    // Shift and Tab go back.
    app.click("Number: Height");
    app.wait_until("the field", [](const Look& look) { return !look.has("Number: Height"); });
    type_keys({"4", "shift+Tab"});
    app.wait_until("the field before", [](const Look& look) { return !look.has("Number: Width"); });
    type_keys({"1", "Return"});
    wait_for_value("Number: Width", "1.00 m");
    CHECK(value("Number: Height") == "4.00 m");
    app.press("ctrl+z");
    app.press("ctrl+z");
    wait_for_value("Number: Width", "2.00 m");

    const Box bar = app.look().controls.at("Width").box;
    app.click(bar.at(0.9, 0.5));
    const Look set =
        app.wait_until("the width", [](const Look& look) { return std::stod(look.controls.at("Width").value) > 4.0; });
    CHECK(set.has("Number: Width"));
    app.press("ctrl+z");
    wait_for_value("Width", "2");
    app.check_healthy();
}

TEST_CASE_METHOD(BarePanel, "a seed may be greater than any other number") {
    app.click("Page: Wind");
    app.set("Wind", true);
    app.show("Seed");
    app.type_number("Seed", "5000000000");
    wait_for_value("Number: Seed", "5000000000");
    app.check_healthy();
}

TEST_CASE_METHOD(BarePanel, "Escape closes a list that is open, and nothing else") {
    app.press("ctrl+c");
    app.wait_until("a message", [](const Look& look) { return !look.text("message").empty(); });
    app.click("Held by");
    app.wait_until("the list", [](const Look& look) { return look.has("Held by: grommets"); });
    app.press("Escape");
    app.wait_until("no list", [](const Look& look) { return !look.has("Held by: grommets"); });
    CHECK(app.look().controls.at("Held by").value == "none");
    app.press("Escape");
    app.wait_until("no message", [](const Look& look) { return look.text("message").empty(); });
    app.check_healthy();
}

TEST_CASE_METHOD(BarePanel, "a tip comes when the mouse has rested, beside the panel and within the window") {
    app.click("Page: Time");
    app.settle();
    app.move_to(app.look().controls.at("Method").box.at(0.5, 0.5));
    CHECK_FALSE(app.look().has("Tip"));  // not at once
    const Look look = app.wait_until("the tip", [](const Look& now) { return now.has("Tip"); });
    const Box tip = look.controls.at("Tip").box;
    CHECK(look.controls.at("Tip").value.find("time.method") != std::string::npos);
    CHECK_FALSE(overlap(tip, look.box("panel")));
    CHECK(tip.x1 <= 900.0);
    CHECK(tip.y0 >= 0.0);
    CHECK(tip.y1 <= 640.0);
    app.move_to(look.box("view").at(0.8, 0.9));
    app.wait_until("it to be gone", [](const Look& now) { return !now.has("Tip"); });
    app.check_healthy();
}

struct WidePanel : BarePanel {
    WidePanel() : BarePanel("1280x800") {}
};

TEST_CASE_METHOD(WidePanel, "the palette presses buttons, takes choices of lists, and loses no letter typed at once") {
    find("background: studio");
    app.click("Page: View");
    wait_for_value("Background", "studio");
    find("method: rk4");
    app.click("Page: Time");
    wait_for_value("Method", "rk4");
    find("plots");
    wait_for_value("Plots", "1");
    find("save shape");
    app.wait_until("the shape", [](const Look& look) { return look.text("message").ends_with(".obj"); });
    app.click("Page: Flag");
    find("save as");
    app.wait_until("the page", [](const Look& look) { return look.has("Save as"); });
    app.type("Save as", folder / "kept.toml");
    app.click("Page: Flag");
    std::filesystem::remove(folder / "kept.toml");
    find("save scene");
    app.wait_until("the file", [&](const Look&) { return std::filesystem::exists(folder / "kept.toml"); });
    app.check_healthy();
}

TEST_CASE("in a small window the list of keys and the scenes fit, and scroll to their ends") {
    BarePanel small("640x480");
    App& app = small.app;
    app.press("F1");
    app.settle();
    const auto wheel_until = [&](const std::string& label) {
        app.settle();
        for (int notches = 0; !app.look().has(label); ++notches) {
            REQUIRE(notches < 60);
            app.wheel({320.0, 240.0}, -1);
        }
        const Look look = app.settle();
        const Box box = look.controls.at(label).box;
        CHECK(box.x0 >= 0.0);
        CHECK(box.x1 <= 640.0);
        return box;
    };
    wheel_until("Close keys");
    app.press("Escape");
    app.press("o");
    CHECK(wheel_until("Open: report").width() >= 380.0);
    CHECK(wheel_until("Open: storm").width() >= 380.0);
    app.check_healthy();
}

TEST_CASE_METHOD(BarePanel, "the plots are within reach in a window that has no room for them") {
    app.show("Plots");
    app.click("Plots");
    app.wait_until("the plots", [](const Look& look) { return look.has("Plots") && look.has("Plot: Energy"); });
    app.show("Plot: Step of limit");
    app.check_healthy();
}
