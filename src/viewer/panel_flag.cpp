// The page on the flag: its grid, size, attachment and image.
#include "panels.hpp"

#include "scene_file.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>

namespace drapeau {

namespace {

template <class Value, std::size_t count>
bool choose(Widgets& widgets, const char* label, Value& value, const std::array<Value, count>& values, Value origin,
            const char* tip) {
    std::vector<std::string> names;
    for (const Value v : values) names.emplace_back(name_of(v));
    const auto place = [&](Value v) { return int(std::find(values.begin(), values.end(), v) - values.begin()); };
    int index = place(value);
    if (!widgets.choice(label, index, names, place(origin), tip)) return false;
    value = values[std::size_t(index)];
    return true;
}

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
    FlagSettings& flag = session.scene.flag;
    const FlagSettings& origin = session.origin.flag;
    bool& shaped = session.scene.view.texture_proportions;
    widgets.slider(
        "Columns", flag.columns, 1, 200, origin.columns,
        "Masses along the fly. More columns show finer folds, take more time and make the flag heavier: every mass "
        "weighs the same.");
    widgets.slider("Rows", flag.rows, 1, 200, origin.rows, "Masses along the hoist. More rows do the same.");
    ImGui::BeginDisabled(shaped && session.status.flag_proportions > 0.0);
    widgets.slider("Width", flag.width, {.low = 0.1, .high = 5.0, .format = "%.2f m"}, origin.width,
                   "Length along the fly at rest. A wider flag has longer springs, not more of them.");
    ImGui::EndDisabled();
    widgets.slider("Height", flag.height, {.low = 0.1, .high = 5.0, .format = "%.2f m"}, origin.height,
                   "Length along the hoist at rest. A higher flag has longer springs, not more of them.");
    using enum Attach;
    choose(widgets, "Held by", flag.attach, std::array{hoist, grommets, top, corner, sides, edges, all, none},
           origin.attach, "Which masses are held in place.");
    using enum Start;
    choose(widgets, "Starts", flag.start, std::array{flat, hanging, crumpled}, origin.start,
           "How the flag begins after Restart: flat, hanging (at rest without wind) or crumpled.");
    widgets.slider(
        "Prestretch", flag.prestretch, {.low = 0.0, .high = 50.0, .format = "%.0f %%", .shown_per_unit = 100.0},
        origin.prestretch,
        "The flag begins longer than at rest by this share, after Restart. More gives it more elastic energy.");
    double disturbance = flag.disturbance.value_or(0.0);
    if (widgets.slider("Disturbance", disturbance,
                       {.low = 0.0, .high = 50.0, .format = "%.3g mm", .shown_per_unit = 1000.0},
                       origin.disturbance.value_or(0.0),
                       "Ripples that a flat flag begins with, after Restart. Without any (0) it stays in its plane for "
                       "ever, unless something pushes it out."))
        flag.disturbance = disturbance;
    choose_texture(session, memory, widgets);
    widgets.toggle("Shaped like its image", shaped, "The width follows from the height and the image's proportions.");
}

}  // namespace drapeau
