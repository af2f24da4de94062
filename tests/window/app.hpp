// App: the real program in a real window, its controls found by their labels and worked by mouse and keys.
#pragma once

#include "process.hpp"
#include "screen.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace drapeau::window_tests {

struct Point {
    double x = 0.0, y = 0.0;
};

/// Pixels of the window, from the upper left corner.
struct Box {
    double x0 = 0.0, y0 = 0.0, x1 = 0.0, y1 = 0.0;

    double width() const { return x1 - x0; }
    double height() const { return y1 - y0; }
    /// The point at these shares of the width and the height.
    Point at(double across, double down) const { return {x0 + across * width(), y0 + down * height()}; }
    bool contains(Point p) const { return p.x >= x0 && p.x < x1 && p.y >= y0 && p.y < y1; }
};

struct Control {
    Box box;
    std::string value;
};

/// What the window says about itself in one frame; the format is told in src/viewer/ui_map.hpp.
struct Look {
    std::map<std::string, std::string> states;
    std::map<std::string, Control> controls;

    const std::string& text(const std::string& state) const;
    double number(const std::string& state) const;
    Box box(const std::string& state) const;
    bool has(const std::string& label) const { return controls.contains(label); }
};

enum class Button { left = 1, middle = 2, right = 3 };

class App {
public:
    /// Starts the program on `screen` and waits until it has drawn. `home`: where it finds what it remembers; null is a
    /// home of its own, without settings.
    App(const Screen& screen, const std::vector<std::string>& arguments, const TemporaryFolder* home = nullptr);
    ~App();

    /// The latest frame's records.
    Look look();
    /// Waits until a look satisfies `condition` and gives it back; throws, naming `what`, if that takes too long.
    Look wait_until(const std::string& what, const std::function<bool(const Look&)>& condition);
    /// Waits until whatever was done before has been seen and drawn, by a window at rest too.
    Look settle();

    void move_to(Point p);
    void click(Point p, Button button = Button::left);
    void double_click(Point p);
    void drag(Point from, Point to, Button button = Button::left);
    void wheel(Point p, int notches);  // positive: away from the hand
    /// A key that goes down and up at once, named as X names it: "space", "ctrl+s".
    void press(const std::string& key);
    /// A key held until the window has drawn with it.
    void hold(const std::string& key);
    void resize(int width, int height);
    /// Takes the window off the screen, as a window manager does that minimises it.
    void hide();

    /// Scrolls the open page down until the control is in sight.
    void show(const std::string& label);
    void click(const std::string& label);
    /// Clicks a switch unless it already is as wanted, and waits until it is.
    void set(const std::string& label, bool on);
    /// Types a number over a slider's and presses Return.
    void type_number(const std::string& label, const std::string& text);
    /// Replaces a text field's text and presses Return.
    void type(const std::string& label, const std::string& text);

    /// The window's content, as the screen shows it.
    Image picture();

    /// Throws unless the program still runs, no OpenGL error arose and it wrote no complaint.
    void check_healthy();

    Process& process() { return *process_; }
    /// X's number of the window.
    const std::string& window() const { return window_; }
    Point on_screen(Point p) const;

private:
    Control find(const std::string& label);
    void give_up(const std::string& why);

    const Screen& screen_;
    TemporaryFolder folder_;
    std::unique_ptr<Process> process_;
    std::string window_;
    Point corner_;
};

/// The surroundings of the program: `screen`'s, with a home folder of its own that has no settings yet.
Surroundings at_home_in(const TemporaryFolder& home, const Surroundings& surroundings);

/// The program under test.
std::string program();

}  // namespace drapeau::window_tests
