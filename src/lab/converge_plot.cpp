#include "converge_plot.hpp"

#include "gnuplot.hpp"
#include "io/text.hpp"
#include "scene/file.hpp"

#include <fmt/format.h>

#include <cmath>

namespace drapeau::lab {

namespace {

bool is_drawn(double value) {
    return std::isfinite(value) && value > 0.0;
}

/// Lines between the differences of each method, the order it comes to in the key.
std::string steps_panel(const ConvergeFindings& found) {
    std::string data, command;
    for (const MethodConvergence& method : found.steps) {
        std::string lines;
        for (const StepRung& rung : method.rungs)
            if (is_drawn(rung.difference)) lines += plot_number(rung.dt()) + " " + plot_number(rung.difference) + "\n";
        if (lines.empty()) continue;
        const std::string name = "s" + std::to_string(static_cast<int>(method.method));
        data += "$" + name + " << END\n" + lines + "END\n";
        const StepRung* best = method.best();
        std::string title(name_of(method.method));
        title += best && std::isfinite(best->order) ? fmt::format(", order {:.2f}", best->order) : ", no order";
        const MethodStyle style = style_of(method.method);
        command += (command.empty() ? "plot " : ", \\\n  ") +
                   fmt::format("${} using 1:2 with linespoints lw 1.5 pt {} ps 1.2 lc rgb '{}' title {}", name,
                               style.filled, style.colour, plot_text(title));
    }
    if (command.empty()) command = "set xrange [1e-6:1]\nset yrange [1e-6:1]\nplot NaN title 'no method was flown'";
    return data +
           "set format x '%.0s %cs'\nset xlabel 'step'\nset ylabel 'difference from the run at twice the step'\n" +
           command + "\n";
}

/// The differences of grids, and from the first of them on what order 2 would be.
std::string grids_panel(const ConvergeRequest& request, const ConvergeFindings& found) {
    const FlagSettings& flag = request.scene.flag;
    std::string lines;
    std::string cells;
    double first_cell = NAN, first = NAN, last_cell = NAN;
    for (const GridLevel& level : found.grids.levels) {
        if (!is_drawn(level.difference)) continue;
        const double cell =
            level.columns > 1 ? flag.width / (level.columns - 1) : flag.height / std::max(1, level.rows - 1);
        if (!std::isfinite(first)) first = level.difference, first_cell = cell;
        last_cell = cell;
        cells += (cells.empty() ? "" : ", ") + plot_text(quantity(cell, "m")) + " " + plot_number(cell);
        lines += plot_number(cell) + " " + plot_number(level.difference) + "\n";
    }
    std::string script = "set xlabel 'cell'\nset ylabel 'difference from the grid before'\n";
    if (lines.empty())
        return script + "set xrange [1e-3:1]\nset yrange [1e-6:1]\nplot NaN title 'no difference was measured'\n";
    const double order = found.grids.order();
    const std::string title = std::isfinite(order) ? fmt::format("grids, order {:.2f}", order) : "grids";
    const double at_last = first * std::pow(last_cell / first_cell, 2.0);
    script += "$g << END\n" + lines + "END\n$two << END\n" + plot_number(first_cell) + " " + plot_number(first) + "\n" +
              plot_number(last_cell) + " " + plot_number(at_last) + "\nEND\n";
    script += "set xtics (" + cells + ")\n";
    script += fmt::format("set xrange [{}:{}]\nset yrange [{}:*]\n", plot_number(0.7 * last_cell),
                          plot_number(1.4 * first_cell), plot_number(0.3 * at_last));
    return script + fmt::format(
                        "plot $g using 1:2 with linespoints lw 1.5 pt 7 ps 1.2 lc rgb '{}' title {}, \\\n"
                        "  $two using 1:2 with lines dt 2 lw 1.5 lc rgb '{}' title 'order 2'\n",
                        plot_black, plot_text(title), plot_grey);
}

}  // namespace

std::string converge_script(const ConvergeRequest& request, const ConvergeFindings& found) {
    const std::string title =
        one_line(request.scene.name, 60) + ": differences (rms) over " + quantity(found.seconds, "s");
    return "set multiplot layout 1,2 title " + plot_text(title) +
           " noenhanced\nset grid lc rgb '#e4e4e4' lt 1\nset border 3\nset tics nomirror\nset logscale xy\n"
           "set format y '%.0s %cm'\nset key bottom right samplen 2 noenhanced\n" +
           steps_panel(found) + "set autoscale\n" + grids_panel(request, found) + "unset multiplot\n";
}

}  // namespace drapeau::lab
