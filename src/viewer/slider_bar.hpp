// SliderBar: a bar with a handle, its number beside it, and the field in the place of both where the number is typed.
//
// A click on the bar moves the handle at once and sets the value a little later, for it may be the first of two: a
// double click types the number and leaves the value as it was. A drag sets at once.
#pragma once

#include "slider_scale.hpp"

#include <glm/vec2.hpp>

#include <optional>
#include <string>

namespace drapeau {

struct BarMemory {
    struct Click {
        unsigned bar = 0;  // ImGui's number of the bar that was pressed; 0: none waits
        double value = 0.0;
        double begun = 0.0;      // s
        float pressed_x = 0.0f;  // window units
        float grip = 0.0f;       // how far from the handle's middle it was taken
        bool on_handle = false;
        bool live = false;  // a drag: the value follows
    };
    struct Typing {
        unsigned bar = 0;     // whose number is typed, or will be once the mouse is let go; 0: none
        bool open = false;    // the field stands in its place
        bool active = false;  // and has the keyboard
        int frames = 0;       // since it is open and not active
        std::string text, first_text;
        bool seen = false;     // in this frame
        bool goes_on = false;  // with the next bar: Tab was pressed
        unsigned before = 0;   // the bar that is drawn before this one; 0: none
        unsigned goes_to = 0;  // that one: Shift and Tab were pressed
    };
    /// What was typed and is not the value now.
    struct NotTaken {
        std::string text;
        std::optional<double> number;  // more or less than is allowed; none: no number, or in another unit
    };
    Click click;
    Typing typing;
    unsigned drawn = 0;  // the last one in this frame
    std::optional<NotTaken> not_taken;
    std::optional<glm::vec2> pressed_twice;  // where, in this frame

    /// Whether keys belong to a field that does not have the keyboard yet.
    bool awaits_keyboard() const { return typing.bar && !typing.active; }
};

/// What a bar that is not drawn any more was waited for is forgotten.
void begin_bars(BarMemory& memory);

/// Whether the number of the bar `id`, which takes `size` from the cursor on, is to be typed: after a double click
/// there.
bool is_typed(unsigned id, glm::vec2 size, double value, BarMemory& memory);
/// The same for whatever else asks for it.
void type_number(unsigned id, double value, BarMemory& memory);

// Each draws from the cursor on and gives whether the value was changed, or the number clicked.

/// The bar alone. `waits`: the seconds until a click sets what it shows; 0 where none does.
bool drag_bar(unsigned id, double& value, const SliderScale& scale, float width, BarMemory& memory, double& waits);
bool draw_number(const std::string& text, float width);
/// The number is taken once it is whole: at Enter, Tab, or a click elsewhere; Escape leaves the value as it was.
bool edit_number(double& value, const SliderScale& scale, float width, BarMemory& memory);

}  // namespace drapeau
