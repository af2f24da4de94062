// What happened to the window since the last frame, in order.
#pragma once

#include <glm/vec2.hpp>

#include <string>
#include <vector>

namespace drapeau {

/// Keys that do something whatever the keyboard's layout; of others only their letter and what they type counts.
enum class Key {
    other,
    space,
    escape,
    enter,
    f1,
    home,
    left,
    right,
    up,
    down,
    keypad_add,
    keypad_subtract,
    keypad_decimal,
    keypad_divide,
    keypad_multiply,
    page_up,
    page_down,
    backspace
};
enum class MouseButton { left, right, middle, other };

struct InputEvent {
    /// A character comes right after the key that types it, or alone: from an input method, or while a key repeats.
    /// `window`: its size, its focus or what covers it changed.
    enum class Kind { key, key_up, character, press, release, move, scroll, drop, window };
    Kind kind = Kind::key;
    Key key = Key::other;
    MouseButton button = MouseButton::other;
    bool control = false;  // the control key was down
    bool shift = false;    // a shift key was down
    bool desktop = false;  // Alt or Super was down: a shortcut of the desktop
    int code = 0;          // of a key: GLFW's number for it, that of its letter where it has one
    char letter = '\0';    // of a key: the shortcut letter it stands for, a to z
    char32_t typed = 0;    // of a character
    double time = 0.0;     // s
    double waited = 0.0;   // s; as long it may have waited before that, while a frame was drawn
    glm::vec2 at{0.0f};    // the mouse, in window units from the upper left corner
    float amount = 0.0f;   // notches of the wheel, away from the hand is positive
    std::string file{};    // what was dropped
};

/// Events as they come, each with the place of the mouse at that moment: asked later, the window system would tell
/// where the mouse is by then.
struct InputQueue {
    std::vector<InputEvent> events;
    glm::vec2 mouse{-1.0f};
    double emptied = 0.0, asked = 0.0;  // s, when it was for the last time, and when it is filled now
};

}  // namespace drapeau
