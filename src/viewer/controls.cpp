#include "controls.hpp"

#include "given_path.hpp"

#include <glm/geometric.hpp>

#include <algorithm>

namespace drapeau {

namespace {

constexpr double double_click_seconds = 0.4;
constexpr float double_click_pixels = 6.0f;
constexpr float arrow_pixels = 20.0f;  // an arrow key turns as far as this drag

void load_dropped(const std::string& file, Session& session) {
    if (ending_of(meant_path(file)) == ".toml")
        session.wishes.load_scene = file;
    else
        session.wishes.load_texture = file;
}

void toggle(bool& value) {
    value = !value;
}

}  // namespace

void Controls::apply(const std::vector<InputEvent>& events, const Claims& claims, const Framing& framing,
                     Session& session, Camera& camera) {
    using Kind = InputEvent::Kind;
    for (const InputEvent& event : events) {
        const bool on_panel = std::any_of(session.claimed.begin(), session.claimed.end(),
                                          [&](const Area& area) { return area.contains(event.at); });
        const bool claimed = claims.mouse || on_panel;
        switch (event.kind) {
            case Kind::press:
                press(event, claimed, session);
                break;
            case Kind::release:
                drag_ = Drag::none;
                break;
            case Kind::move:
                if (drag_ == Drag::turn) camera.turn(event.at - last_);
                if (drag_ == Drag::slide) camera.slide(event.at - last_, framing, session.view_area);
                last_ = event.at;
                break;
            case Kind::scroll:
                if (!claimed) camera.closer(event.amount);
                break;
            case Kind::drop:
                load_dropped(event.file, session);
                break;
            case Kind::key:
                if (!claims.keyboard) key(event, session, camera);
                break;
        }
    }
}

void Controls::press(const InputEvent& event, bool claimed, Session& session) {
    drag_ = Drag::none;
    if (claimed) return;
    last_ = event.at;
    if (event.button == MouseButton::right || event.button == MouseButton::middle) drag_ = Drag::slide;
    if (event.button != MouseButton::left) return;
    drag_ = Drag::turn;
    const bool twice =
        event.time - pressed_time_ < double_click_seconds && glm::length(event.at - pressed_at_) < double_click_pixels;
    if (twice) session.wishes.reset_camera = true;
    pressed_time_ = twice ? -1e6 : event.time;
    pressed_at_ = event.at;
}

void Controls::key(const InputEvent& event, Session& session, Camera& camera) {
    ViewSettings& view = session.scene.view;
    switch (event.key) {
        case Key::space:
            toggle(session.paused);
            return;
        case Key::f1:
            toggle(session.help_shown);
            return;
        case Key::home:
            session.wishes.reset_camera = true;
            return;
        case Key::left:
            camera.turn({-arrow_pixels, 0.0f});
            return;
        case Key::right:
            camera.turn({arrow_pixels, 0.0f});
            return;
        case Key::up:
            camera.turn({0.0f, -arrow_pixels});
            return;
        case Key::down:
            camera.turn({0.0f, arrow_pixels});
            return;
        case Key::keypad_add:
            camera.closer(1.0f);
            return;
        case Key::keypad_subtract:
            camera.closer(-1.0f);
            return;
        case Key::escape:
            close_one(session);
            return;
        case Key::enter:
            agree(session);
            return;
        case Key::other:
            break;
    }
    const char letter = event.character.size() == 1 ? event.character[0] : '\0';
    if (event.control) {
        if (letter == 'q' || letter == 'w') quit_ = true;
        return;
    }
    switch (letter) {
        case '.':
            session.wishes.step = true;
            break;
        case 'r':
            session.wishes.restart = true;
            break;
        case 't':
            toggle(view.texture);
            break;
        case 's':
            toggle(view.springs);
            break;
        case 'f':
            toggle(view.forces);
            break;
        case 'm':
            toggle(view.masses);
            break;
        case 'c':
            toggle(view.cloth);
            break;
        case 'd':
            toggle_diagonals(session);
            break;
        case 'h':
            toggle(session.panel_shown);
            break;
        case 'p':
            session.wishes.screenshot = true;
            break;
        case '+':
        case '=':
            camera.closer(1.0f);
            break;
        case '-':
            camera.closer(-1.0f);
            break;
        default:
            break;
    }
}

}  // namespace drapeau
