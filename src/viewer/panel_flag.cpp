// The page on the flag: its grid, size, attachment and image.
#include "panels.hpp"

#include "setting_controls.hpp"

#include <imgui.h>

namespace drapeau {

using namespace settings;

namespace {

void choose_texture(AppState& app, PanelMemory& memory, Widgets& widgets) {
    std::vector<std::string> names{"none"};
    int index = app.texture_file.empty() ? 0 : -1;
    for (const auto& file : app.texture_files) {
        if (file == app.texture_file) index = int(names.size());
        names.push_back(file.stem().string());
    }
    const auto& recent = app.remembered.recent_images;
    const auto shown = shown_names(recent, true);
    for (std::size_t i = 0; i < recent.size(); ++i) {
        if (recent[i] == app.texture_file) index = int(names.size());
        names.push_back(shown[i]);
    }
    if (index < 0) {
        index = int(names.size());
        names.push_back(app.texture_file.filename().string());
    }
    if (widgets.choice("Image", index, names, -1,
                       "The image on the flag. An image file can also be dropped on the window.")) {
        const auto at = std::size_t(index);
        if (index == 0)
            app.commands.load_texture = "";
        else if (at <= app.texture_files.size())
            app.commands.load_texture = app.texture_files[at - 1].string();
        else if (at <= app.texture_files.size() + recent.size())
            app.commands.load_texture = recent[at - 1 - app.texture_files.size()];
    }
    if (widgets.text("Image file", memory.texture_text, "path, then Enter",
                     "Path of a PNG, JPEG, WebP, SVG, GIF or BMP file."))
        app.commands.load_texture = memory.texture_text;
}

}  // namespace

void draw_flag_page(AppState& app, PanelMemory& memory, Widgets& widgets) {
    ViewSettings& view = app.scene.view;
    const bool follows = view.texture_proportions && app.status.flag_proportions > 0.0;
    each_key(flag_keys, [&](const auto& field) {
        ImGui::BeginDisabled(follows && field.key == "width");
        edit(widgets, "flag", field, app.scene.flag, app.origin.flag);
        ImGui::EndDisabled();
    });
    choose_texture(app, memory, widgets);
    edit(widgets, "view", row_of(&ViewSettings::texture_proportions, view_keys), view, app.origin.view);
    draw_flag_gallery(app, widgets);
}

}  // namespace drapeau
