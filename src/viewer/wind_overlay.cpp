#include "wind_overlay.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace drapeau {

namespace {

constexpr float usual_font = 15.0f;  // window units; sizes below are for text of this size
constexpr ImU32 blue = IM_COL32(120, 190, 255, 255), outline = IM_COL32(20, 26, 34, 170);
constexpr float metres_a_speed = 0.045f;  // of arrow, for 1 m/s and a flag 1 m high

ImVec2 at(glm::vec2 p) {
    return {p.x, p.y};
}

/// A flat arrow in the picture; where the wind blows along the view it is short.
void draw_arrow(ImDrawList* list, glm::vec2 tail, glm::vec2 tip, float scale) {
    const float length = glm::length(tip - tail), head = 13.0f * scale;
    if (length < 1.0f) return list->AddCircleFilled(at(tail), 4.0f * scale, blue);
    const glm::vec2 along = (tip - tail) / length, side(-along.y, along.x);
    const glm::vec2 neck = tip - std::min(head, length) * along;
    const auto shape = [&](ImU32 color, float more) {
        list->AddLine(at(tail - more * along), at(neck), color, (4.0f + 2.0f * more) * scale);
        list->AddTriangleFilled(at(tip + 1.6f * more * along), at(neck + (7.0f * scale + more) * side - more * along),
                                at(neck - (7.0f * scale + more) * side - more * along), color);
    };
    shape(outline, 1.5f);
    shape(blue, 0.0f);
}

}  // namespace

void draw_wind(const AppState& app, UiMap& map) {
    const auto& wind = app.scene.wind();
    if (!app.scene.view.wind || !wind) return map.state("wind_shown", "");
    const float scale = ImGui::GetFontSize() / usual_font;
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const glm::dvec3 now = wind->at(app.status.time);
    const double speed = glm::length(now);
    const auto& flag = app.scene.flag;
    const float size = float(flag.rows > 1 ? flag.height : flag.width);
    const glm::vec3 half = 0.5f * metres_a_speed * size * glm::vec3(now);
    const glm::vec3 middle(0.5f * float(flag.columns > 1 ? flag.width : 0.0), 0.13f * size, 0.0f);
    const std::string text = fmt::format("{:.1f} m/s", speed);
    map.state("wind_shown", text);
    const auto tail = seen_at(app.lens, middle - half), tip = seen_at(app.lens, middle + half);
    if (!tail || !tip) return;
    draw_arrow(list, *tail, *tip, scale);
    const ImVec2 room = ImGui::CalcTextSize(text.c_str());
    const glm::vec2 label = 0.5f * (*tail + *tip) + glm::vec2(-0.5f * room.x, -room.y - 12.0f * scale);
    list->AddRectFilled({label.x - 5.0f * scale, label.y - 2.0f * scale},
                        {label.x + room.x + 5.0f * scale, label.y + room.y + 2.0f * scale}, IM_COL32(22, 29, 39, 205),
                        5.0f * scale);
    list->AddText(at(label), IM_COL32(232, 236, 241, 255), text.c_str());
}

bool wind_compass(double& speed, double& degrees, double most, Widgets& widgets) {
    const float scale = ImGui::GetFontSize() / usual_font, radius = 62.0f * scale, rim = 12.0f * scale;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const glm::vec2 middle(low.x + radius + rim, low.y + radius + rim);
    const float side = 2.0f * (radius + rim);
    ImGui::InvisibleButton("compass", {side, side});
    widgets.note("Wind compass", fmt::format("{:.1f} m/s, {:.0f}\xc2\xb0", speed, degrees));
    bool changed = false;
    if (ImGui::IsItemActive()) {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const glm::vec2 out = glm::vec2(mouse.x, mouse.y) - middle;
        const double share = std::min(1.0, double(glm::length(out) / radius));
        speed = std::round(10.0 * most * share * share) / 10.0;  // light winds have the more room
        if (glm::length(out) > 2.0f) degrees = std::round(glm::degrees(std::atan2(double(out.y), double(out.x))));
        changed = true;
    }
    widgets.tip(fmt::format("Seen from above, the flag to the right of its pole, its front below. Drag the handle to "
                            "where the wind is to blow: further out is faster, {:.0f} m/s at the rim.",
                            most)
                    .c_str());

    ImDrawList* list = ImGui::GetWindowDrawList();
    const ImU32 line = IM_COL32(74, 90, 110, 255), text = IM_COL32(147, 160, 176, 255);
    list->AddCircleFilled(at(middle), radius, IM_COL32(24, 32, 43, 255), 64);
    for (const double ring : {5.0, 10.0, 20.0, most}) {
        const float out = radius * float(std::sqrt(ring / most));
        list->AddCircle(at(middle), out, line, 64);
        list->AddText(ImGui::GetFont(), 0.7f * ImGui::GetFontSize(), {middle.x + 2.0f * scale, middle.y - out}, text,
                      fmt::format("{:.0f}", ring).c_str());
    }
    for (const glm::vec2 axis : {glm::vec2(1.0f, 0.0f), glm::vec2(0.0f, 1.0f)})
        list->AddLine(at(middle - radius * axis), at(middle + radius * axis), line);
    // The pole and the flag, as they lie below.
    list->AddLine(at(middle), at(middle + glm::vec2(0.42f * radius, 0.0f)), IM_COL32(226, 96, 88, 255), 3.0f * scale);
    list->AddCircleFilled(at(middle), 3.5f * scale, IM_COL32(190, 196, 204, 255));
    const auto angle = float(glm::radians(degrees));
    const float share = float(std::sqrt(std::min(1.0, speed / most)));
    const glm::vec2 handle = middle + radius * share * glm::vec2(std::cos(angle), std::sin(angle));
    list->AddLine(at(middle), at(handle), blue, 2.5f * scale);
    list->AddCircleFilled(at(handle), 7.0f * scale, outline);
    list->AddCircleFilled(at(handle), 5.5f * scale, blue);

    ImGui::SameLine();
    ImGui::BeginGroup();
    const int force = beaufort(speed);
    ImGui::TextUnformatted(fmt::format("{:.1f} m/s", speed).c_str());
    ImGui::TextUnformatted(fmt::format("{:.1f} knots", speed * knots_in_a_metre_per_second).c_str());
    ImGui::TextUnformatted(fmt::format("Beaufort {}", force).c_str());
    widgets.note("Reading: Beaufort", fmt::format("{} {}", force, beaufort_name(force)));
    ImGui::PushStyleColor(ImGuiCol_Text, text);
    ImGui::TextUnformatted(beaufort_name(force));
    ImGui::PopStyleColor();
    ImGui::EndGroup();
    return changed;
}

}  // namespace drapeau
