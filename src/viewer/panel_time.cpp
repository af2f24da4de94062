// The page on how time passes, and on keeping a scene.
#include "panels.hpp"

#include "setting_controls.hpp"

#include <imgui.h>

namespace drapeau {

using namespace settings;

namespace {

// What the methods are and what they cost, a line each.
std::string about_methods() {
    std::string text =
        "time.method: how a step is taken. Halving the step divides the error by 2 to the power of the method's order; "
        "every force "
        "evaluation costs about the same time.";
    for (std::size_t n = 0; n < method_count; ++n)
        with_method(Method(n), [&]<class M>(const M&) {
            text += "\n" + std::string(M::name) + ": order " + std::to_string(M::order) + ", " +
                    (M::solves ? "about " : "") + std::to_string(M::passes) +
                    (M::passes == 1 ? " evaluation" : " evaluations") + " a step";
            if constexpr (requires { M::caution; }) text += std::string("; ") + M::caution;
        });
    return text;
}

void edit_method(AppState& app, Widgets& widgets) {
    static const std::string about = about_methods();
    TimeSettings& time = app.scene.time;
    const TimeSettings& origin = app.origin.time;
    edit(widgets, row_of(&TimeSettings::method, time_keys), about, time.method, origin.method);
    edit(widgets, "time", row_of(&TimeSettings::precision, time_keys), time, origin);
    edit(widgets, "time", row_of(&TimeSettings::half_kick_start, time_keys), time, origin);
}

void edit_step(AppState& app, Widgets& widgets) {
    auto& dt = app.scene.time.dt;
    const Status& status = app.status;
    bool automatic = !dt;
    if (widgets.toggle(
            "Step chosen automatically", automatic,
            "A share of the stability limit, from 30 % where nothing damps to 75 %; lowered further while the "
            "method would create energy, and to what the tolerance asks for. Off: the step below is used.")) {
        dt = automatic ? std::nullopt : std::optional(status.dt > 0.0 ? status.dt : 1e-4);
        if (dt) app.scene.time.tolerance.reset();
    }
    if (!dt) {
        edit(widgets, "time", row_of(&TimeSettings::tolerance, time_keys), app.scene.time, app.origin.time);
        return;
    }
    const auto row = row_of(&TimeSettings::dt, time_keys);
    edit(widgets, row, tip_of("time", row.key, row.about), *dt, app.origin.time.dt.value_or(*dt));
}

}  // namespace

void draw_time_page(AppState& app, PanelMemory& memory, Widgets& widgets) {
    draw_travel(app, widgets);
    edit_method(app, widgets);
    edit_step(app, widgets);
    if (app.scene.view.reference &&
        widgets.button("Compare anew", "The reference begins again, from where the flag is now.", -1.0f))
        app.commands.restart_reference = true;
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Spacing();
    if (widgets.text("Scene file", memory.scene_text, "path or name, then Enter",
                     "Opens a scene file, or a scene by its name."))
        app.commands.load_scene = memory.scene_text;
    if (widgets.text("Save as", memory.save_text, "my-flag.toml", "The file for all current settings; Enter saves."))
        app.commands.save_scene = memory.save_text;
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2.0f;
    if (widgets.button("Save scene", "Saves all current settings in the file named above.", half))
        app.commands.save_scene = memory.save_text;
    ImGui::SameLine();
    if (widgets.button("Reset all", "Sets everything back to the scene's values.", half)) app.scene = app.origin;
    if (widgets.button("Screenshot", "Saves a PNG in the working directory. Key P", half))
        app.commands.screenshot = true;
    ImGui::SameLine();
    if (widgets.button("Film", "Makes a film of the flag, from here on. Key Ctrl R", half, "Film..."))
        app.film.open = true;
    if (widgets.button("Save shape",
                       "Saves the flag's shape as OBJ in the working directory, with its normals and "
                       "where the image lies on it.",
                       half))
        app.commands.save_shape = true;
    ImGui::SameLine();
    if (widgets.button("Keys", "The list of keys. Key F1", half)) app.help_shown = !app.help_shown;
    if (widgets.button("Find", "Finds an action, a setting, a scene or a flag by its name. Key Ctrl P", half))
        app.palette = {.open = true};
    ImGui::SameLine();
    if (widgets.button("Reset to defaults", "Forgets what the window remembers between runs. Asks before it does.",
                       half))
        ask_to_forget(app);
}

}  // namespace drapeau
