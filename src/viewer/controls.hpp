// Controls: what mouse and keys do to the camera and the app. A drag that begins on a panel stays with the panel.
#pragma once

#include "app_state.hpp"
#include "camera.hpp"
#include "input.hpp"

#include <vector>

namespace drapeau {

struct Action;

struct Claims {
    bool mouse = false;     // the interface uses the mouse now
    bool keyboard = false;  // a text is being typed
};

class Controls {
public:
    void apply(const std::vector<InputEvent>& events, const Claims& claims, const Framing& framing, AppState& app,
               Camera& camera);

private:
    enum class Drag { none, turn, slide, pull };

    void press(const InputEvent& event, bool claimed, AppState& app);
    void begin_drag(const InputEvent& event, AppState& app);
    bool is_second_of_two(const InputEvent& event) const;
    void carry_out(const Action* action, AppState& app, Camera& camera);
    void release(const InputEvent& event, AppState& app);

    Drag drag_ = Drag::none;
    glm::vec2 last_{0.0f};  // the mouse, at the last event of the drag
    // The last press that began to turn the flag.
    glm::vec2 pressed_at_{-1e6f};
    double pressed_time_ = -1e6;  // s
    bool still_ = false;          // the mouse has not moved since then
};

}  // namespace drapeau
