// Plots: two in a row, what the run's numbers were over the last ten seconds, with a mark at the moment that is looked
// at.
#include "panels.hpp"

#include "io/text.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace drapeau {

namespace {

constexpr double span = 10.0;         // s
constexpr float lines_a_plot = 2.5f;  // its height, in lines of text
constexpr int plots = 5;

struct Plot {
    const char* name;
    const char* unit;
    double Sample::*value;
    double shown_per_unit;
    std::optional<double> from, to;  // in its unit: the range covers them
    const char* tip;
};

constexpr Plot all_plots[plots] = {
    {"Energy",
     "J",
     &Sample::energy,
     1.0,
     {},
     {},
     "Total energy: kinetic, elastic, and of height (zero at the flag's top)."},
    {"Max stretch", "%", &Sample::stretch, 100.0, 0.0, {}, "How much longer the longest spring is than at rest."},
    {"Tip height",
     "m",
     &Sample::height,
     1.0,
     {},
     {},
     "Height of the middle of the fly end, or of a chain's end, above the flag's top corner at the pole."},
    {"Error",
     "mm/s",
     &Sample::error,
     1000.0,
     0.0,
     {},
     "How far the masses stray from the exact motion in a second of simulated time, measured once a second."},
    {"Step of limit", "%", &Sample::step, 100.0, 0.0, 100.0,
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

Range range_of(const std::vector<Point>& points, const Plot& plot) {
    const auto less = [](const Point& a, const Point& b) { return a.value < b.value; };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    Range range{std::min(low->value, plot.from.value_or(low->value)),
                std::max(high->value, plot.to.value_or(high->value))};
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

/// The sample of a time, of some.
const Sample& sample_at(const std::vector<Sample>& samples, double time) {
    const auto later = std::upper_bound(samples.begin(), samples.end(), time + 1e-6,
                                        [](double t, const Sample& sample) { return t < sample.time; });
    return later == samples.begin() ? samples.front() : *std::prev(later);
}

void draw_lines(const std::vector<Point>& points, const Range& range, double from, double now, ImVec2 low,
                ImVec2 high) {
    ImDrawList* const list = ImGui::GetWindowDrawList();
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

/// The range, small, at the left of the lines. How much of the width it takes.
float write_range(const Range& range, ImVec2 low, ImVec2 high) {
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float scale = 0.72f, size = scale * ImGui::GetFontSize(), gap = 3.0f;
    const ImU32 faint = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    const std::string top = rounded(range.high, 3), bottom = rounded(range.low, 3);
    list->AddText(ImGui::GetFont(), size, {low.x + gap, low.y}, faint, top.c_str());
    list->AddText(ImGui::GetFont(), size, {low.x + gap, high.y - size}, faint, bottom.c_str());
    return scale * ImGui::CalcTextSize("-0.0000").x + gap;
}

void draw_plot(const Plot& plot, const Playback& play, double now, float width, Widgets& widgets) {
    const float line = ImGui::GetTextLineHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 low{corner.x, corner.y + line}, high{corner.x + width, corner.y + lines_a_plot * line};
    ImGui::Dummy({width, lines_a_plot * line});
    const std::vector<Point> points = points_of(play.samples, plot);
    const bool known = !points.empty() && std::isfinite(sample_at(play.samples, now).*plot.value);
    const std::string value = known ? rounded(value_at(points, now), 3) + " " + plot.unit : std::string("\xe2\x80\x93");
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddText(corner, ImGui::GetColorU32(ImGuiCol_TextDisabled), plot.name);
    list->AddText({high.x - ImGui::CalcTextSize(value.c_str()).x, corner.y}, ImGui::GetColorU32(ImGuiCol_Text),
                  value.c_str());
    list->AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), 3.0f);
    std::string tip = plot.tip;
    if (points.empty()) {
        tip += "\nNot known yet, or there is none.";
    } else {
        const Range range = range_of(points, plot);
        const float left = low.x + write_range(range, low, high);
        draw_lines(points, range, std::max(play.from, play.samples.back().time - span), now, {left, low.y}, high);
        tip += fmt::format("\nTen seconds of simulated time, from {} {} at the bottom to {} {} at the top.",
                           rounded(range.low, 3), plot.unit, rounded(range.high, 3), plot.unit);
    }
    widgets.note((std::string("Plot: ") + plot.name).c_str(), value);
    widgets.tip(tip.c_str());
}

}  // namespace

float plots_height(const AppState& app) {
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    const float plot = lines_a_plot * ImGui::GetTextLineHeight() + spacing;
    return ImGui::GetTextLineHeightWithSpacing() + (app.playback.plots ? float((plots + 1) / 2) * plot : 0.0f);
}

void draw_plots(AppState& app, Widgets& widgets) {
    Playback& play = app.playback;
    const bool were_open = play.plots;
    ImGui::SetNextItemOpen(were_open);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x, 0.0f});
    play.plots = ImGui::CollapsingHeader("Plots");
    ImGui::PopStyleVar();
    widgets.note("Plots", play.plots ? "1" : "0");
    widgets.tip(
        "Energy, stretch, the tip's height, the error and the step over the last ten seconds of simulated time.");
    // What was clicked may be elsewhere in the next frame, for the panel scrolls as a whole where it has no room.
    if (play.plots && !were_open) app.mark = Mark{.control = "Plots", .framed = false};
    if (!play.plots || play.samples.empty()) return;
    const double now = play.shown.value_or(app.status.time);
    const float gap = 2.0f * ImGui::GetStyle().ItemSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - gap) / 2.0f;
    for (int n = 0; n < plots; ++n) {
        if (n % 2 == 1) ImGui::SameLine(0.0f, gap);
        draw_plot(all_plots[n], play, now, width, widgets);
    }
}

}  // namespace drapeau
