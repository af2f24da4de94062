// Galleries: the flags on the flag's page, and the scenes over the picture.
#include "panels.hpp"

#include "box_room.hpp"

#include "io/text.hpp"

#include <imgui.h>

#include <algorithm>
#include <set>

namespace drapeau {

namespace fs = std::filesystem;

namespace {

constexpr float usual_font = 15.0f;  // window units; sizes below are for text of this size

float text_scale() {
    return ImGui::GetFontSize() / usual_font;
}

/// The image within a box, whole and in its proportions; until it is made, a shade.
void draw_picture(AppState& app, const fs::path& file, ImVec2 low, ImVec2 high) {
    Thumbnail& thumbnail = app.thumbnails[file];
    thumbnail.wanted = true;
    ImDrawList* list = ImGui::GetWindowDrawList();
    if (thumbnail.texture == 0) return list->AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), 2.0f);
    const float width = high.x - low.x, height = high.y - low.y;
    const float scale = std::min(width / float(thumbnail.width), height / float(thumbnail.height));
    const ImVec2 half(0.5f * scale * float(thumbnail.width), 0.5f * scale * float(thumbnail.height));
    const ImVec2 middle(low.x + 0.5f * width, low.y + 0.5f * height);
    list->AddImage((ImTextureID)(thumbnail.texture), {middle.x - half.x, middle.y - half.y},
                   {middle.x + half.x, middle.y + half.y});
}

/// A box to be clicked; its frame says whether it is chosen or about to be. Draws nothing where it is out of sight.
struct Cell {
    bool clicked = false, in_sight = false;
    ImVec2 low, high;
};

Cell begin_cell(const char* name, ImVec2 size, bool chosen) {
    Cell cell;
    cell.clicked = ImGui::InvisibleButton(name, size);
    cell.low = ImGui::GetItemRectMin();
    cell.high = ImGui::GetItemRectMax();
    cell.in_sight = ImGui::IsItemVisible();
    const bool hovered = ImGui::IsItemHovered();
    if (!cell.in_sight || !(chosen || hovered)) return cell;
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(cell.low, cell.high, ImGui::GetColorU32(ImGuiCol_FrameBgHovered), 4.0f);
    if (chosen) list->AddRect(cell.low, cell.high, ImGui::GetColorU32(ImGuiCol_CheckMark), 4.0f, 0, 2.0f);
    return cell;
}

struct FlagEntry {
    fs::path file;  // empty: plain cloth
    std::string name;
};

/// Plain cloth, the images that were put on the flag from elsewhere, newest first, then those that ship. Names differ.
std::vector<FlagEntry> flag_entries(const AppState& app) {
    std::vector<FlagEntry> entries{{{}, "none"}};
    std::set<std::string> known{"none"};
    for (const fs::path file : app.remembered.recent_images) {
        std::string name = printable(file.filename().string());
        if (!known.insert(name).second) known.insert(name = printable(file.string()));
        entries.push_back({file, name});
    }
    for (const fs::path& file : app.texture_files) entries.push_back({file, file.stem().string()});
    return entries;
}

void draw_flag(AppState& app, Widgets& widgets, const FlagEntry& entry, ImVec2 size) {
    const bool chosen = entry.file == app.texture_file;
    const Cell cell = begin_cell(("flag " + entry.name).c_str(), size, chosen);
    if (!cell.in_sight) return;
    widgets.note(("Flag: " + entry.name).c_str(), chosen ? "1" : "0");
    widgets.tip(entry.file.empty() ? "none: plain cloth" : entry.name.c_str());
    const float inset = 4.0f * text_scale();
    const ImVec2 low(cell.low.x + inset, cell.low.y + inset), high(cell.high.x - inset, cell.high.y - inset);
    if (!entry.file.empty()) {
        draw_picture(app, entry.file, low, high);
    } else {
        const ImVec2 text = ImGui::CalcTextSize("none");
        ImDrawList* list = ImGui::GetWindowDrawList();
        list->AddRect(low, high, ImGui::GetColorU32(ImGuiCol_Border), 2.0f);
        list->AddText({(low.x + high.x - text.x) / 2.0f, (low.y + high.y - text.y) / 2.0f},
                      ImGui::GetColorU32(ImGuiCol_TextDisabled), "none");
    }
    if (cell.clicked) app.commands.load_texture = entry.file.string();
}

