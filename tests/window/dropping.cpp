#include "dropping.hpp"

#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <thread>

namespace drapeau::window_tests {

namespace {

constexpr long protocol_version = 5;

/// The window that is dragged from.
class Source {
public:
    Source(const std::string& display, ::Window target, std::string list)
        : display_(XOpenDisplay(display.c_str())), target_(target), list_(std::move(list)) {
        if (!display_) throw std::runtime_error("the screen does not answer");
        window_ = XCreateSimpleWindow(display_.get(), DefaultRootWindow(display_.get()), 0, 0, 1, 1, 0, 0, 0);
        XSetSelectionOwner(display_.get(), atom("XdndSelection"), window_, CurrentTime);
    }

    void check_aware() {
        Atom type = None;
        int format = 0;
        unsigned long count = 0, left = 0;
        unsigned char* data = nullptr;
        XGetWindowProperty(display_.get(), target_, atom("XdndAware"), 0, 1, False, XA_ATOM, &type, &format, &count,
                           &left, &data);
        const long version = data && count == 1 ? long(*reinterpret_cast<unsigned long*>(data)) : 0;
        if (data) XFree(data);
        if (version < protocol_version) throw std::runtime_error("the window takes no XDND drops");
    }

    void enter() { send("XdndEnter", protocol_version << 24, long(atom("text/uri-list"))); }

    /// Whether the window would take a drop at this point of the screen.
    bool move_to(Point at) {
        send("XdndPosition", 0, std::lround(at.x) << 16 | std::lround(at.y), CurrentTime, long(atom("XdndActionCopy")));
        return (wait_for("XdndStatus").l[1] & 1) != 0;
    }

    /// Whether the window took it. The protocol has a bit for that; GLFW answers with the number of bytes it took.
    bool let_go() {
        send("XdndDrop", 0, CurrentTime);
        return wait_for("XdndFinished").l[1] != 0;
    }

private:
    struct Close {
        void operator()(Display* display) const { XCloseDisplay(display); }
    };
    struct Message {
        long l[5]{};
    };

    Atom atom(const char* name) { return XInternAtom(display_.get(), name, False); }

    void send(const char* name, long second, long third = 0, long fourth = 0, long fifth = 0) {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = target_;
        event.xclient.message_type = atom(name);
        event.xclient.format = 32;
        const long data[5] = {long(window_), second, third, fourth, fifth};
        for (int i = 0; i < 5; ++i) event.xclient.data.l[i] = data[i];
        XSendEvent(display_.get(), target_, False, NoEventMask, &event);
        XFlush(display_.get());
    }

    /// Hands the list over whenever it is asked for.
    Message wait_for(const char* name) {
        const auto deadline = std::chrono::steady_clock::now() + patience;
        while (std::chrono::steady_clock::now() < deadline) {
            while (XPending(display_.get()) > 0) {
                XEvent event;
                XNextEvent(display_.get(), &event);
                if (event.type == SelectionRequest) hand_over(event.xselectionrequest);
                if (event.type != ClientMessage || event.xclient.message_type != atom(name)) continue;
                Message message;
                for (int i = 0; i < 5; ++i) message.l[i] = event.xclient.data.l[i];
                return message;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        throw std::runtime_error(std::string("the window never answered with ") + name);
    }

    void hand_over(const XSelectionRequestEvent& request) {
        const bool known = request.target == atom("text/uri-list");
        if (known)
            XChangeProperty(display_.get(), request.requestor, request.property, request.target, 8, PropModeReplace,
                            reinterpret_cast<const unsigned char*>(list_.data()), int(list_.size()));
        XEvent answer{};
        answer.xselection.type = SelectionNotify;
        answer.xselection.requestor = request.requestor;
        answer.xselection.selection = request.selection;
        answer.xselection.target = request.target;
        answer.xselection.property = known ? request.property : None;
        answer.xselection.time = request.time;
        XSendEvent(display_.get(), request.requestor, False, NoEventMask, &answer);
        XFlush(display_.get());
    }

    std::unique_ptr<Display, Close> display_;
    ::Window target_ = None, window_ = None;
    std::string list_;
};

}  // namespace

std::string uri_list(const std::vector<std::string>& files) {
    constexpr const char* digits = "0123456789ABCDEF";
    std::string list;
    for (const std::string& file : files) {
        list += "file://";
        for (const char c : file) {
            const auto byte = static_cast<unsigned char>(c);
            const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '/' ||
                               c == '.' || c == '-' || c == '_' || c == '~';
            if (plain)
                list += c;
            else
                list += {'%', digits[byte >> 4], digits[byte & 15]};
        }
        list += "\r\n";
    }
    return list;
}

void drop_files(const Screen& screen, const App& app, Point p, const std::vector<std::string>& files) {
    Source source(*screen.surroundings().variables.at("DISPLAY"), std::stoul(app.window()), uri_list(files));
    source.check_aware();
    source.enter();
    const Point at = app.on_screen(p);
    for (const double share : {0.0, 0.5, 1.0})
        if (!source.move_to({at.x + 40.0 * (share - 1.0), at.y})) throw std::runtime_error("the window refuses a drop");
    if (!source.let_go()) throw std::runtime_error("the window did not take the drop");
}

}  // namespace drapeau::window_tests
