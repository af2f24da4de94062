// What happened to the window since the last frame, in order.
#pragma once

#include <glm/vec2.hpp>

#include <string>
#include <vector>

namespace drapeau {

/// Keys that do something whatever the keyboard's language; of others only what they type counts.
enum class Key { other, space, escape, enter, f1, home, left, right, up, down, keypad_add, keypad_subtract };
enum class MouseButton { left, right, middle, other };

struct InputEvent {
    enum class Kind { key, press, release, move, scroll, drop };
    Kind kind = Kind::key;
    Key key = Key::other;
    MouseButton button = MouseButton::other;
    bool control = false;     // the control key was down
    int code = 0;             // of a key: GLFW's number for it, as ImGui wants it
    double time = 0.0;        // s
    glm::vec2 at{0.0f};       // the mouse, in window units from the upper left corner
    float amount = 0.0f;      // notches of the wheel, away from the hand is positive
    std::string character{};  // of a key: what it types on this keyboard, lower case
    std::string file{};       // what was dropped
};

/// Events as they come, each with the place of the mouse at that moment: asked later, the window system would tell
/// where the mouse is by then.
struct InputQueue {
    std::vector<InputEvent> events;
    glm::vec2 mouse{-1.0f};
};

}  // namespace drapeau
