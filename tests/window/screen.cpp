#include "screen.hpp"

#include "image/image_file.hpp"

#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <stdexcept>
#include <thread>

namespace drapeau::window_tests {

Screen::Screen(Alone alone) {
    // The server writes its display number to its standard output once it answers.
    const std::string size = std::to_string(width) + "x" + std::to_string(height) + "x24";
    std::vector<std::string> server{"Xvfb", "-displayfd", "1", "-screen", "0", size, "-nolisten", "tcp"};
    if (alone == Alone::stays) server.push_back("-noreset");
    server_ = std::make_unique<Process>(server, Surroundings{}, folder_.path);
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (server_->output().find('\n') == std::string::npos) {
        if (!server_->running() || std::chrono::steady_clock::now() > deadline)
            throw std::runtime_error("Xvfb did not start: " + server_->errors());
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    display_ = ":" + server_->output().substr(0, server_->output().find('\n'));
    surroundings_.variables = {{"DISPLAY", display_},
                               {"WAYLAND_DISPLAY", std::nullopt},
                               {"XDG_SESSION_TYPE", "x11"},
                               {"XAUTHORITY", std::nullopt},
                               {"LIBGL_ALWAYS_SOFTWARE", "1"}};
}

Image Screen::picture() const {
    const std::string file = (folder_ / "picture.png").string();
    const Finished grab = run({"ffmpeg", "-nostdin", "-loglevel", "error", "-y", "-f", "x11grab", "-draw_mouse", "0",
                               "-video_size", std::to_string(width) + "x" + std::to_string(height), "-i", display_,
                               "-frames:v", "1", "-compression_level", "1", file},
                              surroundings_);
    if (grab.status != 0) throw std::runtime_error("could not take a picture of the screen: " + grab.errors);
    return load_image(file);
}

namespace {

void run_or_throw(const std::vector<std::string>& command, const Surroundings& surroundings) {
    const Finished done = run(command, surroundings);
    if (done.status != 0) throw std::runtime_error(command[0] + ": " + done.errors);
}

}  // namespace

void Screen::use_layout(const std::string& name) const {
    run_or_throw({"setxkbmap", name}, surroundings_);
}

void Screen::use_dpi(int dpi) const {
    run_or_throw({"xprop", "-root", "-f", "RESOURCE_MANAGER", "8s", "-set", "RESOURCE_MANAGER",
                  "Xft.dpi:\t" + std::to_string(dpi)},
                 surroundings_);
}

void Screen::leave_dead_window_manager() const {
    Display* display = XOpenDisplay(display_.c_str());
    if (!display) throw std::runtime_error("the screen does not answer");
    const ::Window gone = 0x1fffff;
    XChangeProperty(display, DefaultRootWindow(display), XInternAtom(display, "_NET_SUPPORTING_WM_CHECK", False),
                    XA_WINDOW, 32, PropModeReplace, reinterpret_cast<const unsigned char*>(&gone), 1);
    XCloseDisplay(display);
}

std::string Screen::xdotool(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "xdotool");
    const Finished done = run(arguments, surroundings_);
    if (done.status != 0) throw std::runtime_error("xdotool " + arguments[1] + ": " + done.errors);
    return done.output;
}

}  // namespace drapeau::window_tests
