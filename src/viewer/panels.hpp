// Panels: everything ImGui shows. They edit the session's plain data and leave wishes; main applies both.
#pragma once

#include "session.hpp"
#include "ui_map.hpp"
#include "widgets.hpp"

#include <string>

namespace drapeau {

/// What the panels remember between frames.
struct PanelMemory {
    int page = 0;
    double wind_direction = 0.0;  // degrees; kept while there is no wind to read it from
    std::string texture_text, scene_text, save_text;
};

void draw_panels(Session& session, PanelMemory& memory, UiMap& map);

// The panel's parts, each in a file of its own.
void draw_play(Session& session, Widgets& widgets);
void draw_flag_page(Session& session, PanelMemory& memory, Widgets& widgets);
void draw_springs_page(Session& session, Widgets& widgets);
void draw_wind_page(Session& session, PanelMemory& memory, Widgets& widgets);
void draw_time_page(Session& session, PanelMemory& memory, Widgets& widgets);
float readings_height(const Session& session);  // of what draw_readings shows
void draw_readings(const Session& session, Widgets& widgets);
void draw_message(Session& session, Widgets& widgets);
void draw_question(Session& session, Widgets& widgets);
void draw_activity(const Session& session);
void draw_help(Session& session, Widgets& widgets);
void draw_legend(const Session& session);

}  // namespace drapeau
