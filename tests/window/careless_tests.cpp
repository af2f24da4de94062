// A careless hand: clicks, drags, turns of the wheel and keys drawn at random, the same in every run.
#include "app.hpp"

#include "catch.hpp"

#include <random>

using namespace drapeau::window_tests;

namespace {

/// Every key that does something but those that end the program, and some that mean nothing.
const std::vector<std::string> keys{"space",  "period", "r",         "comma",       "n",
                                    "Prior",  "Next",   "BackSpace", "bracketleft", "1",
                                    "t",      "s",      "d",         "f",           "m",
                                    "c",      "g",      "w",         "u",           "l",
                                    "h",      "o",      "a",         "p",           "bracketright",
                                    "F1",     "Escape", "Return",    "Left",        "Right",
                                    "Up",     "Down",   "plus",      "minus",       "Home",
                                    "Tab",    "ctrl+z", "ctrl+y",    "ctrl+p",      "ctrl+c",
                                    "ctrl+v", "ctrl+r", "Delete",    "KP_Multiply", "KP_Divide",
                                    "e",      "v",      "x",         "7",           "ctrl+shift+z"};

struct Hand {
    Screen& screen;
    App& app;
    std::mt19937 random;

    int below(int count) { return int(random() % unsigned(count)); }
    std::vector<std::string> somewhere() {
        return {"mousemove", std::to_string(below(900)), std::to_string(below(640))};
    }
    void act() {
        std::vector<std::string> words = somewhere();
        const auto then = [&](const std::vector<std::string>& more) {
            words.insert(words.end(), more.begin(), more.end());
        };
        const std::string button = std::to_string(1 + below(3));
        switch (below(6)) {
            case 0:
            case 1:
                return void(screen.xdotool({"key", "--delay", "8", keys[std::size_t(below(int(keys.size())))]}));
            case 2:
                then({"click", "--repeat", std::to_string(1 + below(2)), button});
                break;
            case 3:
                then({"click", "--repeat", std::to_string(1 + below(8)), std::to_string(4 + below(2))});
                break;
            case 4:
                then({"keydown", "shift", "mousedown", "1"}), then(somewhere());
                then({"sleep", "0.03", "mouseup", "1", "keyup", "shift"});
                break;
            default:
                then({"mousedown", button}), then(somewhere()), then({"sleep", "0.03"}), then(somewhere());
                then({"mouseup", button});
        }
        screen.xdotool(words);
    }
};

}  // namespace

TEST_CASE("three hundred careless clicks, drags and keys leave a window that works") {
    Screen screen;
    App app(screen, {"breeze", "--size", "900x640", "--set", "flag.columns=16", "--set", "flag.rows=11"});
    Hand hand{screen, app, std::mt19937(20)};
    for (int n = 1; n <= 300; ++n) {
        CAPTURE(n);
        hand.act();
        if (n % 30 == 0) app.settle();
    }
    for (int n = 0; n < 6; ++n) app.press("Escape");
    const Look look = app.settle();
    for (const auto& [state, value] : look.states) {
        CAPTURE(state, value);
        CHECK(value.find("nan") == std::string::npos);
        CHECK(value.find("inf") == std::string::npos);
    }
    app.check_healthy();
}
