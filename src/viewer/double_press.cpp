#include "double_press.hpp"

#include <glm/geometric.hpp>

namespace drapeau {

// A press that waited while a frame was drawn may be as old as that frame.
std::optional<glm::vec2> DoublePress::in(const std::vector<InputEvent>& events) {
    std::optional<glm::vec2> found;
    for (const InputEvent& event : events) {
        if (event.kind != InputEvent::Kind::press || event.button != MouseButton::left) continue;
        const bool twice = event.time - event.waited - pressed_ < seconds && glm::length(event.at - at_) < pixels;
        if (twice) found = event.at;
        pressed_ = twice ? -1e6 : event.time;
        at_ = event.at;
    }
    return found;
}

}  // namespace drapeau
