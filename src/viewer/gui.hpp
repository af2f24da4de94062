// Gui: Dear ImGui's context, its font and its calm looks.
#pragma once

#include "input.hpp"
#include "key_feed.hpp"

#include <glm/vec2.hpp>

#include <vector>

struct GLFWwindow;

namespace drapeau {

/// What a frame is drawn into, where that is not the window itself.
struct GuiFrame {
    glm::vec2 size{0.0f};  // window units
    float pixels_per_unit = 1.0f;
    float seconds = 0.0f;  // since the last frame; 0: by the clock
};

class Gui {
public:
    /// `scale`: how much larger than usual text should be; `pixels_per_unit`: how finely glyphs are made.
    Gui(GLFWwindow* window, float scale, float pixels_per_unit);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    /// `events`: what happened to the window since the last frame. `keeps_keys`: for a later frame.
    void begin(const GuiFrame& frame, const std::vector<InputEvent>& events, bool keeps_keys = false);
    bool is_text_edited() const;                                   // a field has the keyboard
    bool dropped_keys() { return keys_.dropped(); }                // see KeyFeed
    bool close_list();                                             // one that is open: whether there was one
    bool has_waiting_keys() const { return keys_.has_waiting(); }  // for the next frame
    void end();                                                    // no more is added to this frame
    void draw();                                                   // into the framebuffer that is bound

private:
    GLFWwindow* window_;
    bool entered_ = false;  // ImGui was told that the mouse is over the window
    KeyFeed keys_;
};

}  // namespace drapeau
