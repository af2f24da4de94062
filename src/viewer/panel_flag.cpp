// The page on the flag: its grid, size, attachment and image.
#include "panels.hpp"

#include "setting_controls.hpp"

#include <imgui.h>

namespace drapeau {

using namespace settings;

namespace {

void choose_texture(Session& session, PanelMemory& memory, Widgets& widgets) {
    std::vector<std::string> names{"none"};
    int index = session.texture_file.empty() ? 0 : -1;
    for (const auto& file : session.texture_files) {
        if (file == session.texture_file) index = int(names.size());
        names.push_back(file.stem().string());
    }
    if (index < 0) {
        index = int(names.size());
        names.push_back(session.texture_file.filename().string());
    }
    if (widgets.choice("Image", index, names, -1,
                       "The image on the flag. An image file can also be dropped on the window.")) {
        const auto at = std::size_t(index);
        if (index == 0)
            session.wishes.load_texture = "";
        else if (at <= session.texture_files.size())
            session.wishes.load_texture = session.texture_files[at - 1].string();
    }
    if (widgets.text("Image file", memory.texture_text, "path, then Enter",
                     "Path of a PNG, JPEG, WebP, SVG, GIF or BMP file."))
        session.wishes.load_texture = memory.texture_text;
}

}  // namespace

void draw_flag_page(Session& session, PanelMemory& memory, Widgets& widgets) {
    ViewSettings& view = session.scene.view;
    const bool follows = view.texture_proportions && session.status.flag_proportions > 0.0;
    each_key(flag_keys, [&](const auto& field) {
        ImGui::BeginDisabled(follows && field.key == "width");
        edit(widgets, "flag", field, session.scene.flag, session.origin.flag);
        ImGui::EndDisabled();
    });
    choose_texture(session, memory, widgets);
    edit(widgets, "view", row_of(&ViewSettings::texture_proportions, view_keys), view, session.origin.view);
}

}  // namespace drapeau
