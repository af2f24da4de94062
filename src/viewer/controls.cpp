#include "controls.hpp"

#include "actions.hpp"

#include "io/given_path.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

namespace drapeau {

namespace {

constexpr double double_click_seconds = 0.4;
constexpr float double_click_pixels = 6.0f;
constexpr float click_pixels = 4.0f;  // a hand that clicks moves by less

void load_dropped(const std::string& file, AppState& app) {
    if (ending_of(meant_path(file)) == ".toml")
        app.commands.load_scene = file;
    else
        app.commands.load_texture = file;
}

}  // namespace

void Controls::apply(const std::vector<InputEvent>& events, const Claims& claims, const Framing& framing, AppState& app,
                     Camera& camera) {
    using Kind = InputEvent::Kind;
    carry_out(std::exchange(app.palette.wanted, nullptr), app, camera);
    for (std::size_t i = 0; i < events.size(); ++i) {
        const InputEvent& event = events[i];
        const bool on_panel = std::any_of(app.claimed.begin(), app.claimed.end(),
                                          [&](const Area& area) { return area.contains(event.at); });
        const bool claimed = claims.mouse || on_panel;
        switch (event.kind) {
            case Kind::press:
                press(event, claimed, app);
                break;
            case Kind::release:
                release(event, app);
                break;
            case Kind::move:
                if (glm::length(event.at - pressed_at_) > click_pixels) still_ = false;
                app.hand.move_to(event.at);
                if (drag_ == Drag::turn) camera.turn(event.at - last_);
                if (drag_ == Drag::slide) camera.slide(event.at - last_, framing, app.view_area);
                last_ = event.at;
                break;
            case Kind::scroll:
                if (!claimed) camera.closer(event.amount, event.at, framing, app.view_area);
                break;
            case Kind::drop:
                load_dropped(event.file, app);
                break;
            case Kind::key: {
                const bool types = i + 1 < events.size() && events[i + 1].kind == Kind::character;
                if (types) ++i;  // part of this press
                if (!claims.keyboard) carry_out(action_of(event, types ? events[i].typed : 0), app, camera);
                break;
            }
            case Kind::character:
                if (!claims.keyboard) carry_out(action_of(event.typed), app, camera);
                break;
            case Kind::key_up:
            case Kind::window:
                break;
        }
    }
}

void Controls::press(const InputEvent& event, bool claimed, AppState& app) {
    if (drag_ == Drag::pull) app.hand.let_go();
    drag_ = Drag::none;
    // What the first press of two opened may lie under the second.
    const bool left = event.button == MouseButton::left && !event.shift;
    const bool twice = left && event.time - event.waited - pressed_time_ < double_click_seconds &&
                       glm::length(event.at - pressed_at_) < double_click_pixels;
    if (twice) app.commands.reset_camera = true;
    if (twice) pressed_time_ = -1e6;
    if (claimed) return;
    last_ = event.at;
    still_ = false;
    if (event.button == MouseButton::left && event.shift) {
        drag_ = Drag::pull;
        return app.hand.take_hold(event.at);
    }
    if (event.button == MouseButton::right || event.button == MouseButton::middle) drag_ = Drag::slide;
    if (!left) return;
    drag_ = Drag::turn;
    if (!twice) pressed_time_ = event.time;
    pressed_at_ = event.at;
    still_ = !twice;
}

// The window system releases what is down where the window loses the keyboard, and tells of a release beside it.
void Controls::release(const InputEvent& event, AppState& app) {
    if (drag_ == Drag::pull) app.hand.let_go();
    if (drag_ == Drag::turn && still_) app.hand.click(event.at);
    drag_ = Drag::none;
}

// While the palette is open all keys are its own, before its text takes them too.
void Controls::carry_out(const Action* action, AppState& app, Camera& camera) {
    if (!action || (app.palette.open && action->key != "Esc")) return;
    action->run(app, camera);
    quit_ = quit_ || app.quits;
}

}  // namespace drapeau
