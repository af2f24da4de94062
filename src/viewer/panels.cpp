#include "panels.hpp"

#include "hand_overlay.hpp"
#include "wind_overlay.hpp"

#include <imgui.h>

#include <iterator>
#include <string>

namespace drapeau {

namespace {

void draw_page(AppState& app, PanelMemory& memory, Widgets& widgets) {
    switch (memory.page) {
        case 0:
            draw_flag_page(app, memory, widgets);
            break;
        case 1:
            draw_springs_page(app, widgets);
            break;
        case 2:
            draw_wind_page(app, memory, widgets);
            break;
        case 3:
            draw_time_page(app, memory, widgets);
            break;
        case 4:
            draw_trade_page(app, widgets);
            break;
        default:
            draw_view_page(app, widgets);
            break;
    }
}

// Where there is room the page scrolls and the rest stays in sight, else the panel scrolls as a whole: never both.
void draw_page_and_readings(AppState& app, PanelMemory& memory, Widgets& widgets) {
    const float row = ImGui::GetFrameHeightWithSpacing();
    const float room = ImGui::GetContentRegionAvail().y - readings_height(app);
    const float page_height = room - plots_height(app);
    const bool scrolls = page_height >= 3.0f * row;
    // Each page is scrolled on its own.
    const std::string name = "page " + std::to_string(memory.page);
    if (scrolls) ImGui::BeginChild(name.c_str(), {0.0f, page_height});
    draw_page(app, memory, widgets);
    if (scrolls) ImGui::EndChild();
    ImGui::Separator();
    draw_readings(app, widgets);
    draw_plots(app, widgets);
}

void draw_panel(AppState& app, PanelMemory& memory, Widgets& widgets) {
    const Area& area = app.panel_area;
    ImGui::SetNextWindowPos({area.x0, area.y0});
    ImGui::SetNextWindowSize({area.width(), area.height()});
    ImGui::Begin("panel", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
    if (app.narrow && widgets.button("Close panel", "Gives the flag the whole window. Key H", -1.0f))
        app.toggle_panel();
    draw_play(app, widgets);

    if (app.mark && app.mark->page >= 0 && !app.mark->scrolled) memory.page = app.mark->page;

    // Pages fill the row, each with as much room beside its name; readings stay in sight below whichever is open.
    ImGui::Spacing();
    constexpr int count = int(std::size(page_names));
    const float spacing = 0.5f * ImGui::GetStyle().ItemSpacing.x;
    float room = ImGui::GetContentRegionAvail().x - (count - 1) * spacing;
    for (const char* name : page_names) room -= ImGui::CalcTextSize(name).x;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.0f, ImGui::GetStyle().FramePadding.y});
    for (int i = 0; i < count; ++i) {
        if (i > 0) ImGui::SameLine(0.0f, spacing);
        const float width = ImGui::CalcTextSize(page_names[i]).x + room / count;
        if (widgets.page(page_names[i], memory.page == i, width, page_tips[i])) memory.page = i;
    }
    ImGui::PopStyleVar();
    ImGui::Spacing();
    draw_page_and_readings(app, memory, widgets);
    ImGui::End();
}

// What opens the panel where it has stepped aside.
void draw_opener(AppState& app, Widgets& widgets) {
    ImGui::SetNextWindowPos({0.0f, 0.0f});
    ImGui::Begin("opener", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    if (widgets.button("Panel", "Opens the panel. Key H")) app.toggle_panel();
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    app.claimed.push_back({low.x, low.y, low.x + size.x, low.y + size.y});
    ImGui::End();
}

}  // namespace

void draw_panels(AppState& app, PanelMemory& memory, UiMap& map) {
    Widgets widgets(map, app.mark, memory.widgets);
    app.claimed.clear();
    if (app.panel_open()) {
        draw_panel(app, memory, widgets);
        if (!widgets.correction().empty()) say(app, Message::Cause::typed, widgets.correction(), false);
        app.claimed.push_back(app.panel_area);
    } else if (app.opener_shown()) {
        draw_opener(app, widgets);
    }
    draw_wind(app, map);
    draw_hand(app);
    draw_readout(app, memory, widgets);
    draw_legends(app, map);
    draw_scene_gallery(app, widgets);
    draw_message(app, widgets);
    draw_film(app, widgets);
    draw_film_progress(app, widgets);
    draw_help(app, widgets);
    draw_question(app, widgets);
    draw_palette(app, widgets);
    if (app.mark && (app.mark->seconds_left -= double(ImGui::GetIO().DeltaTime)) <= 0.0) app.mark.reset();
    draw_activity(app);
}

}  // namespace drapeau
