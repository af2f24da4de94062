#include "actions.hpp"

#include <algorithm>
#include <cmath>

namespace drapeau {

namespace {

constexpr float arrow_pixels = 20.0f;  // an arrow key turns as far as this drag

constexpr double marks_of_pole = 20.0;  // a key hauls the flag from one to the next

/// Hauls the flag along its pole, from where its halyard is to the next mark.
void hoist(AppState& app, double marks) {
    auto& halyard = app.scene.flag.halyard;
    const bool at_the_top = !halyard && marks > 0.0;
    if (at_the_top || app.scene.flag.attach == Attach::none) return;
    halyard = std::clamp(std::round(halyard.value_or(1.0) * marks_of_pole + marks) / marks_of_pole, 0.0, 1.0);
}

void toggle(bool& value) {
    value = !value;
}

std::vector<Action> all_actions() {
    return {
        {"the first view",
         "Home",
         {{.key = Key::home}},
         [](AppState& app, Camera&) { app.commands.reset_camera = true; }},
        {"turn left",
         "Arrows",
         {{.key = Key::left}},
         [](AppState&, Camera& camera) {
             camera.turn({-arrow_pixels, 0.0f});
         },
         "turn"},
        {"turn right",
         "Arrows",
         {{.key = Key::right}},
         [](AppState&, Camera& camera) {
             camera.turn({arrow_pixels, 0.0f});
         }},
        {"turn up",
         "Arrows",
         {{.key = Key::up}},
         [](AppState&, Camera& camera) {
             camera.turn({0.0f, -arrow_pixels});
         }},
        {"turn down",
         "Arrows",
         {{.key = Key::down}},
         [](AppState&, Camera& camera) {
             camera.turn({0.0f, arrow_pixels});
         }},
        {"closer",
         "+ and -",
         {{.key = Key::keypad_add}, {.typed = U'+'}, {.typed = U'='}},
         [](AppState&, Camera& camera) { camera.closer(1.0f); },
         "closer, further"},
        {"further",
         "+ and -",
         {{.key = Key::keypad_subtract}, {.typed = U'-'}},
         [](AppState&, Camera& camera) { camera.closer(-1.0f); }},
        {"slow turn around the flag", "A", {{.letter = 'a'}}, [](AppState& app, Camera&) { toggle(app.orbits); }},
        {"pause, go on", "Space", {{.key = Key::space}}, [](AppState& app, Camera&) { toggle(app.paused); }},
        {"one step of the method",
         ".",
         {{.key = Key::keypad_decimal}, {.typed = U'.'}},
         [](AppState& app, Camera&) { app.commands.step = true; }},
        {"a frame back",
         ", and N",
         {{.typed = U','}},
         [](AppState& app, Camera&) { --app.commands.travel.frames; },
         "a frame back, a frame on"},
        {"a frame on", ", and N", {{.letter = 'n'}}, [](AppState& app, Camera&) { ++app.commands.travel.frames; }},
        {"a second back",
         "Page Up, Page Down",
         {{.key = Key::page_up}},
         [](AppState& app, Camera&) { --app.commands.travel.seconds; },
         "a second back, a second on"},
        {"a second on",
         "Page Up, Page Down",
         {{.key = Key::page_down}},
         [](AppState& app, Camera&) { ++app.commands.travel.seconds; }},
        {"play backwards",
         "Backspace",
         {{.key = Key::backspace}},
         [](AppState& app, Camera&) { app.commands.travel.backwards = true; }},
        {"slower",
         "[ and ]",
         {{.key = Key::keypad_divide}, {.typed = U'['}},
         [](AppState& app, Camera&) { app.playback.faster(-1); },
         "slower, faster; keypad / and *"},
        {"faster",
         "[ and ]",
         {{.key = Key::keypad_multiply}, {.typed = U']'}},
         [](AppState& app, Camera&) { app.playback.faster(1); }},
        {"real time", "1", {{.typed = U'1'}}, [](AppState& app, Camera&) { app.playback.rung = real_time; }},
        {"restart", "R", {{.letter = 'r'}}, [](AppState& app, Camera&) { app.commands.restart = true; }},
        {"undo the last setting",
         "Ctrl Z",
         {{.letter = 'z', .control = true}},
         [](AppState& app, Camera&) { app.commands.undo = true; }},
        {"redo it",
         "Ctrl Shift Z, Ctrl Y",
         {{.letter = 'z', .control = true, .shift = true}, {.letter = 'y', .control = true}},
         [](AppState& app, Camera&) { app.commands.redo = true; }},
        {"texture", "T", {{.letter = 't'}}, [](AppState& app, Camera&) { toggle(app.scene.view.texture); }},
        {"springs", "S", {{.letter = 's'}}, [](AppState& app, Camera&) { toggle(app.scene.view.springs); }},
        {"diagonal springs", "D", {{.letter = 'd'}}, [](AppState& app, Camera&) { toggle_diagonals(app); }},
        {"force colours", "F", {{.letter = 'f'}}, [](AppState& app, Camera&) { toggle(app.scene.view.forces); }},
        {"stretch colours", "E", {{.letter = 'e'}}, [](AppState& app, Camera&) { toggle(app.scene.view.stretch); }},
        {"velocities", "V", {{.letter = 'v'}}, [](AppState& app, Camera&) { toggle(app.scene.view.velocities); }},
        {"masses", "M", {{.letter = 'm'}}, [](AppState& app, Camera&) { toggle(app.scene.view.masses); }},
        {"cloth", "C", {{.letter = 'c'}}, [](AppState& app, Camera&) { toggle(app.scene.view.cloth); }},
        {"wind", "W", {{.letter = 'w'}}, [](AppState& app, Camera&) { toggle(app.scene.view.wind); }},
        {"raise the flag",
         "U and L",
         {{.letter = 'u'}},
         [](AppState& app, Camera&) { hoist(app, 1.0); },
         "raise, lower the flag"},
        {"lower the flag", "U and L", {{.letter = 'l'}}, [](AppState& app, Camera&) { hoist(app, -1.0); }},
        {"reference ghost", "G", {{.letter = 'g'}}, [](AppState& app, Camera&) { toggle(app.scene.view.reference); }},
        {"hide, show the panel", "H", {{.letter = 'h'}}, [](AppState& app, Camera&) { app.toggle_panel(); }},
        {"scenes to open", "O", {{.letter = 'o'}}, [](AppState& app, Camera&) { toggle(app.scenes_shown); }},
        {"find an action, a setting, a scene or a flag",
         "Ctrl P",
         {{.letter = 'p', .control = true}},
         [](AppState& app, Camera&) { app.palette = {.open = true}; }},
        {"copy the scene as text",
         "Ctrl C",
         {{.letter = 'c', .control = true}},
         [](AppState& app, Camera&) { app.commands.copy_scene = true; }},
        {"paste a scene",
         "Ctrl V",
         {{.letter = 'v', .control = true}},
         [](AppState& app, Camera&) { app.commands.paste_scene = true; }},
        {"screenshot", "P", {{.letter = 'p'}}, [](AppState& app, Camera&) { app.commands.screenshot = true; }},
        {"make a film",
         "Ctrl R",
         {{.letter = 'r', .control = true}},
         [](AppState& app, Camera&) { toggle(app.film.open); }},
        {"list of keys", "F1", {{.key = Key::f1}}, [](AppState& app, Camera&) { toggle(app.help_shown); }},
        {"close what is open, or cancel",
         "Esc",
         {{.key = Key::escape}},
         [](AppState& app, Camera&) { close_one(app); }},
        {"agree to what is asked", "Enter", {{.key = Key::enter}}, [](AppState& app, Camera&) { agree(app); }},
        {"quit",
         "Ctrl Q",
         {{.letter = 'q', .control = true}, {.letter = 'w', .control = true}},
         [](AppState& app, Camera&) { ask_to_quit(app); }},
        {"set everything back to the scene's values", "", {}, [](AppState& app, Camera&) { app.scene = app.origin; }},
        {"reset what the window remembers to defaults", "", {}, [](AppState& app, Camera&) { ask_to_forget(app); }},
    };
}

template <class Fits>
const Action* first_with(const Fits& fits) {
    for (const Action& action : actions())
        if (std::any_of(action.presses.begin(), action.presses.end(), fits)) return &action;
    return nullptr;
}

}  // namespace

std::span<const Action> actions() {
    static const std::vector<Action> all = all_actions();
    return all;
}

const Action* action_of(const InputEvent& event, char32_t typed) {
    if (event.key != Key::other) return first_with([&](const Press& press) { return press.key == event.key; });
    if (!event.control) {
        if (event.desktop) return nullptr;
        if (const Action* action = action_of(typed)) return action;
    }
    if (!event.letter) return nullptr;
    return first_with([&](const Press& press) {
        return press.letter == event.letter && press.control == event.control &&
               (!event.control || press.shift == event.shift);
    });
}

const Action* action_of(char32_t typed) {
    if (!typed) return nullptr;
    return first_with([&](const Press& press) { return press.typed == typed; });
}

}  // namespace drapeau
