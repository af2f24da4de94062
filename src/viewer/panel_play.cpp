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
    const auto& recent = app.remembered.recent_scenes;
    const auto shipped = app.scene_names.size();
    std::vector<std::string> names = app.scene_names;
    for (const std::string& name : shown_names(recent, false, app.scene_names)) names.push_back(name);
    const auto opened = std::find(recent.begin(), recent.end(), app.scene_file.string());
    const bool is_recent = opened != recent.end();
    auto found = std::find(names.begin(), names.end(), stem);
    if (is_recent) found = names.begin() + std::ptrdiff_t(shipped) + (opened - recent.begin());
    int index = int(found - names.begin());
    if (found == names.end()) names.push_back(stem);
    const std::string tip = "A scene sets everything at once. A scene file can also be dropped on the window.";
    if (!widgets.choice("Scene", index, names, -1, tip.c_str())) return;
    const auto at = std::size_t(index);
    app.commands.load_scene = at >= shipped && at < shipped + recent.size() ? recent[at - shipped] : names[at];
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
}

}  // namespace

void draw_play(AppState& app, Widgets& widgets) {
    choose_scene(app, widgets);
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    const float quarter = (ImGui::GetContentRegionAvail().x - 5.0f * spacing - 2.0f * ImGui::GetFrameHeight()) / 4.0f;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.0f, ImGui::GetStyle().FramePadding.y});
    if (widgets.button("Pause", "Stops simulated time, or lets it go on. Key Space", quarter,
                       app.paused && !app.playback.backwards ? "Go on###pause" : "Pause###pause"))
        app.paused = !app.paused;
    ImGui::SameLine();
    if (widgets.button(
            "Step",
            "Takes one step of the method while paused, from the moment shown: what came after it is dropped. Key .",
            quarter))
        app.commands.step = true;
    ImGui::SameLine();
    if (widgets.button("Restart", "Begins again at the scene's start, with the current settings. Key R", quarter))
        app.commands.restart = true;
    ImGui::SameLine();
    if (widgets.button("Scenes", "Shows every scene that ships, to choose from. Key O", quarter))
        app.scenes_shown = !app.scenes_shown;
    ImGui::SameLine();
    draw_history(app, widgets);
    ImGui::PopStyleVar();
    draw_timeline(app, widgets);
    ImGui::Spacing();
    choose_view(app, widgets);
}

}  // namespace drapeau
