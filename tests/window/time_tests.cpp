// Time: the kept moments of a flight looked at and gone on from, steps of all sizes, the speed ladder, the plots.
#include "app.hpp"
#include "pixels.hpp"
#include "scenes.hpp"

#include "catch.hpp"

#include <cmath>

using namespace drapeau::window_tests;

namespace {

constexpr double a_frame = 1.0 / 60.0;  // s

/// Swings down from flat: no two moments look alike.
const std::string falling_scene = R"(name = "Falling"
[flag]
columns = 8
rows = 5
width = 1.5
height = 1.0
attach = "hoist"
[springs]
mass = 0.001
stiffness = 50.0
damping = 0.01
drag = 0.0005
[gravity]
[wind]
velocity = [2.0, 0.0, 1.0]
gusts = [1.0, 0.5, 1.0]
[time]
method = "semi-implicit-euler"
dt = "auto"
)";

struct Flight {
    Screen screen;
    TemporaryFolder folder;
    App app{screen, {written(folder, "falling.toml", falling_scene), "--size", "1000x800"}};

    Flight() { app.click("Page: Time"); }  // where the steps of all sizes are

    Look until_time(double time) {
        return app.wait_until("simulated time", [=](const Look& look) { return look.number("time") >= time; });
    }
    Look pause() {
        app.press("space");
        app.wait_until("a pause", [](const Look& look) { return look.number("paused") == 1; });
        return rested();
    }
    /// At rest nothing is under way any more.
    Look rested() {
        app.settle();
        return app.wait_until("rest", [](const Look& look) { return look.number("resting") == 1; });
    }
    Look after(const std::string& key, int times = 1) {
        std::vector<std::string> keys{"key", "--delay", "8"};  // GLFW drops presses of the same millisecond
        keys.insert(keys.end(), std::size_t(times), key);
        screen.xdotool(keys);
        return rested();
    }
};

/// Where the flag is drawn, whose last digits tell one moment from another.
std::string place(const Look& look) {
    return look.text("flag");
}

}  // namespace

TEST_CASE("a frame back shows the earlier picture, and steps forward lead through the same pictures again") {
    Flight flight;
    flight.until_time(0.3);
    const Look end = flight.pause();
    const Look one = flight.after("comma"), two = flight.after("comma");
    CHECK(one.number("time") == Approx(end.number("time") - a_frame).margin(1e-5));
    CHECK(two.number("time") == Approx(end.number("time") - 2 * a_frame).margin(1e-5));
    CHECK(place(one) != place(end));
    CHECK(place(two) != place(one));
    CHECK(two.text("shown") != "");
    CHECK(place(flight.after("n")) == place(one));
    const Look again = flight.after("n");
    CHECK(place(again) == place(end));
    CHECK(again.text("shown") == "");

    flight.app.click("Frame back");
    CHECK(place(flight.rested()) == place(one));
    flight.app.click("Frame");
    CHECK(place(flight.rested()) == place(end));
    flight.app.check_healthy();
}

TEST_CASE("the timeline is scrubbed, goes on from there as before and drops what came after") {
    Flight flight;
    flight.until_time(0.5);
    const Look end = flight.pause();
    const double from = end.number("kept_from"), to = end.number("kept_to");
    CHECK(from == 0.0);
    CHECK(to == Approx(end.number("time")).margin(1e-6));
    const Box slider = end.controls.at("Timeline").box;
    flight.app.drag(slider.at(0.97, 0.5), slider.at(0.4, 0.5));
    const Look back = flight.rested();
    const double there = back.number("time");
    CHECK(there == Approx(0.4 * to).margin(0.06 * to + a_frame));
    CHECK(back.number("kept_to") == to);
    const int left = int(std::lround((to - there) / a_frame));
    CHECK(place(flight.after("n", left)) == place(end));

    CHECK(flight.after("comma", left).number("time") == there);
    flight.app.press("space");
    flight.app.wait_until("the flight to go on", [&](const Look& look) {
        return look.number("paused") == 0 && look.text("shown").empty() && look.number("time") > to + a_frame;
    });
    // The flight flown again is the same.
    const int beyond = int(std::lround((flight.pause().number("time") - to) / a_frame));
    const Look look = flight.after("comma", beyond);
    CHECK(look.number("time") == Approx(to).margin(1e-5));
    CHECK(place(look) == place(end));
    flight.app.check_healthy();
}

