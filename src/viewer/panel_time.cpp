// The page on how time passes, and on keeping a scene.
#include "panels.hpp"

#include "scene_file.hpp"

#include <imgui.h>

namespace drapeau {

namespace {

void edit_method(Session& session, Widgets& widgets) {
    TimeSettings& time = session.scene.time;
    const std::vector<std::string> methods{std::string(name_of(Method::forward_euler)),
                                           std::string(name_of(Method::semi_implicit_euler))};
    int method = int(time.method);
    if (widgets.choice(
            "Method", method, methods, int(session.origin.time.method),
            "How positions follow from forces. Forward Euler gains energy and needs damping and small steps."))
        time.method = Method(method);
    const std::vector<std::string> precisions{std::string(name_of(Precision::single_precision)),
                                              std::string(name_of(Precision::double_precision))};
    int precision = int(time.precision);
    if (widgets.choice("Precision", precision, precisions, int(session.origin.time.precision),
                       "Doubles cost about twice the time and matter over long runs."))
        time.precision = Precision(precision);
}

void edit_step(Session& session, Widgets& widgets) {
    auto& dt = session.scene.time.dt;
    const Status& status = session.status;
    bool automatic = !dt;
    if (widgets.toggle("Step chosen automatically", automatic,
                       "The largest step the stability bound allows, with a margin of a tenth."))
        dt = automatic ? std::nullopt : std::optional(status.dt > 0.0 ? status.dt : 1e-4);
    if (!dt) return;
    const double usual =
        session.origin.time.dt.value_or(status.stability_limit > 0.0 ? 0.9 * status.stability_limit : *dt);
    widgets.slider(
        "Step size", *dt,
        {.low = 1e-5, .high = 1000.0 / 60.0, .logarithmic = true, .format = "%.4g ms", .shown_per_unit = 1000.0}, usual,
        "Wished; made a whole number of steps every 1/60 s. Larger is quicker and less exact; past the limit the run "
        "comes apart.");
}

}  // namespace

void draw_time_page(Session& session, PanelMemory& memory, Widgets& widgets) {
    edit_method(session, widgets);
    edit_step(session, widgets);
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Spacing();
    if (widgets.text("Scene file", memory.scene_text, "path or name, then Enter", "Opens a scene from a file."))
        session.wishes.load_scene = memory.scene_text;
    if (widgets.text("Save as", memory.save_text, "my-flag.toml", "Everything set here, as a scene file; Enter saves."))
        session.wishes.save_scene = memory.save_text;
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2.0f;
    if (widgets.button("Save scene", "Writes the file named above.", half))
        session.wishes.save_scene = memory.save_text;
    ImGui::SameLine();
    if (widgets.button("All back", "Every setting back to what the scene says.", half)) session.scene = session.origin;
    if (widgets.button("Screenshot", "A PNG in the working directory. Key P", half)) session.wishes.screenshot = true;
    ImGui::SameLine();
    if (widgets.button("Keys", "The list of keys. Key F1", half)) session.help_shown = !session.help_shown;
}

}  // namespace drapeau
