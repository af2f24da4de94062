// Layout: how the panel and the flag share the window. Beside the flag the panel takes at most half the width. In a
// window too narrow for that it steps aside: it is opened over part of the view, and the flag moves into the rest.
#pragma once

#include "app_state.hpp"

namespace drapeau {

/// Sets the areas of panel and flag, known before anything is drawn. `scale`: how much larger than usual text is.
void lay_out(AppState& app, float width, float height, float scale);

}  // namespace drapeau
