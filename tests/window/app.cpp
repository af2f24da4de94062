#include "app.hpp"

#include <cmath>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace drapeau::window_tests {

namespace {

void pause_briefly() {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields{""};
    for (const char c : line) {
        if (c == '\t') {
            fields.emplace_back();
        } else {
            fields.back() += c;
        }
    }
    return fields;
}

Look parse(const std::string& text) {
    Look look;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::vector<std::string> fields = fields_of(line);
        if (fields.size() == 3 && fields[0] == "state") {
            look.states[fields[1]] = fields[2];
        } else if (fields.size() == 6) {
            const Box box{std::stod(fields[1]), std::stod(fields[2]), std::stod(fields[3]), std::stod(fields[4])};
            look.controls[fields[0]] = {box, fields[5]};
        }
    }
    return look;
}

std::string number_of(double pixels) {
    return std::to_string(std::lround(pixels));
}

}  // namespace

const std::string& Look::text(const std::string& state) const {
    const auto found = states.find(state);
    if (found == states.end()) throw std::runtime_error("the window does not tell its state '" + state + "'");
    return found->second;
}

double Look::number(const std::string& state) const {
    return std::stod(text(state));
}

Box Look::box(const std::string& state) const {
    std::istringstream words(text(state));
    Box box;
    words >> box.x0 >> box.y0 >> box.x1 >> box.y1;
    return box;
}

std::string program() {
    return DRAPEAU_PROGRAM;
}

Surroundings at_home_in(const TemporaryFolder& home, const Surroundings& surroundings) {
    Surroundings with_home = surroundings;
    with_home.variables["HOME"] = home.path.string();
    with_home.variables["XDG_CONFIG_HOME"] = (home / "config").string();
    with_home.variables["XDG_CACHE_HOME"] = (home / "cache").string();
    with_home.folder = home.path;
    return with_home;
}

App::App(const Screen& screen, const std::vector<std::string>& arguments, const TemporaryFolder* home)
    : screen_(screen) {
    Surroundings surroundings = at_home_in(home ? *home : folder_, screen.surroundings());
    surroundings.variables["DRAPEAU_UI_MAP"] = (folder_ / "ui-map").string();
    std::vector<std::string> command{program()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    process_ = std::make_unique<Process>(command, surroundings, folder_.path);

    wait_until("first frames", [](const Look& look) { return look.number("frame") >= 2; });
    std::istringstream found(
        screen_.xdotool({"search", "--onlyvisible", "--pid", std::to_string(process_->id()), "--limit", "1"}));
    found >> window_;
    std::istringstream geometry(screen_.xdotool({"getwindowgeometry", "--shell", window_}));
    for (std::string line; std::getline(geometry, line);) {
        if (line.starts_with("X=")) corner_.x = std::stod(line.substr(2));
        if (line.starts_with("Y=")) corner_.y = std::stod(line.substr(2));
    }
}

App::~App() {
    // A failed requirement unwinds through here: keep what was on the screen for whoever reads the report.
    if (std::uncaught_exceptions() == 0) return;
    try {
        const std::filesystem::path file = std::filesystem::path(DRAPEAU_FAILURES) / "window-when-it-failed.png";
        write_png(file, screen_.picture());
        std::cerr << "The screen when it failed: " << file.string() << '\n';
    } catch (const std::exception&) {
        std::cerr << "No picture of the screen could be taken.\n";
    }
}

Look App::look() {
    const Look look = parse(read_text(folder_ / "ui-map"));
    return look;
}

Look App::wait_until(const std::string& what, const std::function<bool(const Look&)>& condition) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    for (;;) {
        const Look now = look();
        if (now.states.contains("frame") && condition(now)) return now;
        if (!process_->running()) give_up("the program ended while waiting for " + what);
        if (std::chrono::steady_clock::now() > deadline) give_up("waited in vain for " + what);
        pause_briefly();
    }
}

Look App::settle() {
    // The frame being drawn may have taken its input before; the one after it has seen everything.
    const double now = look().number("frame");
    double woken = -1.0;
    return wait_until("another frame", [&](const Look& look) {
        // A property that means nothing to the program wakes it from its rest.
        if (look.text("resting") == "1" && look.number("frame") > woken) {
            woken = look.number("frame");
            screen_.xdotool({"set_window", "--icon-name", "woken", window_});
        }
        return look.number("frame") >= now + 2;
    });
}

void App::give_up(const std::string& why) {
    std::string states;
    const Look last = look();
    for (const auto& [name, value] : last.states) states += "\n  " + name + ": " + value;
    for (const auto& [name, control] : last.controls) states += "\n  [" + name + "] " + control.value;
    throw std::runtime_error(why + "\nIt wrote: " + process_->errors() + "\nIt last told:" + states);
}

