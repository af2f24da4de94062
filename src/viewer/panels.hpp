// Panels: everything ImGui shows. They edit the application's plain state and leave commands; main applies both.
#pragma once

#include "app_state.hpp"
#include "ui_map.hpp"
#include "widgets.hpp"

#include <imgui.h>

#include <string>

namespace drapeau {

inline constexpr const char* page_names[] = {"Flag", "Springs", "Wind", "Time", "Trade", "View"};
inline constexpr const char* page_tips[] = {
    "The grid of masses, size, attachment and image.",
    "Springs or a fabric, and what acts on the cloth.",
    "The wind and its gusts.",
    "Method, step and precision, files and films.",
    "What accuracy costs: by method, by step, by part.",
    "What is drawn, and in which colours.",
};

/// What the panels remember between frames.
struct PanelMemory {
    int page = 0;
    int read_mass = 0, read_spring = 0;   // which quantity of a readout is drawn over time
    ImVec2 readout_size{260.0f, 300.0f};  // as it was last drawn
    double wind_direction = 0.0;          // degrees; kept while there is no wind to read it from
    std::string texture_text, scene_text, save_text;
    WidgetMemory widgets;
};

void draw_panels(AppState& app, PanelMemory& memory, UiMap& map);

// The panel's parts, each in a file of its own.
void draw_play(AppState& app, Widgets& widgets);
void draw_history(AppState& app, Widgets& widgets);
void draw_timeline(AppState& app, Widgets& widgets);
void draw_travel(AppState& app, Widgets& widgets);
float plots_height(const AppState& app);  // of what draw_plots shows
void draw_plots(AppState& app, Widgets& widgets);
void draw_flag_page(AppState& app, PanelMemory& memory, Widgets& widgets);
void draw_flag_gallery(AppState& app, Widgets& widgets);
void draw_scene_gallery(AppState& app, Widgets& widgets);
void draw_springs_page(AppState& app, Widgets& widgets);
void draw_wind_page(AppState& app, PanelMemory& memory, Widgets& widgets);
void draw_time_page(AppState& app, PanelMemory& memory, Widgets& widgets);
void draw_trade_page(AppState& app, Widgets& widgets);
void draw_view_page(AppState& app, Widgets& widgets);
float readings_height(const AppState& app);  // of what draw_readings shows
void draw_readings(const AppState& app, Widgets& widgets);
void draw_message(AppState& app, Widgets& widgets);
void draw_question(AppState& app, Widgets& widgets);
void draw_activity(const AppState& app);
void draw_palette(AppState& app, Widgets& widgets);
void draw_help(AppState& app, Widgets& widgets);
void draw_legends(const AppState& app, UiMap& map);
void draw_film(AppState& app, Widgets& widgets);
void draw_film_progress(AppState& app, Widgets& widgets);

}  // namespace drapeau
