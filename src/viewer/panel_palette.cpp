// The command palette: a text, and what it finds.
#include "panels.hpp"

#include "box_room.hpp"

#include "io/text.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace drapeau {

namespace {

constexpr float usual_font = 15.0f;  // window units; sizes below are for text of this size
constexpr int rows_shown = 12;

int on_arrow(ImGuiInputTextCallbackData* data) {
    int& chosen = static_cast<Palette*>(data->UserData)->chosen;
    chosen += data->EventKey == ImGuiKey_UpArrow ? -1 : 1;
    return 0;
}

/// Whether Return was pressed in the field.
bool draw_field(Palette& palette, Widgets& widgets) {
    const std::string before = palette.text;
    if (palette.begins) ImGui::SetKeyboardFocusHere();
    palette.begins = false;
    ImGui::SetNextItemWidth(-1.0f);
    const bool entered = ImGui::InputTextWithHint(
        "##find", "an action, a setting, a choice, a scene or a flag", &palette.text,
        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackHistory, on_arrow, &palette);
    widgets.note("Find", palette.text);
    if (palette.text != before) palette.chosen = 0;
    // Escape leaves the field, as does a click.
    if (ImGui::IsItemDeactivated() && !entered && !ImGui::IsMouseDown(0)) palette.open = false;
    return entered;
}

bool draw_row(const PaletteItem& item, bool chosen, bool follows, Widgets& widgets) {
    const bool clicked = ImGui::Selectable("##row", chosen);
    widgets.note(("Found: " + item.label).c_str(), chosen ? "1" : "0");
    if (chosen && follows) ImGui::SetScrollHereY(0.5f);
    ImGui::SameLine(ImGui::GetStyle().FramePadding.x);
    ImGui::TextUnformatted(printable(item.label).c_str());
    const std::string detail = one_line(item.detail, 48);
    const float padding = ImGui::GetStyle().FramePadding.x;
    const float right = ImGui::GetWindowContentRegionMax().x - padding;
    const float left = right - ImGui::CalcTextSize(detail.c_str()).x;
    if (left < ImGui::CalcTextSize(printable(item.label).c_str()).x + 4.0f * padding) return clicked;  // no room
    ImGui::SameLine(left);
    ImGui::TextDisabled("%s", detail.c_str());
    return clicked;
}

void draw_found(AppState& app, bool entered, int chosen_before, Widgets& widgets) {
    Palette& palette = app.palette;
    const auto items = matching(palette_items(app), palette.text);
    if (items.empty()) {
        ImGui::TextDisabled("Nothing has such a name.");
        palette.begins = entered;  // the field takes the keys again
        return;
    }
    palette.chosen = std::clamp(palette.chosen, 0, int(items.size()) - 1);
    const int rows = std::min(rows_shown, int(items.size()));
    ImGui::BeginChild("found", {0.0f, float(rows) * ImGui::GetTextLineHeightWithSpacing()});
    for (int i = 0; i < int(items.size()); ++i) {
        ImGui::PushID(i);
        const bool chosen = i == palette.chosen;
        const bool clicked = draw_row(items[std::size_t(i)], chosen, palette.chosen != chosen_before, widgets);
        ImGui::PopID();
        if (clicked || (entered && chosen)) choose(items[std::size_t(i)], app);
    }
    ImGui::EndChild();
}

}  // namespace

void draw_palette(AppState& app, Widgets& widgets) {
    Palette& palette = app.palette;
    if (!palette.open) return;
    const float scale = ImGui::GetFontSize() / usual_font;
    const Area view = room_for_box(app, 430.0f * scale);
    const float width = std::min(560.0f * scale, view.width() - 24.0f * scale);
    ImGui::SetNextWindowPos({(view.x0 + view.x1) / 2.0f, view.y0 + 14.0f * scale}, ImGuiCond_Always, {0.5f, 0.0f});
    ImGui::SetNextWindowSize({width, 0.0f});
    if (palette.begins) ImGui::SetNextWindowFocus();
    ImGui::Begin("palette", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollbar);
    const int chosen_before = palette.chosen;
    const bool entered = draw_field(palette, widgets);
    draw_found(app, entered, chosen_before, widgets);
    const bool within =
        ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows | ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    if (ImGui::IsMouseClicked(0) && !within) palette.open = false;
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    app.claimed.push_back({low.x, low.y, low.x + size.x, low.y + size.y});
    ImGui::End();
}

}  // namespace drapeau
