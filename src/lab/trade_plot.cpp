#include "trade_plot.hpp"

#include "gnuplot.hpp"
#include "io/text.hpp"
#include "scene/file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

namespace drapeau::lab {

namespace {

constexpr double real_time = 1000.0;  // ms of processor time a simulated second

double seconds(double milliseconds) {
    return 1e-3 * milliseconds;
}

bool is_drawn(const Measured& point) {
    return point.is_measured() && point.error.at_end > 0.0 && point.ms_per_second > 0.0;
}

struct Frame {
    double left = INFINITY, right = 0.0;  // m
    double bottom = INFINITY, top = 0.0;  // ms/s
    double edge = 0.0;                    // m, where diverged settings stand
    bool has_diverged = false;

    void take_cost(double cost) {
        if (!(cost > 0.0)) return;
        bottom = std::min(bottom, cost);
        top = std::max(top, cost);
    }
};

Frame frame_of(const TradeFindings& findings) {
    constexpr double margin = 1.6;
    Frame frame;
    for (const Measured& point : findings.points) {
        if (is_drawn(point)) {
            frame.left = std::min(frame.left, point.error.at_end);
            frame.right = std::max(frame.right, point.error.at_end);
            frame.take_cost(point.ms_per_second);
        } else if (point.outcome == Measured::Outcome::diverged) {
            const double cost = expected_cost(findings.points, point);
            frame.has_diverged = frame.has_diverged || cost > 0.0;
            frame.take_cost(cost);
        }
    }
    if (!(frame.right > 0.0)) frame.left = 1e-6, frame.right = 1e-3;
    if (!(frame.top > 0.0)) frame.bottom = 0.1 * real_time, frame.top = real_time;
    const double decades = std::log10(frame.right / frame.left);
    frame.left /= margin;
    // Whole decades: their ends have labels.
    frame.bottom = std::pow(10.0, std::floor(std::log10(frame.bottom)));
    frame.top = std::pow(10.0, std::ceil(std::log10(frame.top)));
    frame.right *= margin;
    frame.edge = frame.right * std::pow(10.0, std::max(0.15, 0.03 * decades));
    if (frame.has_diverged) frame.right = frame.edge * std::pow(10.0, std::max(0.15, 0.03 * decades));
    return frame;
}

std::string block(const std::string& name, const std::string& lines) {
    return "$" + name + " << END\n" + lines + "END\n";
}

/// Curves of a plot command, and the data they show.
struct Curves {
    std::string data, commands;
    int count = 0;

