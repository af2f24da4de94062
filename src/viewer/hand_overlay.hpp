// What lies over the picture where the cloth is touched: the spring between mouse and cloth, and the readout of a mass
// or a spring.
#pragma once

#include "app_state.hpp"
#include "panels.hpp"
#include "ui_map.hpp"
#include "widgets.hpp"

namespace drapeau {

/// The spring of the hand, with a ring where it holds and its force in newtons.
void draw_hand(const AppState& app);

/// The values of what was clicked, and one of them over the last seconds.
void draw_readout(AppState& app, PanelMemory& memory, Widgets& widgets);

/// Where the cloth is held and what is read, for tests.
void write_hand(const AppState& app, UiMap& map);

}  // namespace drapeau
