#include "trade_chart.hpp"

#include "io/text.hpp"
#include "measure/setting_choice.hpp"
#include "measure/trade_analysis.hpp"
#include "scene/file.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace drapeau {

namespace {

constexpr double real_time = 1000.0;  // ms of processor time a simulated second
constexpr ImU32 real_time_color = IM_COL32(255, 133, 117, 190);
constexpr float least_decades = 1.0f;

/// Told apart by who sees colours differently: Okabe and Ito's, without the darkest.
ImU32 color_of(Method method) {
    constexpr std::array<ImU32, 7> colors{IM_COL32(230, 159, 0, 255),  IM_COL32(86, 180, 233, 255),
                                          IM_COL32(0, 188, 135, 255),  IM_COL32(240, 228, 66, 255),
                                          IM_COL32(98, 148, 255, 255), IM_COL32(233, 106, 28, 255),
                                          IM_COL32(214, 139, 179, 255)};
    return colors[static_cast<std::size_t>(method) % colors.size()];
}

/// A logarithmic axis.
struct Axis {
    double low = INFINITY, high = 0.0;
    float from = 0.0f, to = 0.0f;  // window units

    void take(double value) {
        if (!(value > 0.0) || !std::isfinite(value)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    void widen() {
        if (!(high > 0.0)) low = high = 1.0;
        constexpr double margin = 1.5;
        low /= margin, high *= margin;
        const double missing = least_decades - std::log10(high / low);
        if (missing > 0.0) low *= std::pow(10.0, -0.5 * missing), high *= std::pow(10.0, 0.5 * missing);
    }
    float at(double value) const {
        return from + (to - from) * float(std::log(std::clamp(value, low, high) / low) / std::log(high / low));
    }
    bool has(double value) const { return value >= low && value <= high; }
    /// Whole decades, every so many that there are few.
    std::vector<double> ticks() const {
        std::vector<double> all;
        const int first = int(std::ceil(std::log10(low))), last = int(std::floor(std::log10(high)));
        const int every = std::max(1, (last - first + 3) / 4);
        for (int decade = first; decade <= last; ++decade)
            if (decade % every == 0) all.push_back(std::pow(10.0, decade));
        return all;
    }
};

std::string tick_text(double value) {
    return value < 0.999e-3 || value > 1.001e4 ? fmt::format("1e{}", std::lround(std::log10(value))) : shortest(value);
}

struct Chart {
    const MeasuredTrade& trade;
    Axis error, cost;  // mm/s, ms/s
    ImDrawList* list = ImGui::GetWindowDrawList();

    double rate(const Measured& point) const { return 1e3 * error_rate(point, trade.seconds); }
    double cost_of(const Measured& point) const {
        return point.is_measured() ? point.ms_per_second : expected_cost(trade.points, point);
    }
    bool is_drawn(const Measured& point) const {
        const bool is_kind = point.is_measured() || point.outcome == Measured::Outcome::diverged;
        return is_kind && cost_of(point) > 0.0;
    }
    /// What diverged stands at the right edge.
    ImVec2 place(const Measured& point) const {
        return {point.is_measured() ? error.at(rate(point)) : error.to, cost.at(cost_of(point))};
    }
};

void draw_axes(const Chart& chart) {
    const float line = ImGui::GetTextLineHeight();
    const ImU32 faint = ImGui::GetColorU32(ImGuiCol_Border), text = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    const auto& [trade, error, cost, list] = chart;
    list->AddRect({error.from, cost.to}, {error.to, cost.from}, faint);
    for (const double tick : error.ticks()) {
        const float x = error.at(tick);
        const std::string label = tick_text(tick);
        list->AddLine({x, cost.to}, {x, cost.from}, faint);
        list->AddText({x - 0.5f * ImGui::CalcTextSize(label.c_str()).x, cost.from + 2.0f}, text, label.c_str());
    }
    for (const double tick : cost.ticks()) {
        const float y = cost.at(tick);
        const std::string label = tick_text(tick);
        list->AddLine({error.from, y}, {error.to, y}, faint);
        list->AddText({error.from - 4.0f - ImGui::CalcTextSize(label.c_str()).x, y - 0.5f * line}, text, label.c_str());
    }
}

void draw_lines(const Chart& chart, const TradeMark& now) {
    const auto& [trade, error, cost, list] = chart;
    if (cost.has(real_time)) {
        const float y = cost.at(real_time);
        list->AddLine({error.from, y}, {error.to, y}, real_time_color);
    }
    if (now.accuracy && error.has(1e3 * *now.accuracy)) {
        const float x = error.at(1e3 * *now.accuracy);
        list->AddLine({x, cost.to}, {x, cost.from}, IM_COL32(255, 255, 255, 150));
    }
    std::vector<ImVec2> front;
    for (const std::size_t n : trade.front) front.push_back(chart.place(trade.points[n]));
    list->AddPolyline(front.data(), int(front.size()), IM_COL32(255, 255, 255, 110), 0, 2.0f);
}

void draw_point(const Chart& chart, const Measured& point, float radius) {
    const ImVec2 at = chart.place(point);
    const ImU32 color = color_of(point.point.method);
    if (!point.is_measured()) {
        const float r = 0.8f * radius;
        chart.list->AddLine({at.x - r, at.y - r}, {at.x + r, at.y + r}, color, 1.5f);
        chart.list->AddLine({at.x - r, at.y + r}, {at.x + r, at.y - r}, color, 1.5f);
    } else if (point.point.precision == Precision::single_precision) {
        chart.list->AddCircleFilled(at, radius, color, 16);
    } else {
        chart.list->AddCircle(at, radius, color, 16, 1.6f);
    }
}

/// Over the points, which it may stand among.
void name_real_time(const Chart& chart) {
    if (!chart.cost.has(real_time)) return;
    const char* name = "real time";
    const ImVec2 size = ImGui::CalcTextSize(name);
    const ImVec2 at{chart.error.from + 4.0f, chart.cost.at(real_time) - 0.5f * size.y};
    chart.list->AddRectFilled({at.x - 2.0f, at.y}, {at.x + size.x + 2.0f, at.y + size.y},
                              ImGui::GetColorU32(ImGuiCol_WindowBg));
    chart.list->AddText(at, real_time_color, name);
}

void draw_mark(const Chart& chart, const TradeMark& now, float radius) {
    const ImU32 white = IM_COL32(255, 255, 255, 255);
    if (now.place && chart.is_drawn(chart.trade.points[*now.place]))
        chart.list->AddCircle(chart.place(chart.trade.points[*now.place]), 2.2f * radius, white, 20, 2.0f);
    if (!(now.rate > 0.0) || !(now.ms_per_second > 0.0)) return;
    const ImVec2 at{chart.error.at(1e3 * now.rate), chart.cost.at(now.ms_per_second)};
    const float r = 2.0f * radius;
    chart.list->AddLine({at.x - r, at.y}, {at.x + r, at.y}, white, 2.0f);
    chart.list->AddLine({at.x, at.y - r}, {at.x, at.y + r}, white, 2.0f);
}

std::string about(const Chart& chart, const Measured& point) {
    std::string text = setting_text(point.point) + " steps\n";
    if (!point.is_measured()) return text + "diverges: " + one_line(point.remark, 200);
    text += fmt::format("{} mm/s for {} of processor time a second", rounded(chart.rate(point), 3),
                        quantity(1e-3 * point.ms_per_second, "s", 2));
    if (point.is_below_resolution()) text += "\nless than what the reference resolves";
    return text + "\nClick to step the flag so.";
}

/// The point nearest to the mouse, near enough to be meant.
std::optional<std::size_t> point_under_mouse(const Chart& chart, float reach) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    std::optional<std::size_t> found;
    float nearest = reach * reach;
    for (std::size_t n = 0; n < chart.trade.points.size(); ++n) {
        if (!chart.is_drawn(chart.trade.points[n])) continue;
        const ImVec2 at = chart.place(chart.trade.points[n]);
        const float square = (at.x - mouse.x) * (at.x - mouse.x) + (at.y - mouse.y) * (at.y - mouse.y);
        if (!(square < nearest)) continue;
        nearest = square;
        found = n;
    }
    return found;
}

/// The methods' colours, two in a row.
void draw_key(const MeasuredTrade& trade) {
    const float line = ImGui::GetTextLineHeight(), radius = 0.28f * line;
    const float half = 0.5f * ImGui::GetContentRegionAvail().x;
    int drawn = 0;
    for (std::size_t m = 0; m < method_count; ++m) {
        const auto method = static_cast<Method>(m);
        const bool is_there = std::any_of(trade.points.begin(), trade.points.end(), [&](const Measured& point) {
            return point.point.method == method && point.outcome != Measured::Outcome::left_out;
        });
        if (!is_there) continue;
        if (drawn++ % 2 == 1) ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + half);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::GetWindowDrawList()->AddCircleFilled({at.x + radius, at.y + 0.5f * line}, radius, color_of(method), 16);
        ImGui::Dummy({2.0f * radius, line});
        ImGui::SameLine();
        ImGui::TextDisabled("%s", std::string(name_of(method)).c_str());
    }
}

}  // namespace

