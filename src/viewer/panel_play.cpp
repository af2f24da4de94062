// The panel's head: which scene, its clock, and what of it is seen.
#include "panels.hpp"

#include "setting_controls.hpp"

#include <imgui.h>

#include <algorithm>

namespace drapeau {

using namespace settings;

namespace {

void choose_scene(Session& session, Widgets& widgets) {
    const auto stem = session.scene_file.stem().string();
    const auto found = std::find(session.scene_names.begin(), session.scene_names.end(), stem);
    std::vector<std::string> names = session.scene_names;
    int index = int(found - session.scene_names.begin());
    if (found == session.scene_names.end()) names.push_back(stem);
    const std::string tip = "A scene sets everything at once. A scene file can also be dropped on the window.";
    if (widgets.choice("Scene", index, names, -1, tip.c_str())) session.wishes.load_scene = names[std::size_t(index)];
}

void choose_view(Session& session, Widgets& widgets) {
    ViewSettings& view = session.scene.view;
    const float half = ImGui::GetContentRegionAvail().x * 0.5f;
    const auto toggle = [&](bool ViewSettings::*member) {
        edit(widgets, "view", row_of(member, view_keys), view, session.origin.view);
    };
    toggle(&ViewSettings::texture);
    ImGui::SameLine(half);
    ImGui::BeginDisabled(!session.status.image_has_holes);
    toggle(&ViewSettings::cut_out);
    ImGui::EndDisabled();
    toggle(&ViewSettings::cloth);
    ImGui::SameLine(half);
    toggle(&ViewSettings::masses);
    toggle(&ViewSettings::springs);
    ImGui::SameLine(half);
    bool diagonals = session.scene.springs.diagonal_stiffness.has_value();
    if (widgets.toggle(
            "Diagonals", diagonals,
            "Diagonal springs, simulated and drawn. They resist shear and double the number of springs. Key D"))
        toggle_diagonals(session);
    toggle(&ViewSettings::forces);
}

}  // namespace

void draw_play(Session& session, Widgets& widgets) {
    choose_scene(session, widgets);
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    const float third = (ImGui::GetContentRegionAvail().x - 2.0f * spacing) / 3.0f;
    if (widgets.button("Pause", "Stops simulated time, or lets it go on. Key Space", third,
                       session.paused ? "Go on###pause" : "Pause###pause"))
        session.paused = !session.paused;
    ImGui::SameLine();
    if (widgets.button("Step", "Takes one step of the method while paused. Key .", third)) session.wishes.step = true;
    ImGui::SameLine();
    if (widgets.button("Restart", "Begins again at the scene's start, with the current settings. Key R", third))
        session.wishes.restart = true;
    ImGui::Spacing();
    choose_view(session, widgets);
}

}  // namespace drapeau
