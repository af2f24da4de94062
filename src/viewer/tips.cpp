#include "tips.hpp"

#include "tip_place.hpp"

#include <imgui.h>
#include <imgui_internal.h>

namespace drapeau {

namespace {

constexpr double rest_seconds = 0.5;

void draw_tip(const char* text, UiMap& map) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize(), gap = 0.5f * em;
    const ImRect holder = ImGui::GetCurrentWindow()->RootWindow->Rect();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const Area box{holder.Min.x, holder.Min.y, holder.Max.x, holder.Max.y}, control{low.x, low.y, high.x, high.y};
    const glm::vec2 window(display.x, display.y), padding(2.0f * style.WindowPadding.x, 2.0f * style.WindowPadding.y);
    const float wrap = tip_width(box, window, gap, 22.0f * em + padding.x, 10.0f * em + padding.x) - padding.x;
    const ImVec2 extent = ImGui::CalcTextSize(text, nullptr, false, wrap);
    const glm::vec2 size = glm::vec2(extent.x, extent.y) + padding;
    const glm::vec2 corner = tip_corner(box, control, size, window, gap);
    ImGui::SetNextWindowPos({corner.x, corner.y});
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(wrap + style.WindowPadding.x);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    map.control("Tip", corner.x, corner.y, corner.x + size.x, corner.y + size.y, text);
}

}  // namespace

double show_tip(const char* text, TipMemory& memory, UiMap& map) {
    if (!text || !*text || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return 0.0;
    const ImVec2 place[] = {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
    const unsigned control = ImHashData(place, sizeof place);
    const double now = ImGui::GetTime();
    memory.seen = true;
    if (control != memory.control || ImGui::IsMouseDown(0)) memory = {control, now, true};
    if (ImGui::IsMouseDown(0)) return 0.0;
    const double left = memory.since + rest_seconds - now;
    if (left > 0.0) return left;
    draw_tip(text, map);
    return 0.0;
}

}  // namespace drapeau
