// Screen: an X server of the test's own (Xvfb), so that tests need no display and disturb none.
#pragma once

#include "process.hpp"

#include "image/image.hpp"

#include <memory>
#include <string>
#include <vector>

namespace drapeau::window_tests {

class Screen {
public:
    /// Starts the server on whatever display number is free.
    /// What the server does when its last client leaves: it stays as it is, or starts anew as most do.
    enum class Alone { stays, starts_anew };
    explicit Screen(Alone alone = Alone::stays);

    /// The environment of programs that are to appear on it.
    const Surroundings& surroundings() const { return surroundings_; }

    /// What is on the screen now, without the mouse pointer.
    Image picture() const;

    /// The keyboard's layout from now on, as setxkbmap names it.
    void use_layout(const std::string& name) const;
    /// How many dots an inch programs started from now on take the screen to have.
    void use_dpi(int dpi) const;
    /// What a window manager leaves behind that is killed: the root window names a window that is gone.
    void leave_dead_window_manager() const;

    /// Runs xdotool, which sends real mouse and key events; gives back what it prints.
    std::string xdotool(std::vector<std::string> arguments) const;

    static constexpr int width = 1280;
    static constexpr int height = 1024;

private:
    TemporaryFolder folder_;
    std::unique_ptr<Process> server_;
    Surroundings surroundings_;
    std::string display_;
};

}  // namespace drapeau::window_tests
