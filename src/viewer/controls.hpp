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

    bool wants_to_quit() const { return quit_; }

private:
    enum class Drag { none, turn, slide, pull };

    void press(const InputEvent& event, bool claimed, AppState& app);
    void carry_out(const Action* action, AppState& app, Camera& camera);
    void release(const InputEvent& event, AppState& app);

    Drag drag_ = Drag::none;
    glm::vec2 last_{0.0f};  // the mouse, at the last event of the drag
    glm::vec2 pressed_at_{-1e6f};
    bool still_ = false;          // the mouse has not moved since then
    double pressed_time_ = -1e6;  // s
    bool quit_ = false;
};

}  // namespace drapeau
