// The panel's head: which scene, its clock, and what of it is seen.
#include "panels.hpp"

#include "setting_controls.hpp"

#include <imgui.h>

#include <algorithm>

namespace drapeau {

using namespace settings;

namespace {

void choose_scene(AppState& app, Widgets& widgets) {
    const auto stem = app.scene_file.stem().string();
    const auto found = std::find(app.scene_names.begin(), app.scene_names.end(), stem);
    std::vector<std::string> names = app.scene_names;
    int index = int(found - app.scene_names.begin());
    if (found == app.scene_names.end()) names.push_back(stem);
    const std::string tip = "A scene sets everything at once. A scene file can also be dropped on the window.";
    if (widgets.choice("Scene", index, names, -1, tip.c_str())) app.commands.load_scene = names[std::size_t(index)];
}

void choose_view(AppState& app, Widgets& widgets) {
    ViewSettings& view = app.scene.view;
    const float half = ImGui::GetContentRegionAvail().x * 0.5f;
    const auto toggle = [&](bool ViewSettings::*member) {
        edit(widgets, "view", row_of(member, view_keys), view, app.origin.view);
    };
    toggle(&ViewSettings::texture);
    ImGui::SameLine(half);
    ImGui::BeginDisabled(!app.status.image_has_holes);
    toggle(&ViewSettings::cut_out);
    ImGui::EndDisabled();
    toggle(&ViewSettings::cloth);
    ImGui::SameLine(half);
    toggle(&ViewSettings::masses);
    toggle(&ViewSettings::springs);
    ImGui::SameLine(half);
    bool diagonals = app.scene.diagonals().has_value();
    if (widgets.toggle(
            "Diagonals", diagonals,
            "Diagonal springs, simulated and drawn. They resist shear and double the number of springs. Key D"))
        toggle_diagonals(app);
    toggle(&ViewSettings::forces);
    ImGui::SameLine(half);
    toggle(&ViewSettings::reference);
    toggle(&ViewSettings::wind);
}

}  // namespace

void draw_play(AppState& app, Widgets& widgets) {
    choose_scene(app, widgets);
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    const float third = (ImGui::GetContentRegionAvail().x - 2.0f * spacing) / 3.0f;
    if (widgets.button("Pause", "Stops simulated time, or lets it go on. Key Space", third,
                       app.paused ? "Go on###pause" : "Pause###pause"))
        app.paused = !app.paused;
    ImGui::SameLine();
    if (widgets.button("Step", "Takes one step of the method while paused. Key .", third)) app.commands.step = true;
    ImGui::SameLine();
    if (widgets.button("Restart", "Begins again at the scene's start, with the current settings. Key R", third))
        app.commands.restart = true;
    ImGui::Spacing();
    choose_view(app, widgets);
}

}  // namespace drapeau
