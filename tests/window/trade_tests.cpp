// The page on speed against accuracy: what is measured beside the flag is drawn, and what is clicked there is done.
#include "app.hpp"
#include "scenes.hpp"

#include "catch.hpp"

#include <string>

using namespace drapeau::window_tests;

namespace {

/// A mass on a spring: its settings are measured in a second.
struct Spring {
    Screen screen;
    App app{screen, {"spring", "--size", "1000x800"}};

    Spring() { open("Trade"); }

    void open(const std::string& page) {
        app.click("Page: " + page);
        app.wait_until("the page", [&](const Look& look) { return look.controls.at("Page: " + page).value == "1"; });
        app.settle();
    }
    /// Clicks the button and waits for what comes of it.
    Look measured(const std::string& button, const std::string& found) {
        app.show(button);
        app.click(button);
        return app.wait_until("the measurement",
                              [&](const Look& look) { return look.text("measuring").empty() && look.has(found); });
    }
    std::string value(const std::string& page, const std::string& label) {
        open(page);
        app.show(label);
        return app.look().controls.at(label).value;
    }
};

/// The label of the first control that begins so.
std::string first_of(const Look& look, const std::string& beginning) {
    for (const auto& [label, control] : look.controls)
        if (label.starts_with(beginning)) return label;
    return "";
}

}  // namespace

TEST_CASE_METHOD(Spring, "a setting that was measured is clicked, and the flag is stepped so") {
    const Look look = measured("Measure settings", "Trade chart");
    const std::string label = first_of(look, "Setting: rk4 in double, ");
    REQUIRE(label != "");
    app.settle();
    app.click(label);
    const std::string step = label.substr(label.rfind(", ") + 2);
    const Look after = app.wait_until(
        "the step", [&](const Look& now) { return now.controls.at("Reading: Step").value.starts_with(step); });
    CHECK(after.controls.at("Reading: Step limit").value == "none: the step is given");
    CHECK(value("Time", "Method") == "rk4");
    CHECK(value("Time", "Precision") == "double");
    app.check_healthy();
}

TEST_CASE_METHOD(Spring, "an accuracy picks the method, says why, and a method set by hand ends it") {
    app.set("Accuracy on", true);
    const Look look = app.wait_until("the answer", [](const Look& now) {
        return now.has("Answer") &&
               now.controls.at("Answer").value.find("Of automatic steps the cheapest") != std::string::npos;
    });
    const std::string answer = look.controls.at("Answer").value;
    const std::string method = answer.substr(0, answer.find(' '));
    CHECK(value("Time", "Method") == method);
    CHECK(value("Time", "Step chosen automatically") == "1");
    app.set("Step chosen automatically", false);
    CHECK(value("Trade", "Accuracy on") == "0");
    app.check_healthy();
}

TEST_CASE_METHOD(Spring, "parts that were priced are switched off and on") {
    measured("Price each part", "Part: springs.damping");
    CHECK(value("Springs", "Damping on") == "1");
    open("Trade");
    app.set("Part: springs.damping", false);
    CHECK(value("Springs", "Damping on") == "0");
    open("Trade");
    app.set("Part: gravity", false);
    CHECK(value("Springs", "Gravity") == "0");
    open("Trade");
    app.set("Part: springs.damping", true);
    CHECK(value("Springs", "Damping on") == "1");
    CHECK(value("Springs", "Gravity") == "0");
    app.check_healthy();
}

TEST_CASE_METHOD(Spring, "a measurement is stopped, and the flag flies on") {
    app.show("Price each part");
    app.click("Price each part");
    app.wait_until("its beginning", [](const Look& look) { return look.has("Progress"); });
    app.click("Stop");
    const Look look = app.wait_until("its end", [](const Look& now) { return now.text("measuring").empty(); });
    const double time = look.number("time");
    app.wait_until("the flag", [&](const Look& now) { return now.number("time") > time + 0.2; });
    CHECK_FALSE(app.look().has("Part: springs.damping"));
    CHECK(app.look().has("Price each part"));
    app.check_healthy();
}
