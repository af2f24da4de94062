// KeyFeed: keys and text for ImGui in the order they came. Before 1.87 ImGui sees which keys are down when a frame
// begins and what was typed before it, in no order: Control and A that go down and up within a frame would be nothing.
// A frame is given only as many events as keep their meaning then. From 1.87 on ImGui keeps such a queue itself; what
// is typed for a field that is about to open is taken out of it until then.
#pragma once

#include "input.hpp"

#include <deque>
#include <set>
#include <vector>

namespace drapeau {

class KeyFeed {
public:
    /// Between the backend's new frame and ImGui's. `keeps`: all that comes waits, for a field that has the keyboard
    /// only later.
    void feed(const std::vector<InputEvent>& events, bool keeps = false);

    /// Whether events are left for the next frame.
    bool has_waiting() const;

private:
    std::deque<InputEvent> waiting_;
    std::set<int> down_;  // GLFW's numbers
};

}  // namespace drapeau
