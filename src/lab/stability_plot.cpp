#include "stability_plot.hpp"

#include "gnuplot.hpp"
#include "io/text.hpp"
#include "scene/file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace drapeau::lab {

namespace {

bool is_drawn(double seconds) {
    return std::isfinite(seconds) && seconds > 0.0;
}

/// One panel: limits over stiffness, or over damping.
struct Panel {
    struct Point {
        double x, measured, theory;  // N/m or N s/m; s
    };
    std::map<Method, std::vector<Point>> points;
};

Panel panel_of(const StabilityMap& map, bool of_damping) {
    Panel panel;
    for (std::size_t n = 0; n < map.points.size(); ++n) {
        const StabilityLimit& limit = map.limits[n];
        if (map.points[n].is_of_damping != of_damping || (!is_drawn(limit.measured) && !is_drawn(limit.theory)))
            continue;
        panel.points[limit.method].push_back(
            {of_damping ? limit.damping : limit.stiffness, limit.measured, limit.theory});
    }
    for (auto& [method, list] : panel.points)
        std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
    return panel;
}

/// "implicit-euler and xpbd": those that every step is stable for, whatever the cloth.
std::string unlimited_methods(const StabilityMap& map) {
    std::vector<std::string> names;
    for (const StabilityLimit& limit : map.limits) {
        const std::string name(name_of(limit.method));
        if (std::isinf(limit.measured) && std::find(names.begin(), names.end(), name) == names.end())
            names.push_back(name);
    }
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : &name == &names.back() ? " and " : ", ") + name;
    return text;
}

std::string block(const std::string& name, const std::vector<Panel::Point>& points, double Panel::Point::*value) {
    std::string lines = "$" + name + " << END\n";
    for (const Panel::Point& point : points)
        if (is_drawn(point.*value)) lines += plot_number(point.x) + " " + plot_number(point.*value) + "\n";
    return lines + "END\n";
}

bool has_some(const std::vector<Panel::Point>& points, double Panel::Point::*value) {
    return std::any_of(points.begin(), points.end(), [&](const auto& point) { return is_drawn(point.*value); });
}

/// From none on, with a few round numbers: many would not fit beside each other.
std::string damping_axis(const Panel& panel) {
    double most = 0.0;
    for (const auto& [method, points] : panel.points)
        for (const Panel::Point& point : points) most = std::max(most, point.x);
    if (!(most > 0.0)) return "set xrange [-1:1]\nset xtics 1\n";
    const double decade = std::pow(10.0, std::floor(std::log10(0.3 * most)));
    const double times = 0.3 * most / decade, step = decade * (times < 2.0 ? 1.0 : times < 5.0 ? 2.0 : 5.0);
    return fmt::format("set xrange [{}:{}]\nset xtics {}\n", plot_number(-0.05 * most), plot_number(1.05 * most),
                       plot_number(step));
}

/// The plot command of a panel and, before it, its data. Its key names the methods of the other panel too.
std::string panel_script(const Panel& panel, const std::string& prefix, const Panel& other) {
    std::string data, command;
    const auto add = [&](const std::string& curve) { command += (command.empty() ? "plot " : ", \\\n  ") + curve; };
    for (const auto& [method, points] : panel.points) {
        const std::string name = prefix + std::to_string(static_cast<int>(method));
        const MethodStyle style = style_of(method);
        if (has_some(points, &Panel::Point::theory)) {
            data += block(name + "theory", points, &Panel::Point::theory);
            add(fmt::format("${}theory using 1:2 with lines lw 1.5 lc rgb '{}' notitle", name, style.colour));
        }
        if (has_some(points, &Panel::Point::measured)) {
            data += block(name + "measured", points, &Panel::Point::measured);
            add(fmt::format("${}measured using 1:2 with points pt {} ps 1.2 lc rgb '{}' title {}", name, style.filled,
                            style.colour, plot_text(std::string(name_of(method)))));
        }
    }
    for (const auto& [method, points] : other.points)
        if (!panel.points.contains(method))
            add(fmt::format("NaN with points pt {} ps 1.2 lc rgb '{}' title {}", style_of(method).filled,
                            style_of(method).colour, plot_text(std::string(name_of(method)))));
    add(fmt::format("NaN with points pt 7 lc rgb '{}' title 'measured'", plot_grey));
    add(fmt::format("NaN with lines lw 1.5 lc rgb '{}' title 'theory, at the same values'", plot_grey));
    return data + command + "\n";
}

}  // namespace

std::string stability_script(const StabilityMap& map) {
    const std::string name = one_line(map.scene.name, 60), unlimited = unlimited_methods(map);
    const Panel stiffness = panel_of(map, false), damping = panel_of(map, true);
    const bool both = !stiffness.points.empty() && !damping.points.empty();
    const Springs springs = model_of(map.scene).springs;
    std::string script =
        "set grid lc rgb '#e4e4e4' lt 1\nset border 3\nset tics nomirror\nset logscale y\n"
        "set format y '%.0s %cs'\nset ylabel 'largest stable step'\n";
    std::string title = name + ": the largest stable step of the cloth at rest";
    if (!unlimited.empty()) title += "\n" + unlimited + ": every step is stable";
    if (both)
        script += "set multiplot layout 1,2 title " + plot_text(title) + " noenhanced\n";
    else
        script += "set title " + plot_text(title) + " noenhanced\n";
    script += "set key bottom left Left reverse samplen 2 noenhanced\n";
    if (!stiffness.points.empty())
        script += fmt::format("set logscale x\nset format x '%g'\nset xlabel 'stiffness in N/m, damping {}'\n",
                              quantity(springs.damping.value_or(0.0), "N·s/m")) +
                  panel_script(stiffness, "k", damping);
    if (!damping.points.empty())
        script += fmt::format("unset logscale x\nset format x '%g'\nset xlabel 'damping in N·s/m, stiffness {}'\n",
                              quantity(springs.stiffness, "N/m")) +
                  damping_axis(damping) + (both ? "unset key\n" : "") + panel_script(damping, "c", stiffness);
    if (stiffness.points.empty() && damping.points.empty())
        script +=
            "unset tics\nunset border\nunset ylabel\nset label 'no method has a limit' at graph 0.5, graph 0.5 center\n"
            "set xrange [0:1]\nset yrange [1:10]\nplot NaN notitle\n";
    return script + (both ? "unset multiplot\n" : "");
}

}  // namespace drapeau::lab
