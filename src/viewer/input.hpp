// What happened to the window since the last frame, in order.
#pragma once

#include <glm/vec2.hpp>

#include <string>
#include <vector>

namespace drapeau {

struct InputEvent {
    enum class Kind { key, press, release, move, scroll, drop };
    Kind kind = Kind::key;
    int code = 0;           // GLFW key or mouse button
    int modifiers = 0;      // GLFW modifier bits
    double time = 0.0;      // s
    glm::vec2 at{0.0f};     // the mouse, in window units from the upper left corner
    float amount = 0.0f;    // notches of the wheel, away from the hand is positive
    std::string character;  // of a key: what it types on this keyboard, lower case
    std::string file;       // what was dropped
};

/// Events as they come, each with the place of the mouse at that moment: asked later, the window system would tell
/// where the mouse is by then.
struct InputQueue {
    std::vector<InputEvent> events;
    glm::vec2 mouse{-1.0f};
};

}  // namespace drapeau
