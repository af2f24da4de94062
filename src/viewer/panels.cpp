#include "panels.hpp"

#include <imgui.h>

#include <algorithm>

namespace drapeau {

namespace {

constexpr float margin = 12.0f;        // window units around the panel
constexpr float panel_width = 348.0f;  // window units

void draw_panel(Session& session, PanelMemory& memory, Widgets& widgets) {
    const Area& area = session.panel_area;
    ImGui::SetNextWindowPos({area.x0, area.y0});
    ImGui::SetNextWindowSize({area.width(), area.height()});
    ImGui::Begin("panel", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
    draw_play(session, widgets);

    // Pages share the row equally; readings stay in sight below whichever is open.
    ImGui::Spacing();
    static constexpr const char* names[] = {"Flag", "Springs", "Wind", "Time"};
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - 3.0f * spacing) / 4.0f;
    for (int i = 0; i < 4; ++i) {
        if (i > 0) ImGui::SameLine();
        if (widgets.page(names[i], memory.page == i, width)) memory.page = i;
    }
    ImGui::Spacing();
    const float page_height = std::max(5.0f * ImGui::GetFrameHeightWithSpacing(),
                                       ImGui::GetContentRegionAvail().y - readings_height(session));
    ImGui::BeginChild("page", {0.0f, page_height});
    switch (memory.page) {
        case 0:
            draw_flag_page(session, memory, widgets);
            break;
        case 1:
            draw_springs_page(session, widgets);
            break;
        case 2:
            draw_wind_page(session, memory, widgets);
            break;
        default:
            draw_time_page(session, memory, widgets);
            break;
    }
    ImGui::EndChild();
    ImGui::Separator();
    draw_readings(session, widgets);
    ImGui::End();
}

}  // namespace

void lay_out(Session& session, float width, float height, float scale) {
    session.panel_area = {};
    session.view_area = {0.0f, 0.0f, width, height};
    if (!session.panel_shown) return;
    const float gap = margin * scale;
    session.panel_area = {gap, gap, gap + std::min(panel_width * scale, width - 2.0f * gap), height - gap};
    // A window too narrow for both gives the flag its whole width, behind the panel.
    if (session.panel_area.x1 < 0.7f * width) session.view_area.x0 = session.panel_area.x1;
}

void draw_panels(Session& session, PanelMemory& memory, UiMap& map) {
    Widgets widgets(map);
    session.claimed.clear();
    if (session.panel_shown) {
        draw_panel(session, memory, widgets);
        session.claimed.push_back(session.panel_area);
    }
    if (session.scene.view.forces) draw_legend(session);
    draw_message(session, widgets);
    draw_help(session, widgets);
    draw_question(session, widgets);
    draw_activity(session);
}

}  // namespace drapeau
