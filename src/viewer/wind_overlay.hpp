// The wind as it is shown: an arrow over the picture, a dial on the page of the wind.
#pragma once

#include "app_state.hpp"
#include "ui_map.hpp"
#include "widgets.hpp"

namespace drapeau {

/// An arrow above the flag, as long as the wind of this moment is fast, its speed beside it.
void draw_wind(const AppState& app, UiMap& map);

/// A dial seen from above: its handle stands where the wind blows to, as far out as it is fast. `speed` (m/s) and
/// `degrees` (0: along the flag, away from the pole; 90: towards its front) follow the mouse. Whether they changed.
bool wind_compass(double& speed, double& degrees, double most, Widgets& widgets);

}  // namespace drapeau
