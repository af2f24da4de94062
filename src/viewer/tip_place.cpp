#include "tip_place.hpp"

#include <algorithm>

namespace drapeau {

glm::vec2 tip_corner(const Area& box, const Area& control, glm::vec2 size, glm::vec2 window, float gap) {
    const auto within = [gap](float at, float extent, float end) {
        return std::max(gap, std::min(at, end - extent - gap));
    };
    const float x = within(control.x0, size.x, window.x), y = within(control.y0, size.y, window.y);
    const auto fits = [gap](float room, float extent) { return extent + 2.0f * gap <= room; };
    const bool as_high = fits(window.y, size.y), as_wide = fits(window.x, size.x);
    if (as_high && fits(window.x - box.x1, size.x)) return {box.x1 + gap, y};
    if (as_high && fits(box.x0, size.x)) return {box.x0 - gap - size.x, y};
    if (as_wide && fits(window.y - box.y1, size.y)) return {x, box.y1 + gap};
    if (as_wide && fits(box.y0, size.y)) return {x, box.y0 - gap - size.y};
    const bool below = window.y - control.y1 >= control.y0;
    return {x, below ? within(control.y1 + gap, size.y, window.y) : std::max(gap, control.y0 - gap - size.y)};
}

float tip_width(const Area& box, glm::vec2 window, float gap, float wanted, float least) {
    const float beside = std::max(window.x - box.x1, box.x0) - 2.0f * gap;
    return std::min(beside >= least ? beside : window.x - 2.0f * gap, wanted);
}

}  // namespace drapeau
