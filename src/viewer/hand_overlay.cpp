#include "hand_overlay.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace drapeau {

namespace {

constexpr float usual_font = 15.0f;  // window units; sizes below are for text of this size
constexpr ImU32 bright = IM_COL32(255, 196, 92, 255), outline = IM_COL32(20, 26, 34, 190);

ImVec2 at(glm::vec2 p) {
    return {p.x, p.y};
}

void draw_label(ImDrawList* list, glm::vec2 place, const std::string& text, const Area& view, float scale) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float pad = 5.0f * scale;
    const float x = std::clamp(place.x, view.x0 + pad, std::max(view.x0 + pad, view.x1 - size.x - pad));
    const float y = std::clamp(place.y, view.y0 + pad, std::max(view.y0 + pad, view.y1 - size.y - pad));
    list->AddRectFilled({x - pad, y - pad * 0.6f}, {x + size.x + pad, y + size.y + pad * 0.6f},
                        IM_COL32(22, 29, 39, 225), 5.0f * scale);
    list->AddText({x, y}, IM_COL32(232, 236, 241, 255), text.c_str());
}

std::string written(std::optional<glm::vec2> place) {
    return place ? fmt::format("{:.1f} {:.1f}", place->x, place->y) : "";
}

}  // namespace

void draw_hand(const AppState& app) {
    const auto& held = app.hand.held();
    if (!held) return;
    const auto place = seen_at(app.lens, held->place), mouse = seen_at(app.lens, held->target);
    if (!place || !mouse) return;
    const float scale = ImGui::GetFontSize() / usual_font, ring = 7.0f * scale;
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const glm::vec2 away = *mouse - *place;
    const float length = glm::length(away);
    if (length > ring) {
        const glm::vec2 edge = *place + ring / length * away;
        list->AddLine(at(edge), at(*mouse), outline, 4.0f * scale);
        list->AddLine(at(edge), at(*mouse), bright, 1.8f * scale);
    }
    list->AddCircle(at(*place), ring, outline, 0, 4.0f * scale);
    list->AddCircle(at(*place), ring, bright, 0, 2.0f * scale);
    list->AddCircleFilled(at(*mouse), 3.5f * scale, bright);
    const bool waits = app.paused || app.status.stands();
    const std::string text = waits ? "waits" : fmt::format("{:.3g} N", app.status.pull_force);
    draw_label(list, *mouse + glm::vec2(14.0f, 10.0f) * scale, text, app.view_area, scale);
}

void write_hand(const AppState& app, UiMap& map) {
    const auto& held = app.hand.held();
    const bool read = app.readout.chosen().has_value();
    map.state("held", held ? written(seen_at(app.lens, held->place)) : "");
    map.state("pull", app.status.pull_force);
    map.state("readout", app.readout.title());
    map.state("readout_at", read ? written(seen_at(app.lens, glm::vec3(app.readout.place()))) : "");
    map.state("orbits", app.orbits ? "1" : "0");
}

}  // namespace drapeau
