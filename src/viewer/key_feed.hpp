// KeyFeed: keys and text for ImGui in the order they came. Before 1.87 ImGui sees which keys are down when a frame
// begins and what was typed before it, in no order: Control and A that go down and up within a frame would be nothing.
// A frame is given only as many events as keep their meaning then. From 1.87 on ImGui keeps such a queue itself; while
// a field is about to open, frames do not see the keys in it.
#pragma once

#include "input.hpp"

#include <deque>
#include <set>
#include <utility>
#include <vector>

namespace drapeau {

class KeyFeed {
public:
    /// Begins ImGui's frame, after the backend's. `keeps`: all that comes waits, for a field that has the keyboard only
    /// later.
    void new_frame(const std::vector<InputEvent>& events, bool keeps = false);

    /// Whether events are left for the next frame.
    bool has_waiting() const;

    /// What was typed and still waits as the mouse is pressed would go to whatever is pressed: it is dropped. Tells
    /// once that it was.
    bool dropped() { return std::exchange(dropped_, false); }

private:
    // Where ImGui has no queue.
    void feed(const std::vector<InputEvent>& events, bool keeps);
    void give(bool keeps);         // to ImGui what a frame takes
    void drop(std::size_t count);  // of what waits longest

    std::deque<InputEvent> waiting_;
    std::set<int> down_;  // GLFW's numbers
    bool dropped_ = false;
};

}  // namespace drapeau
