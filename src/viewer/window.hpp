// Window: the GLFW window with its OpenGL context, and the queue of what happened to it since the last frame.
// Events are queued as they come, so that a key that goes down and up within a frame still counts.
#pragma once

#include "input.hpp"

#include <glm/vec2.hpp>

#include <vector>

struct GLFWwindow;

namespace drapeau {

struct WindowSettings {
    bool debug = false;  // an OpenGL debug context
    bool vsync = true;
};

class Window {
public:
    /// Throws InputError without a display or with an OpenGL older than 3.3.
    explicit Window(const WindowSettings& settings);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Until then the window is hidden and small: one of a size that cannot be drawn would take long to be made.
    /// `grows`: with the desktop's text, as far as there is room.
    void show(int width, int height, bool grows);

    bool open() const;  // nobody has asked to close it
    void stay_open();
    /// What happened since the last call, in order; waits so many seconds for something to happen.
    std::vector<InputEvent> poll(double wait = 0.0);
    void swap();
    void set_title(const std::string& title);

    // As they were at the last poll: to ask the window system again takes longer than the rest of a frame.
    glm::ivec2 size() const { return size_; }                          // window units
    glm::ivec2 framebuffer_size() const { return framebuffer_size_; }  // pixels
    bool hidden() const;                                               // minimised, or not shown by the window manager
    float content_scale() const;  // how much larger than usual the desktop wants text
    GLFWwindow* handle() const { return window_; }

private:
    void measure();

    GLFWwindow* window_ = nullptr;
    InputQueue queue_;
    glm::ivec2 size_{0}, framebuffer_size_{0};
};

}  // namespace drapeau
