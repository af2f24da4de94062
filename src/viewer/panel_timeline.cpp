// The panel's rows of time: back and forth through the moments that are kept, and how fast time passes.
#include "panels.hpp"

#include "io/text.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

namespace drapeau {

namespace {

void draw_scrubber(AppState& app, Widgets& widgets) {
    const Playback& play = app.playback;
    const std::string kept = fmt::format("kept: {:.{}f} s", play.to - play.from, play.to - play.from < 9.95 ? 1 : 0);
    const float room = ImGui::CalcTextSize("kept: 888 s").x + ImGui::GetStyle().ItemSpacing.x;
    double shown = play.shown.value_or(play.to);
    const bool some = play.to > play.from;
    const double end = some ? play.to : play.from + 1.0;
    const std::string tip = fmt::format(
        "The flight as far as it is kept: {} moments in {:.0f} of {:.0f} MiB, the last seconds frame by frame and "
        "older "
        "ones sparser, at most {:.0f} min. Drag to look at any; Pause (Go on) or a setting lets the flight go on from "
        "there, to the bit as it did before, and drops what came after. A moment belongs to the settings that made it: "
        "the panel shows them while it is looked at. Restart begins a new timeline.",
        play.moments, double(play.bytes) / 1048576.0, double(Timeline::usual_budget) / 1048576.0,
        Timeline::longest / 60.0);
    ImGui::BeginDisabled(!some);
    const SliderScale scale{.low = play.from, .high = end, .format = "%.2f s", .at_once = true, .widest = "888.88 s"};
    const float width = ImGui::GetContentRegionAvail().x - room;
    if (widgets.bar("Timeline", shown, scale, width, tip.c_str(), fmt::format("{:.4f}", shown)))
        app.commands.travel.to = shown;
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", kept.c_str());
    widgets.note("Reading: Kept", kept);
    widgets.tip(tip.c_str());
}

std::string speed_text(const AppState& app) {
    const Status& s = app.status;
    const std::string wanted = fmt::format("wanted {}\xc3\x97", app.playback.speed().name);
    if (app.playback.backwards) return wanted + ", backwards";
    if (!s.clock || app.paused || s.stands() || s.real_time_factor <= 0.0) return wanted;
    return wanted + ", achieved " + rounded(s.real_time_factor, 2) + "\xc3\x97";
}

void draw_speed(AppState& app, Widgets& widgets) {
    const float side = ImGui::GetFrameHeight(), spacing = ImGui::GetStyle().ItemSpacing.x;
    const float width = ImGui::GetContentRegionAvail().x - 2.0f * (side + spacing);
    if (widgets.button("Slower", "Time passes more slowly, down to 1/100. Key [ or / of the keypad", side, "-"))
        app.playback.faster(-1);
    ImGui::SameLine();
    ImGui::PushID("speed");
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
    if (ImGui::Button((speed_text(app) + "###speed").c_str(), {width, 0.0f})) app.playback.rung = real_time;
    ImGui::PopStyleColor();
    ImGui::PopID();
    widgets.note("Speed", speed_text(app));
    widgets.tip(
        "Simulated seconds in a second of the clock: wanted, and achieved over the last second. A computer that "
        "cannot keep up shows less; no step is skipped. Slow motion shows the run's own steps, and straight "
        "lines between them. A click goes back to real time. Key 1");
    ImGui::SameLine();
    if (widgets.button("Faster", "Time passes faster, up to 4 times. Key ] or * of the keypad", side, "+"))
        app.playback.faster(1);
}

}  // namespace

void draw_travel(AppState& app, Widgets& widgets) {
    Travel& travel = app.commands.travel;
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    constexpr const char* names[] = {"Reverse", "-1 s", "-frame", "+frame", "+1 s"};
    float room = ImGui::GetContentRegionAvail().x - 4.0f * spacing;
    for (const char* name : names) room -= ImGui::CalcTextSize(name).x;
    // Each with as much room beside its name.
    const auto width = [&](int n) { return ImGui::CalcTextSize(names[n]).x + room / 5.0f; };
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.0f, ImGui::GetStyle().FramePadding.y});
    if (widgets.button("Play backwards",
                       "Lets what is kept pass backwards, at the speed above; Pause ends it. Key Backspace", width(0),
                       names[0]))
        travel.backwards = true;
    ImGui::SameLine();
    if (widgets.button("Second back", "Looks at the moment kept a second earlier. Key Page Up", width(1), names[1]))
        travel.seconds = -1;
    ImGui::SameLine();
    if (widgets.button("Frame back", "Looks at the moment kept a frame, 1/60 s, earlier. Key ,", width(2), names[2]))
        travel.frames = -1;
    ImGui::SameLine();
    if (widgets.button("Frame", "One frame on: 1/60 s of simulated time, then a pause. Key N", width(3), names[3]))
        travel.frames = 1;
    ImGui::SameLine();
    if (widgets.button("Second", "One second of simulated time on, then a pause. Key Page Down", width(4), names[4]))
        travel.seconds = 1;
    ImGui::PopStyleVar();
}

void draw_timeline(AppState& app, Widgets& widgets) {
    draw_scrubber(app, widgets);
    draw_speed(app, widgets);
}

}  // namespace drapeau