Point App::on_screen(Point p) const {
    return {corner_.x + p.x, corner_.y + p.y};
}

void App::move_to(Point p) {
    const Point at = on_screen(p);
    screen_.xdotool({"mousemove", number_of(at.x), number_of(at.y)});
    settle();
}

void App::click(Point p, Button button) {
    const std::string number = std::to_string(static_cast<int>(button));
    move_to(p);
    screen_.xdotool({"mousedown", number});
    settle();
    screen_.xdotool({"mouseup", number});
    settle();
}

void App::double_click(Point p) {
    move_to(p);
    screen_.xdotool({"click", "--repeat", "2", "--delay", "60", "1"});
    settle();
}

void App::drag(Point from, Point to, Button button) {
    const std::string number = std::to_string(static_cast<int>(button));
    move_to(from);
    screen_.xdotool({"mousedown", number});
    settle();
    constexpr int moves = 5;
    for (int i = 1; i <= moves; ++i) {
        const double share = double(i) / moves;
        move_to({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
    }
    screen_.xdotool({"mouseup", number});
    settle();
}

void App::wheel(Point p, int notches) {
    move_to(p);
    screen_.xdotool({"click", "--repeat", std::to_string(std::abs(notches)), "--delay", "1", notches > 0 ? "4" : "5"});
    settle();
}

void App::press(const std::string& key) {
    screen_.xdotool({"key", "--delay", "0", key});
    settle();
}

void App::hold(const std::string& key) {
    screen_.xdotool({"keydown", key});
    settle();
    screen_.xdotool({"keyup", key});
    settle();
}

void App::resize(int width, int height) {
    screen_.xdotool({"windowsize", window_, std::to_string(width), std::to_string(height)});
}

void App::hide() {
    screen_.xdotool({"windowunmap", window_});
}

Control App::find(const std::string& label) {
    return wait_until("the control '" + label + "'", [&](const Look& look) { return look.has(label); })
        .controls.at(label);
}

void App::show(const std::string& label) {
    settle();  // a page just opened lies where it stays only once it has been drawn
    const Point page = look().box("panel").at(0.5, 0.5);
    for (int turns = 0; !look().has(label); ++turns) {
        if (turns == 60) give_up("scrolling the page does not bring '" + label + "' into sight");
        wheel(page, -1);
    }
}

void App::click(const std::string& label) {
    click(find(label).box.at(0.5, 0.5));
}

void App::set(const std::string& label, bool on) {
    const std::string wanted = on ? "1" : "0";
    if (find(label).value == wanted) return;
    const Box box = find(label).box;
    click(Point{box.x0 + std::min(8.0, 0.5 * box.width()), box.at(0.5, 0.5).y});
    wait_until("'" + label + "' to be " + wanted,
               [&](const Look& look) { return look.has(label) && look.controls.at(label).value == wanted; });
}

void App::type_number(const std::string& label, const std::string& text) {
    screen_.xdotool({"keydown", "ctrl"});
    click(label);
    screen_.xdotool({"keyup", "ctrl"});
    screen_.xdotool({"type", "--delay", "5", text});
    press("Return");
    // ImGui 1.87 and later spread keys over frames.
    wait_until("the number typed", [&](const Look& look) { return look.has("Number: " + label); });
}

void App::type(const std::string& label, const std::string& text) {
    click(label);
    hold("ctrl+a");  // a tap may begin and end between two frames
    screen_.xdotool({"type", "--delay", "5", text});
    wait_until("'" + label + "' to hold what was typed",
               [&](const Look& look) { return look.has(label) && look.controls.at(label).value == text; });
    hold("Return");
}

Image App::picture() {
    move_to({1.0, 1.0});  // off every control, for a tooltip would be in the picture
    const std::string size = settle().text("window");
    const Image screen = screen_.picture();
    Image window;
    window.width = std::stoi(size);
    window.height = std::stoi(size.substr(size.find('x') + 1));
    window.rgba.reserve(std::size_t(window.width) * window.height * 4);
    for (int row = 0; row < window.height; ++row) {
        const auto start =
            screen.rgba.begin() + (std::ptrdiff_t(row + corner_.y) * screen.width + std::ptrdiff_t(corner_.x)) * 4;
        window.rgba.insert(window.rgba.end(), start, start + window.width * 4);
    }
    return window;
}

void App::check_healthy() {
    const Look now = settle();
    if (now.number("gl_errors") != 0) give_up("OpenGL errors arose");
    if (!process_->errors().empty()) give_up("the program complained");
}

}  // namespace drapeau::window_tests