std::optional<std::size_t> draw_trade_chart(const MeasuredTrade& trade, const TradeMark& now, Widgets& widgets) {
    const float line = ImGui::GetTextLineHeight(), radius = 0.26f * line;
    const float left = ImGui::CalcTextSize("100000").x, width = ImGui::GetContentRegionAvail().x;
    const float height = 11.0f * line;
    Chart chart{trade, {}, {}};
    for (const Measured& point : trade.points) {
        if (point.is_measured()) chart.error.take(chart.rate(point));
        if (chart.is_drawn(point)) chart.cost.take(chart.cost_of(point));
    }
    chart.error.take(1e3 * now.accuracy.value_or(0.0));
    chart.error.widen();
    chart.cost.widen();

    ImGui::TextDisabled("processor time, ms a simulated second");
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton("trade chart", {width, height + 2.2f * line});
    const bool hovered = ImGui::IsItemHovered();
    widgets.note("Trade chart", std::to_string(trade.points.size()));
    chart.error.from = corner.x + left, chart.error.to = corner.x + width - 1.5f * radius;
    chart.cost.from = corner.y + height, chart.cost.to = corner.y;
    draw_axes(chart);
    const char* title = "error in a tenth of a second, mm/s";
    chart.list->AddText({chart.error.to - ImGui::CalcTextSize(title).x, corner.y + height + 1.1f * line},
                        ImGui::GetColorU32(ImGuiCol_TextDisabled), title);
    draw_lines(chart, now);
    for (const Measured& point : trade.points)
        if (chart.is_drawn(point)) draw_point(chart, point, radius);
    name_real_time(chart);
    draw_mark(chart, now, radius);
    for (const std::size_t n : trade.front) {
        const ImVec2 at = chart.place(trade.points[n]);
        widgets.note_place(("Setting: " + setting_text(trade.points[n].point)).c_str(), at.x, at.y, radius);
    }
    const auto under = hovered ? point_under_mouse(chart, 2.5f * radius) : std::nullopt;
    if (under) draw_point(chart, trade.points[*under], 1.6f * radius);
    widgets.tip(under ? about(chart, trade.points[*under]).c_str()
                      : "Every setting measured: filled circles in float, rings in double, crosses diverge. The line "
                        "joins those that no other beats in both; a white ring is around the one in use, a white cross "
                        "at what the flag's readings say now.");
    draw_key(trade);
    return clicked && under && trade.points[*under].is_measured() ? under : std::nullopt;
}

}  // namespace drapeau
