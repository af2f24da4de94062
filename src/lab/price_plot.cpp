#include "price_plot.hpp"

#include "gnuplot.hpp"
#include "io/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace drapeau::lab {

namespace {

constexpr const char* cost_colour = "#0072B2";
constexpr const char* effect_colour = "#D55E00";

struct Bar {
    std::string name;
    double cost, faint_cost;  // per cent; faint where it is not resolved
    double effect;            // m, or standard errors where statistics are compared
};

/// The dearest first. Without those that could not be left out.
std::vector<Bar> bars_of(const PriceStudy& study, const Prices& prices) {
    std::vector<Bar> bars;
    for (const Priced& one : prices.parts) {
        if (!std::isfinite(one.cost.own.value) && !one.effect.is_measured) continue;
        std::string name = one.part.key == "flag" ? "half the grid" : one.part.key;
        for (const std::string& table : one.part.also) name += " and " + table;
        const double effect = !one.effect.is_measured     ? NAN
                              : study.is_beyond_horizon() ? standard_errors_apart(one.effect.tip, study.reference_tip())
                                                          : one.effect.apart.at_end;
        const double cost = 100.0 * one.cost.own.value;
        const bool is_resolved = one.cost.own.is_resolved();
        bars.push_back({name, is_resolved ? cost : NAN, is_resolved ? NAN : cost, effect});
    }
    const auto cost_of = [](const Bar& bar) {
        return std::isfinite(bar.cost) ? bar.cost : std::isfinite(bar.faint_cost) ? 0.0 : -INFINITY;
    };
    std::stable_sort(bars.begin(), bars.end(), [&](const Bar& a, const Bar& b) { return cost_of(a) > cost_of(b); });
    return bars;
}

/// x, y of bars that end at x.
std::string block(const std::string& name, const std::vector<Bar>& bars, double Bar::*value) {
    std::string lines = "$" + name + " << END\n";
    for (std::size_t n = 0; n < bars.size(); ++n)
        if (std::isfinite(bars[n].*value)) lines += plot_number(bars[n].*value) + " " + std::to_string(n) + "\n";
    return lines + "END\n";
}

std::string bars_curve(const std::string& name, const std::string& from, double opacity, const char* colour) {
    return fmt::format(
        "${} using 1:2:({}):1:($2-0.32):($2+0.32) with boxxyerror fs solid {} noborder lc rgb '{}' notitle", name, from,
        opacity, colour);
}

std::string cost_panel(const std::vector<Bar>& bars) {
    double least = 0.0, most = 1.0;
    for (const Bar& bar : bars)
        for (const double cost : {bar.cost, bar.faint_cost})
            if (std::isfinite(cost)) least = std::min(least, cost), most = std::max(most, cost);
    const std::string pale = "share of the processor time in %\n(pale: less than it is known to)";
    return fmt::format("set xlabel {}\nset xrange [{}:{}]\n", plot_text(pale), plot_number(1.1 * least),
                       plot_number(1.1 * most)) +
           "set arrow 1 from 0, graph 0 to 0, graph 1 nohead lc rgb '#777777'\nplot " +
           bars_curve("cost", "0", 0.85, cost_colour) + ", " + bars_curve("faint", "0", 0.3, cost_colour) +
           "\nunset arrow 1\n";
}

std::string effect_panel(const std::vector<Bar>& bars, bool of_statistics) {
    double least = INFINITY, most = 0.0;
    bool is_any = false;
    for (const Bar& bar : bars) {
        is_any = is_any || std::isfinite(bar.effect);
        if (bar.effect > 0.0) least = std::min(least, bar.effect), most = std::max(most, bar.effect);
    }
    if (most == 0.0)
        return fmt::format("set xrange [0:1]\nunset xtics\nset xlabel '{}'\nplot NaN notitle\n",
                           is_any ? "nothing changes the motion" : "no effect was measured");
    if (of_statistics)
        return fmt::format("set xlabel 'statistics apart, in standard errors'\nset xrange [0:{}]\nplot ",
                           plot_number(1.1 * most)) +
               bars_curve("effect", "0", 0.85, effect_colour) + "\n";
    const double low = std::pow(10.0, std::floor(std::log10(least)) - 1.0);
    const double between = std::pow(10.0, std::ceil(std::log10(most / low) / 4.0));  // labels, so that they fit
    return fmt::format(
               "set logscale x\nset format x '%.0s %cm'\nset xtics {}\nset xrange [{}:{}]\n"
               "set xlabel 'distance at the end (rms)'\nplot ",
               plot_number(between), plot_number(low), plot_number(2.0 * most)) +
           bars_curve("effect", plot_number(low), 0.85, effect_colour) + "\n";
}

}  // namespace

std::string price_script(const PriceStudy& study, const Prices& prices) {
    const std::vector<Bar> bars = bars_of(study, prices);
    const std::string title = one_line(study.request().scene.name, 60) +
                              ": what each part costs, and what leaving it out changes in " +
                              quantity(study.ground().stretch.seconds(), "s");
    std::string script =
        block("cost", bars, &Bar::cost) + block("faint", bars, &Bar::faint_cost) + block("effect", bars, &Bar::effect);
    script += "set multiplot title " + plot_text(title) + " noenhanced\n";
    script += fmt::format("set yrange [{}:-0.6]\nset border 3\nset tics nomirror\nset grid x lc rgb '#e4e4e4' lt 1\n",
                          plot_number(static_cast<double>(bars.size()) - 0.4));
    script += "set bmargin at screen 0.16\nset tmargin at screen 0.88\nset ytics scale 0 noenhanced (";
    for (std::size_t n = 0; n < bars.size(); ++n)
        script += (n == 0 ? "" : ", ") + plot_text(bars[n].name) + " " + std::to_string(n);
    script += ")\nset lmargin at screen 0.30\nset rmargin at screen 0.62\n" + cost_panel(bars);
    script += "unset ytics\nset lmargin at screen 0.70\nset rmargin at screen 0.97\n";
    return script + effect_panel(bars, study.is_beyond_horizon()) + "unset multiplot\n";
}

}  // namespace drapeau::lab
