// Where a box over the picture may stand: beside the panel, or over it too where a box of its width has no room there.
#pragma once

#include "app_state.hpp"

namespace drapeau {

/// `wanted`: the box's width, in window units.
inline Area room_for_box(const AppState& app, float wanted) {
    Area room = app.view_area;
    if (app.narrow || room.width() < wanted) room.x0 = 0.0f;
    return room;
}

}  // namespace drapeau
