// The film dialog, and how far a film under way is.
#include "panels.hpp"

#include "box_room.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace drapeau {

namespace {

constexpr float usual_font = 15.0f;  // window units; sizes below are for text of this size

constexpr ImGuiWindowFlags box_flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_NoFocusOnAppearing;

void claim_window(AppState& app) {
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    app.claimed.push_back({low.x, low.y, low.x + size.x, low.y + size.y});
}

/// At the foot of the view, so that the flag stays in sight.
float place_at_foot(const AppState& app, float wanted_width, float rows) {
    const float scale = ImGui::GetFontSize() / usual_font;
    const Area view = room_for_box(app, (wanted_width + 24.0f) * scale);
    const float width = std::min(wanted_width * scale, view.width() - 24.0f * scale);
    const float height = rows * ImGui::GetFrameHeightWithSpacing() + 2.0f * ImGui::GetStyle().WindowPadding.y -
                         ImGui::GetStyle().ItemSpacing.y;
    ImGui::SetNextWindowPos({(view.x0 + view.x1) / 2.0f, view.y1 - 14.0f * scale}, ImGuiCond_Always, {0.5f, 1.0f});
    ImGui::SetNextWindowSize({width, std::min(height, view.height() - 28.0f * scale)});
    return width;
}

std::vector<std::string> size_names() {
    std::vector<std::string> names;
    for (const glm::ivec2& size : film_sizes)
        names.push_back(size.x == 0 ? "the window's" : fmt::format("{} x {}", size.x, size.y));
    return names;
}

std::vector<std::string> rate_names() {
    std::vector<std::string> names;
    for (const double rate : film_rates) names.push_back(fmt::format("{} frames/s", rate));
    return names;
}

}  // namespace

void draw_film(AppState& app, Widgets& widgets) {
    FilmDesk& desk = app.film;
    if (!desk.open) return;
    place_at_foot(app, 420.0f, 6.0f);
    ImGui::Begin("film", nullptr, box_flags);
    bool start = widgets.text("Film file", desk.file, "my-flag.mp4",
                              "The ending chooses the format: mp4, mov, mkv, webm, gif or pictures, frames-%04d.png. "
                              "Enter begins.");
    widgets.choice("Film size", desk.size, size_names(), FilmDesk::usual_size,
                   "In pixels, whatever the window's. A larger one takes longer to make.");
    widgets.choice("Frame rate", desk.rate, rate_names(), FilmDesk::usual_rate,
                   "More frames show fast motion more smoothly. A gif takes 25 or 50.");
    widgets.slider("Length", desk.seconds, {.low = 0.1, .high = 120.0, .logarithmic = true, .format = "%.1f s"},
                   FilmDesk::usual_seconds, "Simulated time that the film shows.");
    widgets.toggle("Loop", desk.loop,
                   "The film's last second passes into its beginning, so that it can be repeated without a jump. It "
                   "begins a second from now.");
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2.0f;
    ImGui::BeginDisabled(desk.under_way);
    start |= widgets.button("Record",
                            "Makes the film from here on, of a copy of the flag; this one flies on. What is "
                            "seen, and from where, is as it is now. No panel is in it.",
                            half);
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (widgets.button("Close film", "Key Esc or Ctrl R", half, "Close")) desk.open = false;
    claim_window(app);
    ImGui::End();
    if (start && !desk.under_way) app.commands.start_film = true;
}

void draw_film_progress(AppState& app, Widgets& widgets) {
    const FilmDesk& desk = app.film;
    if (!desk.under_way || desk.open) return;
    place_at_foot(app, 460.0f, 1.0f);
    ImGui::Begin("film progress", nullptr, box_flags);
    const float button = ImGui::CalcTextSize("Stop film").x + 2.0f * ImGui::GetStyle().FramePadding.x;
    const float bar = ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x;
    const double share = desk.frames > 0 ? double(desk.written) / double(desk.frames) : 0.0;
    const std::string text = desk.frames > 0
                                 ? fmt::format("{}: {} of {} frames", printable(desk.name), desk.written, desk.frames)
                                 : "The film begins";
    ImGui::ProgressBar(float(share), {bar, ImGui::GetFrameHeight()}, "");
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax(),
                 extent = ImGui::CalcTextSize(text.c_str());
    ImGui::GetWindowDrawList()->AddText({(low.x + high.x - extent.x) / 2.0f, (low.y + high.y - extent.y) / 2.0f},
                                        ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    widgets.note("Reading: Film", text);
    ImGui::SameLine();
    if (widgets.button("Stop film", "Ends it; no file is left.")) app.commands.stop_film = true;
    claim_window(app);
    ImGui::End();
}

}  // namespace drapeau
