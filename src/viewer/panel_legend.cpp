// The legends below the flag, at the right: a bar of colours, or a wedge for lengths, with its numbers; beside each
// other.
#include "panels.hpp"

#include "legend.hpp"

#include <imgui.h>

#include <algorithm>

namespace drapeau {

namespace {

constexpr float usual_font = 15.0f;  // window units; sizes below are for text of this size
constexpr ImU32 back = IM_COL32(22, 29, 39, 225), bright = IM_COL32(232, 236, 241, 255);
constexpr ImU32 faint = IM_COL32(147, 160, 176, 255), yellow = IM_COL32(255, 219, 63, 255);

float width_of(const std::string& text) {
    return ImGui::CalcTextSize(text.c_str()).x;
}

void draw_bar(ImDrawList* list, const Legend& legend, ImVec2 low, ImVec2 high) {
    if (!legend.colours) {
        list->AddTriangleFilled({low.x, (low.y + high.y) / 2.0f}, {high.x, low.y}, high, yellow);
        return;
    }
    const auto& colours = *legend.colours;
    const auto color = [&](std::size_t step) {
        const glm::vec3 c = colours[step];
        return ImGui::ColorConvertFloat4ToU32({as_srgb(c.x), as_srgb(c.y), as_srgb(c.z), 1.0f});
    };
    const float step = (high.x - low.x) / float(colours.size() - 1);
    for (std::size_t i = 0; i + 1 < colours.size(); ++i) {
        const float x = low.x + step * float(i);
        list->AddRectFilledMultiColor({x, low.y}, {x + step, high.y}, color(i), color(i + 1), color(i + 1), color(i));
    }
}

/// Title and kind of range in a line where both have room, the shorter title else; `width` of it.
void draw_title(ImDrawList* list, const Legend& legend, ImVec2 at, float width) {
    const float gap = 0.6f * ImGui::GetFontSize(), range = width_of(legend.range());
    const bool has_room = width_of(legend.title) + gap + range <= width;
    const std::string& title = has_room ? legend.title : legend.short_title;
    list->AddText(at, bright, title.c_str());
    if (width_of(title) + gap + range <= width)
        list->AddText({at.x + width - range, at.y}, faint, legend.range().c_str());
}

/// As many of its numbers as there is room for below the bar, the upper end's first.
void draw_labels(ImDrawList* list, const Legend& legend, ImVec2 at, float width) {
    const auto& [low, middle, high] = legend.labels;
    const float gap = 0.5f * ImGui::GetFontSize(), ends = width_of(low) + gap + width_of(high);
    list->AddText({at.x + width - width_of(high), at.y}, bright, high.c_str());
    if (ends > width) return;
    list->AddText(at, bright, low.c_str());
    if (ends + gap + width_of(middle) > width) return;
    list->AddText({at.x + (width - width_of(middle)) / 2.0f, at.y}, bright, middle.c_str());
}

}  // namespace

void draw_legends(const AppState& app, UiMap& map) {
    const std::vector<Legend> shown = legends(app);
    std::string text;
    for (const Legend& legend : shown) text += (text.empty() ? "" : " | ") + legend.text();
    map.state("legend", text);
    if (shown.empty()) return;

    const Area& view = app.view_area;
    const float scale = ImGui::GetFontSize() / usual_font, margin = 18.0f * scale, height = 12.0f * scale;
    const auto count = float(shown.size());
    const float room = (view.width() - 24.0f * scale) / count - 2.0f * margin;
    const float width = std::min(300.0f * scale, room), box = width + 2.0f * margin;
    const float line = ImGui::GetTextLineHeight(), top = view.y1 - 46.0f * scale;
    float left = view.x1 - 10.0f * scale - count * box + margin;  // at the right: the pole's foot stands at the left
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    list->AddRectFilled({left - margin, top - line - 14.0f * scale},
                        {left - margin + count * box, view.y1 - 10.0f * scale}, back, 8.0f * scale);
    for (const Legend& legend : shown) {
        draw_title(list, legend, {left, top - line - 5.0f * scale}, width);
        draw_bar(list, legend, {left, top}, {left + width, top + height});
        draw_labels(list, legend, {left, top + height + 3.0f * scale}, width);
        left += box;
    }
}

}  // namespace drapeau