void draw_scene(AppState& app, Widgets& widgets, const SceneCard& scene, ImVec2 size) {
    const float scale = text_scale(), inset = 7.0f * scale;
    const bool chosen = app.scene_file.stem() == scene.name;
    const Cell cell = begin_cell(("scene " + scene.name).c_str(), size, chosen);
    widgets.note(("Open: " + scene.name).c_str(), chosen ? "1" : "0");
    if (cell.clicked) {
        app.commands.load_scene = scene.name;
        app.scenes_shown = false;
    }
    if (!cell.in_sight) return;
    const float height = size.y - 2.0f * inset, width = 1.6f * height;
    const ImVec2 low(cell.low.x + inset, cell.low.y + inset), high(low.x + width, low.y + height);
    if (scene.picture.empty())
        ImGui::GetWindowDrawList()->AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), 2.0f);
    else
        draw_picture(app, scene.picture, low, high);
    const float left = high.x + 10.0f * scale, wrap = cell.high.x - inset - left;
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->PushClipRect(cell.low, cell.high, true);
    list->AddText({left, low.y}, ImGui::GetColorU32(ImGuiCol_Text), scene.name.c_str());
    list->AddText(ImGui::GetFont(), 0.9f * ImGui::GetFontSize(), {left, low.y + ImGui::GetTextLineHeightWithSpacing()},
                  ImGui::GetColorU32(ImGuiCol_TextDisabled), scene.summary.c_str(), nullptr, wrap);
    list->PopClipRect();
}

}  // namespace

void draw_flag_gallery(AppState& app, Widgets& widgets) {
    const float spacing = 2.0f, wanted = 72.0f * text_scale(), room = ImGui::GetContentRegionAvail().x;
    const int columns = std::max(2, int((room + spacing) / (wanted + spacing)));
    const float width = (room - float(columns - 1) * spacing) / float(columns);
    ImGui::Spacing();
    ImGui::TextDisabled("Flags");
    widgets.note("Gallery", "");
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {spacing, spacing});
    int column = 0;
    for (const FlagEntry& entry : flag_entries(app)) {
        if (column > 0) ImGui::SameLine();
        draw_flag(app, widgets, entry, {width, 0.7f * width});
        column = (column + 1) % columns;
    }
    ImGui::PopStyleVar();
}

void draw_scene_gallery(AppState& app, Widgets& widgets) {
    if (!app.scenes_shown) return;
    const float scale = text_scale(), margin = 12.0f * scale, spacing = 6.0f * scale;
    const Area view = room_for_box(app, 430.0f * scale + 2.0f * margin);
    const ImVec2 padding = ImGui::GetStyle().WindowPadding;
    const int columns = view.width() - 2.0f * margin >= 720.0f * scale ? 2 : 1;
    const float width = std::min(float(columns) * 430.0f * scale, view.width() - 2.0f * margin);
    const int rows = (int(app.scene_cards.size()) + columns - 1) / columns;
    const float card = 112.0f * scale, head = ImGui::GetFrameHeightWithSpacing() + spacing;
    const float height =
        std::min(head + float(rows) * (card + spacing) + 2.0f * padding.y, view.height() - 2.0f * margin);
    ImGui::SetNextWindowPos({(view.x0 + view.x1) / 2.0f, (view.y0 + view.y1) / 2.0f}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({width, height});
    ImGui::Begin("scenes", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
    if (ImGui::IsWindowAppearing()) ImGui::SetScrollY(0.0f);
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("Scenes that ship");
    const float button = ImGui::CalcTextSize("Close").x + 2.0f * ImGui::GetStyle().FramePadding.x;
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - button);
    if (widgets.button("Close scenes", "Key Esc", 0.0f, "Close")) app.scenes_shown = false;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {spacing, spacing});
    const float room = (ImGui::GetContentRegionAvail().x - float(columns - 1) * spacing) / float(columns);
    int column = 0;
    for (const SceneCard& scene : app.scene_cards) {
        if (column > 0) ImGui::SameLine();
        draw_scene(app, widgets, scene, {room, card});
        column = (column + 1) % columns;
    }
    ImGui::PopStyleVar();
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    app.claimed.push_back({low.x, low.y, low.x + size.x, low.y + size.y});
    ImGui::End();
}

}  // namespace drapeau