TEST_CASE("a setting that is changed at an earlier moment takes effect from there") {
    Flight flight;
    flight.until_time(0.4);
    const Look end = flight.pause();
    flight.after("comma", 5);
    const double there = flight.app.look().number("time");
    flight.app.press("d");
    const Look changed = flight.app.wait_until(
        "the present", [](const Look& look) { return look.text("shown").empty() && look.number("resting") == 1; });
    CHECK(changed.number("time") == there);
    CHECK(changed.number("kept_to") == Approx(there).margin(1e-6));
    CHECK(changed.number("kept_to") < end.number("kept_to"));
    const std::string diagonals = changed.controls.at("Diagonals").value;
    // The panel shows what the flight was made with, moment by moment.
    CHECK(flight.after("comma").controls.at("Diagonals").value != diagonals);
    CHECK(flight.after("n").controls.at("Diagonals").value == diagonals);
    flight.app.check_healthy();
}

TEST_CASE("a second on and a second back, a step of the method, and backwards to the beginning") {
    Flight flight;
    flight.until_time(0.05);
    const double begin = flight.pause().number("time");
    flight.app.press("Next");
    flight.app.wait_until("a second",
                          [&](const Look& look) { return look.number("time") > begin + 1.0 - 0.5 * a_frame; });
    const Look later = flight.rested();
    CHECK(later.number("time") == Approx(begin + 1.0).margin(1e-5));
    CHECK(later.number("paused") == 1);
    CHECK(flight.after("period").number("steps") == later.number("steps") + 1);
    // From a moment looked at a step goes on, too: what came after is dropped.
    const Look looked_at = flight.after("comma", 3), stepped = flight.after("period");
    CHECK(stepped.number("steps") == looked_at.number("steps") + 1);
    CHECK(stepped.text("shown").empty());
    CHECK(stepped.number("kept_to") == Approx(stepped.number("time")).margin(1e-6));
    const Look back = flight.after("Prior");
    CHECK(back.number("time") == Approx(stepped.number("time") - 1.0).margin(a_frame));
    flight.app.click("Second");
    flight.rested();
    flight.app.press("bracketright");  // twice as fast
    flight.app.press("BackSpace");
    flight.app.wait_until("the way back", [](const Look& look) { return look.number("backwards") == 1; });
    const Look first = flight.app.wait_until(
        "the beginning", [](const Look& look) { return look.number("backwards") == 0 && look.number("time") == 0.0; });
    CHECK(first.number("paused") == 1);
    flight.app.check_healthy();
}

TEST_CASE("the speed ladder is climbed by keys and buttons, and slow motion moves in small steps") {
    Flight flight;
    CHECK(flight.app.look().number("speed") == 1.0);
    flight.app.press("bracketright");
    CHECK(flight.app.settle().number("speed") == 2.0);
    flight.app.click("Faster");
    CHECK(flight.app.settle().number("speed") == 4.0);
    flight.app.press("1");
    CHECK(flight.app.settle().number("speed") == 1.0);
    // Not within a millisecond: GLFW takes a key that comes twice in one for a repetition of its event.
    flight.screen.xdotool({"key", "--delay", "4", "bracketleft", "KP_Divide", "bracketleft", "KP_Divide", "bracketleft",
                           "KP_Divide", "bracketleft"});
    const Look slow =
        flight.app.wait_until("the lowest rung", [](const Look& look) { return look.number("speed") == 0.01; });
    CHECK(slow.controls.at("Speed").value.find("wanted 1/100") == 0);
    // Pictures lie much closer together than frames of the run.
    const double begin = flight.app.look().number("time");
    int moved = 0;
    double last = begin;
    const Look later = flight.app.wait_until("slow motion", [&](const Look& look) {
        const double now = look.number("time");
        if (now > last) ++moved;
        last = now;
        return moved >= 5;
    });
    CHECK(later.number("time") - begin < 4 * a_frame);
    flight.app.click("Speed");
    CHECK(flight.app.settle().number("speed") == 1.0);
    flight.app.check_healthy();
}

TEST_CASE("plots are opened, and show the values of the moment that is looked at") {
    Flight flight;
    flight.until_time(0.4);
    flight.pause();
    flight.app.click("Plots");
    const Look open = flight.app.wait_until("plots", [](const Look& look) { return look.has("Plot: Energy"); });
    const std::string now = open.controls.at("Plot: Tip height").value;
    CHECK(now.find(" m") != std::string::npos);
    CHECK(open.controls.at("Plot: Energy").value.find(" J") != std::string::npos);
    flight.after("comma", 10);
    CHECK(flight.app.look().controls.at("Plot: Tip height").value != now);
    flight.app.click("Plots");
    flight.app.wait_until("no plots", [](const Look& look) { return !look.has("Plot: Energy"); });
    flight.app.check_healthy();
}
