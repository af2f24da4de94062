// The readout: a box beside the mass or spring that was clicked, with its values and one of them over time.
#include "hand_overlay.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace drapeau {

namespace {

constexpr float usual_font = 15.0f;  // window units; sizes below are for text of this size
constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                   ImGuiWindowFlags_NoFocusOnAppearing;
constexpr ImU32 bright = IM_COL32(255, 196, 92, 255), dim = IM_COL32(147, 160, 176, 255);

std::string value_of(const Quantity& quantity) {
    return quantity.value ? fmt::format("{:.{}f} {}", *quantity.value, quantity.decimals, quantity.unit)
                          : "\xe2\x80\x93";
}

/// Where the box is put: beside the place, on the side that has the room.
ImVec2 corner_beside(glm::vec2 place, const Area& view, ImVec2 size, float scale) {
    const float gap = 34.0f * scale, margin = 8.0f * scale;
    const bool right = place.x + gap + size.x + margin < view.x1;
    const float x = right ? place.x + gap : place.x - gap - size.x;
    return {
        std::clamp(x, view.x0 + margin, std::max(view.x0 + margin, view.x1 - size.x - margin)),
        std::clamp(place.y - 0.5f * size.y, view.y0 + margin, std::max(view.y0 + margin, view.y1 - size.y - margin))};
}

void point_at(glm::vec2 place, ImVec2 box, ImVec2 size, float scale) {
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const ImVec2 nearest(std::clamp(place.x, box.x, box.x + size.x), std::clamp(place.y, box.y, box.y + size.y));
    list->AddLine({place.x, place.y}, nearest, IM_COL32(20, 26, 34, 170), 3.0f * scale);
    list->AddLine({place.x, place.y}, nearest, bright, 1.2f * scale);
    list->AddCircleFilled({place.x, place.y}, 5.0f * scale, IM_COL32(20, 26, 34, 190));
    list->AddCircleFilled({place.x, place.y}, 3.5f * scale, bright);
}

/// One quantity over the last seconds, between the least and the greatest it was.
void draw_curve(const Readout& readout, std::size_t which, float scale) {
    const ImVec2 low = ImGui::GetCursorScreenPos(), size(230.0f * scale, 64.0f * scale);
    ImGui::Dummy(size);
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(low, {low.x + size.x, low.y + size.y}, IM_COL32(14, 19, 26, 255), 4.0f * scale);
    const auto& past = readout.past();
    double least = INFINITY, most = -INFINITY;
    for (const auto& sample : past)
        if (const auto& value = sample.quantities[which].value) {
            least = std::min(least, *value);
            most = std::max(most, *value);
        }
    if (!(least <= most)) return;
    const double middle = 0.5 * (least + most);
    const double half = std::max(0.5 * (most - least), 0.5 * std::pow(10.0, -readout.quantities()[which].decimals));
    std::vector<ImVec2> points;
    for (const auto& sample : past)
        if (const auto& value = sample.quantities[which].value) {
            const double across = 1.0 - (past.back().time - sample.time) / Readout::kept;
            const double up = 0.5 + 0.42 * (*value - middle) / half;
            points.push_back({low.x + float(across) * size.x, low.y + float(1.0 - up) * size.y});
        }
    list->AddPolyline(points.data(), int(points.size()), bright, 0, 1.5f * scale);
    const Quantity& quantity = readout.quantities()[which];
    const auto label = [&](double value, float y) {
        list->AddText(ImGui::GetFont(), 0.8f * ImGui::GetFontSize(), {low.x + 4.0f * scale, y}, dim,
                      fmt::format("{:.{}f} {}", value, quantity.decimals, quantity.unit).c_str());
    };
    label(middle + half, low.y + 1.0f * scale);
    label(middle - half, low.y + size.y - 0.8f * ImGui::GetFontSize() - 2.0f * scale);
    const std::string span = fmt::format("{:.0f} s", Readout::kept);
    list->AddText(ImGui::GetFont(), 0.8f * ImGui::GetFontSize(),
                  {low.x + size.x - ImGui::CalcTextSize(span.c_str()).x,
                   low.y + size.y - 0.8f * ImGui::GetFontSize() - 2.0f * scale},
                  dim, span.c_str());
}

/// Every quantity in a line; the one that is drawn over time is chosen by a click on its line.
void draw_values(const Readout& readout, int& drawn, Widgets& widgets, float scale) {
    const auto& quantities = readout.quantities();
    for (int n = 0; n < int(quantities.size()); ++n) {
        const Quantity& quantity = quantities[std::size_t(n)];
        const std::string value = value_of(quantity);
        const std::string label = std::string(quantity.name) + "###read " + quantity.name;
        if (ImGui::Selectable(label.c_str(), drawn == n, 0, {230.0f * scale, 0.0f})) drawn = n;
        widgets.note(("Read: " + std::string(quantity.name)).c_str(), value);
        widgets.tip(fmt::format("{}\nA click shows it over the last {:.0f} s.", quantity.about, Readout::kept).c_str());
        const float width = ImGui::CalcTextSize(value.c_str()).x;
        ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + 230.0f * scale - width);
        ImGui::TextUnformatted(value.c_str());
    }
}

}  // namespace

void draw_readout(AppState& app, PanelMemory& memory, Widgets& widgets) {
    Readout& readout = app.readout;
    if (!readout.chosen() || readout.quantities().empty()) return;
    const float scale = ImGui::GetFontSize() / usual_font;
    const auto place = seen_at(app.lens, glm::vec3(readout.place()));
    const glm::vec2 beside = place.value_or(glm::vec2(app.view_area.x0, app.view_area.y0));
    ImGui::SetNextWindowPos(corner_beside(beside, app.view_area, memory.readout_size, scale));
    ImGui::Begin("readout", nullptr, flags);
    ImGui::TextUnformatted(readout.title().c_str());
    int& drawn = readout.chosen()->is_spring() ? memory.read_spring : memory.read_mass;
    draw_values(readout, drawn, widgets, scale);
    ImGui::Spacing();
    draw_curve(readout, std::size_t(drawn), scale);
    ImGui::Spacing();
    const bool closed = widgets.button("Close readout", "Key Esc, or a click beside the cloth");
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    ImGui::End();
    memory.readout_size = size;
    if (place) point_at(*place, low, size, scale);
    app.claimed.push_back({low.x, low.y, low.x + size.x, low.y + size.y});
    if (closed) readout.close();
}

}  // namespace drapeau
