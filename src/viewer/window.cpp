#include "window.hpp"

#include "dead_window_manager.hpp"
#include "keyboard.hpp"

#include "io/error.hpp"

#include <GL/glew.h>
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace drapeau {

namespace {

using Kind = InputEvent::Kind;

constexpr int hidden_side = 64;  // pixels

Key key_of(int code) {
    switch (code) {
        case GLFW_KEY_SPACE:
            return Key::space;
        case GLFW_KEY_ESCAPE:
            return Key::escape;
        case GLFW_KEY_ENTER:
        case GLFW_KEY_KP_ENTER:
            return Key::enter;
        case GLFW_KEY_F1:
            return Key::f1;
        case GLFW_KEY_HOME:
            return Key::home;
        case GLFW_KEY_LEFT:
            return Key::left;
        case GLFW_KEY_RIGHT:
            return Key::right;
        case GLFW_KEY_UP:
            return Key::up;
        case GLFW_KEY_DOWN:
            return Key::down;
        case GLFW_KEY_KP_ADD:
            return Key::keypad_add;
        case GLFW_KEY_KP_SUBTRACT:
            return Key::keypad_subtract;
        case GLFW_KEY_KP_DECIMAL:
            return Key::keypad_decimal;
        case GLFW_KEY_KP_DIVIDE:
            return Key::keypad_divide;
        case GLFW_KEY_KP_MULTIPLY:
            return Key::keypad_multiply;
        case GLFW_KEY_PAGE_UP:
            return Key::page_up;
        case GLFW_KEY_PAGE_DOWN:
            return Key::page_down;
        case GLFW_KEY_BACKSPACE:
            return Key::backspace;
        default:
            return Key::other;
    }
}

MouseButton button_of(int code) {
    switch (code) {
        case GLFW_MOUSE_BUTTON_LEFT:
            return MouseButton::left;
        case GLFW_MOUSE_BUTTON_RIGHT:
            return MouseButton::right;
        case GLFW_MOUSE_BUTTON_MIDDLE:
            return MouseButton::middle;
        default:
            return MouseButton::other;
    }
}

constexpr double at_once = 0.005;  // s; what comes so soon after events are asked for had waited

InputEvent& queue(GLFWwindow* window, Kind kind) {
    auto& waiting = *static_cast<InputQueue*>(glfwGetWindowUserPointer(window));
    InputEvent& event = waiting.events.emplace_back();
    event.kind = kind;
    event.time = glfwGetTime();
    if (event.time - waiting.asked < at_once) event.waited = event.time - waiting.emptied;
    event.at = waiting.mouse;
    return event;
}

/// What each key that types something types unshifted on the present layout. GLFW numbers them by their US labels.
std::vector<std::string> layout_now() {
    std::vector<std::string> layout;
    for (const char us_label : std::string_view("`1234567890-=QWERTYUIOP[]\\ASDFGHJKL;'ZXCVBNM,./"))
        if (const char* types = glfwGetKeyName(us_label, 0)) layout.emplace_back(types);
    return layout;
}

bool is_us_letter(int code) {
    return code >= GLFW_KEY_A && code <= GLFW_KEY_Z;
}

char letter_of(int code, int scancode) {
    const char* types = glfwGetKeyName(code, scancode);
    const char us_letter = is_us_letter(code) ? char('a' + code - GLFW_KEY_A) : '\0';
    return shortcut_letter(types ? types : "", us_letter, layout_now());
}

void on_key(GLFWwindow* window, int code, int scancode, int action, int modifiers) {
    const Key key = key_of(code);
    const char letter = letter_of(code, scancode);
    const bool repeats = key == Key::left || key == Key::right || key == Key::up || key == Key::down ||
                         key == Key::page_up || key == Key::page_down || letter == 'n';
    if (action == GLFW_REPEAT && !repeats) return;
    InputEvent& event = queue(window, action == GLFW_RELEASE ? Kind::key_up : Kind::key);
    event.key = key;
    event.letter = letter;
    event.code = event.letter ? GLFW_KEY_A + event.letter - 'a' : is_us_letter(code) ? GLFW_KEY_UNKNOWN : code;
    event.control = modifiers & GLFW_MOD_CONTROL;
    event.shift = modifiers & GLFW_MOD_SHIFT;
    event.desktop = modifiers & (GLFW_MOD_ALT | GLFW_MOD_SUPER);
}

void on_character(GLFWwindow* window, unsigned character) {
    queue(window, Kind::character).typed = character;
}

void on_button(GLFWwindow* window, int button, int action, int modifiers) {
    InputEvent& event = queue(window, action == GLFW_PRESS ? Kind::press : Kind::release);
    event.button = button_of(button);
    event.shift = modifiers & GLFW_MOD_SHIFT;
    event.control = modifiers & GLFW_MOD_CONTROL;
}

void on_move(GLFWwindow* window, double x, double y) {
    static_cast<InputQueue*>(glfwGetWindowUserPointer(window))->mouse = {float(x), float(y)};
    queue(window, Kind::move);
}

void on_scroll(GLFWwindow* window, double, double notches) {
    queue(window, Kind::scroll).amount = float(notches);
}

void on_drop(GLFWwindow* window, int count, const char** files) {
    for (int i = 0; i < count; ++i) queue(window, Kind::drop).file = files[i];
}

void on_window(GLFWwindow* window) {
    queue(window, Kind::window);
}

/// What the desktop's own bars leave of the screen, in window units.
glm::ivec2 work_area() {
    glm::ivec2 size(0);
    if (GLFWmonitor* monitor = glfwGetPrimaryMonitor())
        glfwGetMonitorWorkarea(monitor, nullptr, nullptr, &size.x, &size.y);
    return size;
}

std::string last_error() {
    const char* description = nullptr;
    glfwGetError(&description);
    return description ? description : "no reason given";
}

}  // namespace

Window::Window(const WindowSettings& settings) {
#ifdef GLFW_PLATFORM_X11
    // GLEW as Debian builds it finds OpenGL through X11 only.
    if (glfwPlatformSupported(GLFW_PLATFORM_X11)) glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
    const auto until_there_is_another = forget_dead_window_manager();
    bool started = glfwInit();
#ifdef GLFW_PLATFORM_X11
    if (!started && std::getenv("WAYLAND_DISPLAY")) {  // without one, Wayland would only add a complaint of its own
        glfwInitHint(GLFW_PLATFORM, GLFW_ANY_PLATFORM);
        started = glfwInit();
    }
#endif
    if (!started)
        throw InputError("no display to open a window on (" + last_error() +
                         "); set DISPLAY, or use xvfb-run to draw into files");

    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, settings.debug);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);  // the scene is drawn into a target with a depth of its own
    window_ = glfwCreateWindow(hidden_side, hidden_side, "drapeau", nullptr, nullptr);
    if (!window_) {
        const std::string reason = last_error();
        glfwTerminate();
        throw InputError("OpenGL 3.3 is needed and this display does not offer it (" + reason + ")");
    }
    measure();
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(settings.vsync ? 1 : 0);

    // Without X11, GLEW finds the functions all the same and complains only of the missing GLX.
    glewExperimental = GL_TRUE;
    glewInit();
    if (!glGenVertexArrays || !glBlitFramebuffer || !glDrawArraysInstanced) {
        glfwDestroyWindow(window_);
        glfwTerminate();
        throw InputError("OpenGL 3.3 is needed; its functions could not be loaded");
    }

    glfwSetWindowUserPointer(window_, &queue_);
    glfwSetKeyCallback(window_, on_key);
    glfwSetCharCallback(window_, on_character);
    glfwSetMouseButtonCallback(window_, on_button);
    glfwSetCursorPosCallback(window_, on_move);
    glfwSetScrollCallback(window_, on_scroll);
    glfwSetDropCallback(window_, on_drop);
    glfwSetWindowRefreshCallback(window_, on_window);
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* window, int, int) { on_window(window); });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* window, int) { on_window(window); });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow* window, int) { on_window(window); });
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void Window::show(int width, int height, bool grows) {
    const glm::ivec2 room = work_area();
    const float scale = content_scale();
    const auto scaled = [&](int units, int most) {
        const int wanted = int(float(units) * scale);
        return most > 0 ? std::min(wanted, most) : wanted;
    };
    if (grows) {
        width = scaled(width, room.x);
        height = scaled(height, room.y);
    }
    glfwSetWindowSize(window_, width, height);
    glfwSetWindowSizeLimits(window_, scaled(480, room.x / 2), scaled(360, room.y / 2), GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwShowWindow(window_);
    measure();
}

bool Window::open() const {
    return !glfwWindowShouldClose(window_);
}
void Window::stay_open() {
    glfwSetWindowShouldClose(window_, GLFW_FALSE);
}

std::vector<InputEvent> Window::poll(double wait) {
    queue_.asked = glfwGetTime();
    if (wait > 0.0)
        glfwWaitEventsTimeout(wait);
    else
        glfwPollEvents();
    measure();
    queue_.emptied = glfwGetTime();
    return std::exchange(queue_.events, {});
}

void Window::swap() {
    glfwSwapBuffers(window_);
}
void Window::set_title(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}

void Window::measure() {
    glfwGetWindowSize(window_, &size_.x, &size_.y);
    glfwGetFramebufferSize(window_, &framebuffer_size_.x, &framebuffer_size_.y);
}

bool Window::hidden() const {
    return glfwGetWindowAttrib(window_, GLFW_ICONIFIED) || !glfwGetWindowAttrib(window_, GLFW_VISIBLE);
}

// Where the framebuffer is already larger than the window, the desktop's wish is met by that.
float Window::content_scale() const {
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(window_, &x, &y);
    const float pixels_per_unit = float(framebuffer_size().x) / float(std::max(1, size().x));
    return std::clamp(x / pixels_per_unit, 1.0f, 4.0f);
}

}  // namespace drapeau
