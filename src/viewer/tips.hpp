// Tips: what a control says when the mouse has rested on it for a while.
#pragma once

#include "ui_map.hpp"

namespace drapeau {

struct TipMemory {
    unsigned control = 0;  // the mouse rests on it
    double since = 0.0;    // s
    bool seen = false;     // in this frame
};

/// Explains the last item of ImGui once the mouse has rested on it for half a second. Gives the seconds until then; 0:
/// there is nothing to wait for.
double show_tip(const char* text, TipMemory& memory, UiMap& map);

}  // namespace drapeau