    void add(const std::string& lines, const std::string& how) {
        const std::string name = "curve" + std::to_string(count++);
        data += block(name, lines);
        commands += (commands.empty() ? "plot $" : ", \\\n  $") + name + " using 1:2 " + how;
    }
    void add_key(const std::string& how) { commands += (commands.empty() ? "plot NaN " : ", \\\n  NaN ") + how; }
};

std::string line_of(double error, double cost) {
    return plot_number(error) + " " + plot_number(seconds(cost)) + "\n";
}

/// Settings of one method, precision and model, by their steps: so that a line through them says what halving does.
void add_settings(Curves& curves, const TradeFindings& findings) {
    std::map<std::tuple<Method, Precision, std::size_t>, std::vector<const Measured*>> groups;
    for (const Measured& point : findings.points)
        if (is_drawn(point)) groups[{point.point.method, point.point.precision, point.point.variant}].push_back(&point);
    for (auto& [kind, points] : groups) {
        const auto& [method, precision, variant] = kind;
        std::sort(points.begin(), points.end(),
                  [](const Measured* a, const Measured* b) { return a->point.steps_a_batch < b->point.steps_a_batch; });
        std::string lines;
        for (const Measured* point : points) lines += line_of(point->error.at_end, point->ms_per_second);
        const MethodStyle style = style_of(method);
        const bool is_double = precision == Precision::double_precision;
        curves.add(lines,
                   fmt::format("with linespoints lw 1 dt {} lc rgb '{}' pt {} ps {} notitle", is_double ? "1" : "3",
                               style.colour, is_double ? style.filled : style.hollow, variant == 0 ? 1.1 : 0.6));
    }
}

void add_diverged(Curves& curves, const TradeFindings& findings, const Frame& frame) {
    std::map<Method, std::string> lines;
    for (const Measured& point : findings.points)
        if (point.outcome == Measured::Outcome::diverged)
            if (const double cost = expected_cost(findings.points, point); cost > 0.0)
                lines[point.point.method] += line_of(frame.edge, cost);
    for (const auto& [method, text] : lines)
        curves.add(text, fmt::format("with points pt 2 lw 2 ps 1.1 lc rgb '{}' notitle", style_of(method).colour));
}

/// What a tolerance costs at least: from each setting of the front to the next that is less exact, its cost.
void add_front(Curves& curves, const TradeFindings& findings) {
    std::string lines;
    for (auto n = findings.front.rbegin(); n != findings.front.rend(); ++n)
        if (const Measured& point = findings.points[*n]; is_drawn(point))
            lines += line_of(point.error.at_end, point.ms_per_second);
    if (!lines.empty()) curves.add(lines, "with steps lw 5 lc rgb '#cccccc' title 'efficient front'");
}

void add_keys(Curves& curves, const TradeFindings& findings, bool has_diverged) {
    std::map<Method, bool> methods;
    for (const Measured& point : findings.points)
        if (is_drawn(point)) methods[point.point.method] = true;
    for (const auto& [method, seen] : methods)
        curves.add_key(fmt::format("with linespoints lw 1 lc rgb '{}' pt {} ps 1.1 title {}", style_of(method).colour,
                                   style_of(method).filled, plot_text(std::string(name_of(method)))));
    curves.add_key(fmt::format("with linespoints lw 1 dt 1 lc rgb '{}' pt 7 title 'double'", plot_grey));
    curves.add_key(fmt::format("with linespoints lw 1 dt 3 lc rgb '{}' pt 6 title 'float'", plot_grey));
    if (has_diverged)
        curves.add_key(
            fmt::format("with points pt 2 lw 2 lc rgb '{}' title 'diverged (its steps would cost that)'", plot_grey));
}

}  // namespace

std::string work_precision_script(const TradeSweep& sweep, const TradeFindings& findings) {
    const Footing& ground = sweep.grounds().front();
    const Frame frame = frame_of(findings);
    std::string title = fmt::format("{}: cost over error, {} compared", one_line(ground.variant.scene.name, 60),
                                    quantity(ground.stretch.seconds(), "s"));
    if (sweep.variants().size() > 1) title += " (small markers: other models)";
    std::string script = fmt::format(
        "set title {} noenhanced\n"
        "set xlabel \"error at the end (rms over the masses)\\n \"\n"
        "set ylabel 'processor time for a simulated second'\n"
        "set logscale xy\nset format x '%.0s %cm'\nset format y '%.0s %cs'\n"
        "set xrange [{}:{}]\nset yrange [{}:{}]\n"
        "set grid lc rgb '#e4e4e4' lt 1\nset border 3\nset tics nomirror\n"
        "set key outside bottom center horizontal Left reverse samplen 2 spacing 1.2 maxrows 3 noenhanced\n",
        plot_text(title), plot_number(frame.left), plot_number(frame.right), plot_number(seconds(frame.bottom)),
        plot_number(seconds(frame.top)));
    if (frame.bottom < real_time && real_time <= frame.top)
        script += fmt::format(
            "set arrow from graph 0, first {0} to graph 1, first {0} nohead lc rgb '{1}' lw 1.5 dt 2\n"
            "set label 'real time' at graph 0.01, first {0} offset 0,0.5 tc rgb '{1}'\n",
            plot_number(seconds(real_time)), plot_black);
    const double resolved = 10.0 * ground.reference.error();
    if (frame.left < resolved && resolved < frame.right)
        script += fmt::format(
            "set arrow from {0}, graph 0 to {0}, graph 1 nohead lc rgb '{1}' lw 1 dt 4\n"
            "set label 'left of this: not resolved' at {0}, graph 0.02 rotate by 90 offset -1.1,0 tc rgb '{1}'\n",
            plot_number(resolved), plot_grey);
    Curves curves;
    add_front(curves, findings);
    add_settings(curves, findings);
    add_diverged(curves, findings, frame);
    add_keys(curves, findings, frame.has_diverged);
    return curves.data + script + curves.commands + "\n";
}

}  // namespace drapeau::lab
