#include "controls.hpp"

#include "io/given_path.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace drapeau {

namespace {

constexpr double double_click_seconds = 0.4;
constexpr float double_click_pixels = 6.0f;
constexpr float click_pixels = 4.0f;    // a hand that clicks moves by less
constexpr double marks_of_pole = 20.0;  // a key hauls the flag from one to the next
constexpr float arrow_pixels = 20.0f;   // an arrow key turns as far as this drag

void load_dropped(const std::string& file, AppState& app) {
    if (ending_of(meant_path(file)) == ".toml")
        app.commands.load_scene = file;
    else
        app.commands.load_texture = file;
}

void toggle(bool& value) {
    value = !value;
}

/// Hauls the flag along its pole, from where its halyard is to the next mark.
void hoist(AppState& app, double marks) {
    auto& halyard = app.scene.flag.halyard;
    const bool at_the_top = !halyard && marks > 0.0;
    if (at_the_top || app.scene.flag.attach == Attach::none) return;
    halyard = std::clamp(std::round(halyard.value_or(1.0) * marks_of_pole + marks) / marks_of_pole, 0.0, 1.0);
}

/// Whether the key does something whatever it types.
bool named_key(Key key, AppState& app, Camera& camera) {
    switch (key) {
        case Key::space:
            toggle(app.paused);
            return true;
        case Key::f1:
            toggle(app.help_shown);
            return true;
        case Key::home:
            app.commands.reset_camera = true;
            return true;
        case Key::left:
            camera.turn({-arrow_pixels, 0.0f});
            return true;
        case Key::right:
            camera.turn({arrow_pixels, 0.0f});
            return true;
        case Key::up:
            camera.turn({0.0f, -arrow_pixels});
            return true;
        case Key::down:
            camera.turn({0.0f, arrow_pixels});
            return true;
        case Key::page_up:
            hoist(app, 1.0);
            return true;
        case Key::page_down:
            hoist(app, -1.0);
            return true;
        case Key::keypad_add:
            camera.closer(1.0f);
            return true;
        case Key::keypad_subtract:
            camera.closer(-1.0f);
            return true;
        case Key::keypad_decimal:
            app.commands.step = true;
            return true;
        case Key::escape:
            close_one(app);
            return true;
        case Key::enter:
            agree(app);
            return true;
        case Key::other:
            break;
    }
    return false;
}

/// Whether the character does something, whichever key types it.
bool symbol(char32_t typed, AppState& app, Camera& camera) {
    switch (typed) {
        case U'.':
            app.commands.step = true;
            return true;
        case U'+':
        case U'=':
            camera.closer(1.0f);
            return true;
        case U'-':
            camera.closer(-1.0f);
            return true;
        default:
            return false;
    }
}

void letter_key(char letter, AppState& app) {
    ViewSettings& view = app.scene.view;
    switch (letter) {
        case 'r':
            app.commands.restart = true;
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
        case 'g':
            toggle(view.reference);
            break;
        case 'c':
            toggle(view.cloth);
            break;
        case 'd':
            toggle_diagonals(app);
            break;
        case 'o':
            toggle(app.orbits);
            break;
        case 'w':
            toggle(view.wind);
            break;
        case 'h':
            app.toggle_panel();
            break;
        case 'p':
            app.commands.screenshot = true;
            break;
        default:
            break;
    }
}

}  // namespace

void Controls::apply(const std::vector<InputEvent>& events, const Claims& claims, const Framing& framing, AppState& app,
                     Camera& camera) {
    using Kind = InputEvent::Kind;
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
                if (!claims.keyboard) key(event, types ? events[i].typed : 0, app, camera);
                break;
            }
            case Kind::character:
                if (!claims.keyboard) symbol(event.typed, app, camera);
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
    if (claimed) return;
    last_ = event.at;
    still_ = false;
    if (event.button == MouseButton::left && event.shift) {
        drag_ = Drag::pull;
        return app.hand.take_hold(event.at);
    }
    if (event.button == MouseButton::right || event.button == MouseButton::middle) drag_ = Drag::slide;
    if (event.button != MouseButton::left) return;
    drag_ = Drag::turn;
    const bool twice =
        event.time - pressed_time_ < double_click_seconds && glm::length(event.at - pressed_at_) < double_click_pixels;
    if (twice) app.commands.reset_camera = true;
    pressed_time_ = twice ? -1e6 : event.time;
    pressed_at_ = event.at;
    still_ = !twice;
}

// The window system releases what is down where the window loses the keyboard, and tells of a release beside it.
void Controls::release(const InputEvent& event, AppState& app) {
    if (drag_ == Drag::pull) app.hand.let_go();
    if (drag_ == Drag::turn && still_) app.hand.click(event.at);
    drag_ = Drag::none;
}

// One press does one thing: what the key is, else what it types, else its letter.
void Controls::key(const InputEvent& event, char32_t typed, AppState& app, Camera& camera) {
    if (named_key(event.key, app, camera)) return;
    if (event.control) {
        if (event.letter == 'q' || event.letter == 'w') quit_ = true;
        return;
    }
    if (event.desktop || symbol(typed, app, camera)) return;
    letter_key(event.letter, app);
}

}  // namespace drapeau
