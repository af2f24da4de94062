// Plots: what the run's numbers were over the last ten seconds, with a mark at the moment that is looked at.
#include "panels.hpp"

#include "io/text.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace drapeau {

namespace {

constexpr double span = 10.0;         // s
constexpr float lines_a_plot = 2.6f;  // its height, in lines of text
constexpr int plots = 5;

struct Plot {
    const char* name;
    const char* unit;
    double Sample::*value;
    double shown_per_unit;
    bool from_zero;
    const char* tip;
};

constexpr Plot all_plots[plots] = {
    {"Energy", "J", &Sample::energy, 1.0, false,
     "Total energy: kinetic, elastic, and of height (zero at the flag's top)."},
    {"Greatest stretch", "%", &Sample::stretch, 100.0, true, "How much longer the longest spring is than at rest."},
    {"Tip height", "m", &Sample::height, 1.0, false,
     "Height of the middle of the fly end, or of a chain's end, above the flag's top corner at the pole."},
    {"Error", "mm/s", &Sample::error, 1000.0, true,
     "How far the masses stray from the exact motion in a second of simulated time, measured once a second."},
    {"Step of limit", "%", &Sample::step, 100.0, true,
     "The step as a share of the largest that is stable for the springs as they are here and now."},
};

struct Point {
    double time, value;
};

/// The values that are known, each at the time it was measured.
std::vector<Point> points_of(const std::vector<Sample>& samples, const Plot& plot) {
    std::vector<Point> points;
    for (const Sample& sample : samples) {
        const double value = plot.shown_per_unit * sample.*plot.value;
        const bool is_reading = plot.value == &Sample::energy || plot.value == &Sample::stretch;
        const double time = is_reading ? sample.read_at : sample.time;
        if (std::isfinite(value) && (points.empty() || time > points.back().time)) points.push_back({time, value});
    }
    return points;
}

struct Range {
    double low = 0.0, high = 1.0;
};

Range range_of(const std::vector<Point>& points, bool from_zero) {
    const auto less = [](const Point& a, const Point& b) { return a.value < b.value; };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    Range range{from_zero ? std::min(0.0, low->value) : low->value, high->value};
    const double least = std::max(1e-3 * std::abs(range.high), 1e-9);  // noise of a still flag is no motion
    if (range.high - range.low < least) range = {range.low - least, range.high + least};
    return range;
}

/// The value at a time: the last that was known then.
double value_at(const std::vector<Point>& points, double time) {
    const auto later = std::upper_bound(points.begin(), points.end(), time + 1e-6,
                                        [](double t, const Point& point) { return t < point.time; });
    return later == points.begin() ? points.front().value : std::prev(later)->value;
}

void draw_lines(const std::vector<Point>& points, const Range& range, double from, double now, ImVec2 low,
                ImVec2 high) {
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), 3.0f);
    list->PushClipRect(low, high, true);
    const auto across = [&](double time) { return low.x + float((time - from) / span) * (high.x - low.x); };
    const auto up = [&](double value) {
        const float share = float((value - range.low) / (range.high - range.low));
        return high.y - 2.0f - share * (high.y - low.y - 4.0f);
    };
    std::vector<ImVec2> line;
    for (const Point& point : points) line.push_back({across(point.time), up(point.value)});
    if (line.size() > 1)
        list->AddPolyline(line.data(), int(line.size()), ImGui::GetColorU32(ImGuiCol_PlotLines), 0, 1.4f);
    const float x = across(now), y = up(value_at(points, now));
    list->AddLine({x, low.y}, {x, high.y}, ImGui::GetColorU32(ImGuiCol_TextDisabled), 1.0f);
    list->AddCircleFilled({x, y}, 2.8f, ImGui::GetColorU32(ImGuiCol_PlotHistogram));
    list->PopClipRect();
}

void draw_plot(const Plot& plot, const Playback& play, double now, Widgets& widgets) {
    const float width = ImGui::GetContentRegionAvail().x, line = ImGui::GetTextLineHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy({width, lines_a_plot * line});
    const std::vector<Point> points = points_of(play.samples, plot);
    const std::string label = std::string("Plot: ") + plot.name;
    const std::string none = "\xe2\x80\x93";
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const ImU32 bright = ImGui::GetColorU32(ImGuiCol_Text), faint = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    const auto right = [&](const std::string& text, ImU32 color) {
        list->AddText({corner.x + width - ImGui::CalcTextSize(text.c_str()).x, corner.y}, color, text.c_str());
    };
    list->AddText(corner, faint, plot.name);
    const ImVec2 low{corner.x, corner.y + line + 1.0f}, high{corner.x + width, corner.y + lines_a_plot * line - 1.0f};
    if (points.empty()) {
        list->AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), 3.0f);
        right(none, faint);
        widgets.note(label.c_str(), none);
        return widgets.tip(plot.tip);
    }
    const Range range = range_of(points, plot.from_zero);
    const std::string value = rounded(value_at(points, now), 3) + " " + plot.unit;
    const std::string limits = rounded(range.low, 3) + " to " + rounded(range.high, 3);
    right(value, bright);
    const float middle = corner.x + (width - ImGui::CalcTextSize(limits.c_str()).x) * 0.55f;
    list->AddText({middle, corner.y}, faint, limits.c_str());
    draw_lines(points, range, std::max(play.from, play.samples.back().time - span), now, low, high);
    widgets.note(label.c_str(), value);
    const std::string tip = fmt::format("{}\nTen seconds of simulated time; from {} at the bottom to {} {} at the top.",
                                        plot.tip, rounded(range.low, 3), rounded(range.high, 3), plot.unit);
    widgets.tip(tip.c_str());
}

}  // namespace

float plots_height(const AppState& app) {
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    const float plot = lines_a_plot * ImGui::GetTextLineHeight() + spacing;
    return ImGui::GetFrameHeight() + spacing + (app.playback.plots ? float(plots) * plot : 0.0f);
}

void draw_plots(AppState& app, Widgets& widgets) {
    Playback& play = app.playback;
    ImGui::SetNextItemOpen(play.plots);
    play.plots = ImGui::CollapsingHeader("Plots");
    widgets.note("Plots", play.plots ? "1" : "0");
    widgets.tip(
        "Energy, stretch, the tip's height, the error and the step over the last ten seconds of simulated time.");
    if (!play.plots || play.samples.empty()) return;
    const double now = play.shown.value_or(app.status.time);
    for (const Plot& plot : all_plots) draw_plot(plot, play, now, widgets);
}

}  // namespace drapeau
