#include "controls.hpp"

#include "io/given_path.hpp"

#include <glm/geometric.hpp>

#include <algorithm>

namespace drapeau {

namespace {

constexpr double double_click_seconds = 0.4;
constexpr float double_click_pixels = 6.0f;
constexpr float arrow_pixels = 20.0f;  // an arrow key turns as far as this drag

void load_dropped(const std::string& file, AppState& app) {
    if (ending_of(meant_path(file)) == ".toml")
        app.commands.load_scene = file;
    else
        app.commands.load_texture = file;
}

void toggle(bool& value) {
    value = !value;
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
                drag_ = Drag::none;
                break;
            case Kind::move:
                if (drag_ == Drag::turn) camera.turn(event.at - last_);
                if (drag_ == Drag::slide) camera.slide(event.at - last_, framing, app.view_area);
                last_ = event.at;
                break;
            case Kind::scroll:
                if (!claimed) camera.closer(event.amount);
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
    drag_ = Drag::none;
    if (claimed) return;
    last_ = event.at;
    if (event.button == MouseButton::right || event.button == MouseButton::middle) drag_ = Drag::slide;
    if (event.button != MouseButton::left) return;
    drag_ = Drag::turn;
    const bool twice =
        event.time - pressed_time_ < double_click_seconds && glm::length(event.at - pressed_at_) < double_click_pixels;
    if (twice) app.commands.reset_camera = true;
    pressed_time_ = twice ? -1e6 : event.time;
    pressed_at_ = event.at;
}

// One press does one thing: what the key is, else what it types, else its letter.
void Controls::key(const InputEvent& event, char32_t typed, AppState& app, Camera& camera) {
    if (named_key(event.key, app, camera)) return;
    if (event.control) {
        if (event.letter == 'q' || event.letter == 'w') quit_ = true;
        if (event.letter == 'r') toggle(app.film.open);
        return;
    }
    if (event.desktop || symbol(typed, app, camera)) return;
    letter_key(event.letter, app);
}

}  // namespace drapeau
