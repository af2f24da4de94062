// The two buttons that take settings back and set them again.
#include "panels.hpp"

#include <imgui.h>

#include <cmath>

namespace drapeau {

namespace {

/// A turning arrow upon the last item, drawn rather than written, for not every font has one.
void draw_arrow(bool forth, bool bright) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float side = high.y - low.y, turn = forth ? 1.0f : -1.0f, r = 0.25f * side;
    const ImVec2 centre((low.x + high.x) / 2.0f, (low.y + high.y) / 2.0f + 0.04f * side);
    const ImU32 color = ImGui::GetColorU32(bright ? ImGuiCol_Text : ImGuiCol_TextDisabled);
    ImDrawList* list = ImGui::GetWindowDrawList();
    constexpr int points = 16;
    const float begin = -0.5f, end = 3.7f;  // radians, from the arrow's head on
    const auto at = [&](float angle, float radius) {
        return ImVec2(centre.x + turn * radius * std::cos(angle), centre.y - radius * std::sin(angle));
    };
    for (int i = 0; i <= points; ++i)
        list->PathLineTo(at(begin + 0.75f + (end - begin - 0.75f) * float(i) / points, r));
    list->PathStroke(color, 0, 1.6f);
    const ImVec2 tip = at(begin, r), outer = at(begin + 0.95f, 1.75f * r), inner = at(begin + 0.95f, 0.35f * r);
    list->AddTriangleFilled(tip, forth ? inner : outer, forth ? outer : inner, color);  // clockwise
}

bool history_button(const char* label, const std::string& what, const char* key, bool forth, Widgets& widgets) {
    const std::string tip = what.empty() ? "Nothing to " + std::string(forth ? "redo" : "undo") + "."
                                         : std::string(label) + ": " + what + ". " + key;
    ImGui::BeginDisabled(what.empty());
    const bool clicked = widgets.button(label, tip.c_str(), ImGui::GetFrameHeight(), "##button");
    draw_arrow(forth, !what.empty());
    ImGui::EndDisabled();
    return clicked;
}

}  // namespace

void draw_history(AppState& app, Widgets& widgets) {
    if (history_button("Undo", app.history.undone(), "Key Ctrl Z", false, widgets)) app.commands.undo = true;
    ImGui::SameLine();
    if (history_button("Redo", app.history.redone(), "Key Ctrl Shift Z", true, widgets)) app.commands.redo = true;
}

}  // namespace drapeau
