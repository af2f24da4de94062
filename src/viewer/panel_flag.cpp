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
    if (widgets.choice("Image", index, names, -1, "What is on the flag. Or drop an image on the window.")) {
        const auto at = std::size_t(index);
        if (index == 0)
            session.wishes.load_texture = "";
        else if (at <= session.texture_files.size())
            session.wishes.load_texture = session.texture_files[at - 1].string();
    }
    if (widgets.text("Image file", memory.texture_text, "path, then Enter",
                     "Any PNG, JPEG, BMP or GIF on this machine."))
        session.wishes.load_texture = memory.texture_text;
}

}  // namespace

void draw_flag_page(Session& session, PanelMemory& memory, Widgets& widgets) {
    FlagSettings& flag = session.scene.flag;
    const FlagSettings& origin = session.origin.flag;
    bool& shaped = session.scene.view.texture_proportions;
    widgets.slider("Columns", flag.columns, 1, 200, origin.columns,
                   "Masses along the fly. More show finer folds; each costs time, and every mass weighs the same.");
    widgets.slider("Rows", flag.rows, 1, 200, origin.rows,
                   "Masses along the hoist. More show finer folds and cost time.");
    ImGui::BeginDisabled(shaped && session.status.flag_proportions > 0.0);
    widgets.slider("Width", flag.width, {.low = 0.1, .high = 5.0, .format = "%.2f m"}, origin.width,
                   "Along the fly, at rest.");
    ImGui::EndDisabled();
    widgets.slider("Height", flag.height, {.low = 0.1, .high = 5.0, .format = "%.2f m"}, origin.height,
                   "Along the hoist, at rest.");
    using enum Attach;
    choose(widgets, "Held by", flag.attach, std::array{hoist, grommets, top, corner, edges, all, none}, origin.attach,
           "Which masses cannot move.");
    using enum Start;
    choose(widgets, "Starts", flag.start, std::array{flat, hanging, crumpled}, origin.start,
           "How it begins after Restart: flat, settled without wind, or crumpled.");
    widgets.slider("Prestretch", flag.prestretch,
                   {.low = 0.0, .high = 0.5, .format = "%.0f %%", .shown_per_unit = 100.0}, origin.prestretch,
                   "Starts longer than at rest by this much, after Restart.");
    choose_texture(session, memory, widgets);
    widgets.toggle("Shaped like its image", shaped, "The width follows from the height and the image's proportions.");
}

}  // namespace drapeau
