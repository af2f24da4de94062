// DoublePress: double clicks, found in the events of the window. ImGui counts them in frames: two clicks within one
// frame, or within two that are slow, would be one for it, or none.
#pragma once

#include "input.hpp"

#include <glm/vec2.hpp>

#include <optional>
#include <vector>

namespace drapeau {

class DoublePress {
public:
    static constexpr double seconds = 0.4;  // the second press comes within
    static constexpr float pixels = 6.0f;   // and as near, in window units

    /// Where the left button was pressed for the second time in these events; nothing if it was not.
    std::optional<glm::vec2> in(const std::vector<InputEvent>& events);

private:
    double pressed_ = -1e6;  // s
    glm::vec2 at_{0.0f};
};

}  // namespace drapeau
