// What the palette offers besides keys, settings and files: the panel's buttons, and each choice of a list.
#pragma once

#include "palette.hpp"

#include <string>
#include <vector>

namespace drapeau {

void add_buttons(const AppState& app, std::vector<PaletteItem>& items);
void add_choices(const AppState& app, std::vector<PaletteItem>& items);

}  // namespace drapeau
