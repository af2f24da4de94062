#include "converge_conclusion.hpp"

#include "io/text.hpp"
#include "report_text.hpp"
#include "scene/file.hpp"

#include <fmt/format.h>

#include <cmath>

namespace drapeau::lab {

namespace {

std::string order_text(double order) {
    return std::isfinite(order) ? fmt::format("{:.2f}", order) : "-";
}

/// " The ratios disagree (orders 0.80, then 2.10): finer grids may show another.", or nothing.
std::string disagreement_text(const GridConvergence& grids) {
    if (!grids.do_orders_disagree()) return "";
    std::string orders;
    for (const double order : grids.orders()) orders += (orders.empty() ? "" : ", then ") + order_text(order);
    return " The grids' ratios disagree (orders " + orders + "): finer ones may show another order.";
}

constexpr const char* limit_text = "the stretch limit moves masses after each step, by how much depends on the cells";

/// "26 1/s on 45 x 30, 51 1/s on 89 x 59"
std::string rates_text(const GridConvergence& grids) {
    std::string text;
    for (const GridLevel& level : grids.levels)
        if (level.growth && level.growth->is_seen())
            text += fmt::format("{}{} 1/s on {} x {}", text.empty() ? "" : ", ", rounded(level.growth->rate, 2),
                                level.columns, level.rows);
    return text;
}

std::string verdict_text(const GridConvergence& grids) {
    using Verdict = GridConvergence::Verdict;
    if (grids.levels.empty()) return "No grid was measured: --budget does not suffice for one.";
    const GridLevel& finest = grids.levels.back();
    const auto converging = [&] {
        return fmt::format(
            "Halving the cells of {} x {} again would change positions by about {}, and {} x {} is within about {} of "
            "the limit",
            finest.columns, finest.rows, metres(grids.next_difference()), grids.levels.front().columns,
            grids.levels.front().rows, metres(grids.error_of_coarsest()));
    };
    switch (grids.verdict) {
        case Verdict::converges:
            return fmt::format("Finer grids converge, at order {}. {}.", order_text(grids.order()), converging());
        case Verdict::by_borders:
            return fmt::format(
                "Finer grids converge, at order {} only: borders are as heavy and as stiff as the inside (as light as "
                "their share of the cloth they would differ by {} instead of {}){}. {}.",
                order_text(grids.order()), metres(grids.light_difference()), metres(finest.difference),
                grids.is_limit_active() ? std::string("; and ") + limit_text : "", converging());
        case Verdict::by_limit:
            return fmt::format("Finer grids converge, at order {} only: {}. {}.", order_text(grids.order()), limit_text,
                               converging());
        case Verdict::slowly:
            return fmt::format(
                "Finer grids converge, at order {} only: as where a sudden start or corners make fronts "
                "sharper than the cells{}. {}.",
                order_text(grids.order()),
                grids.is_border_apt ? " (borders are held or light: they are not the cause)"
                : std::isfinite(grids.light_order())
                    ? fmt::format(" (borders are not the cause: light ones give order {})",
                                  order_text(grids.light_order()))
                    : "",
                converging());
        case Verdict::no_matter:
            return "The grid makes no difference: every grid moves alike but for rounding.";
        case Verdict::compression:
            return fmt::format(
                "Finer grids do not converge here: {} % of the springs are compressed, and folds are as narrow "
                "as the cells allow (wavelength {} cells on {} x {}, {} on {} x {}). {}, so the grid decides where "
                "the cloth folds: compare statistics, not positions.",
                rounded(100.0 * finest.compressed_share, 2), rounded(grids.levels.front().fold_cells, 2),
                grids.levels.front().columns, grids.levels.front().rows, rounded(finest.fold_cells, 2), finest.columns,
                finest.rows, grids.is_bent ? "Such cells are too coarse for this bending" : "Nothing resists bending");
        case Verdict::chaos:
            return fmt::format(
                "Finer grids do not converge over this time: the motion is chaotic ({}). Compare fewer --seconds, or "
                "statistics.",
                rates_text(grids));
        case Verdict::too_coarse:
            return grids.is_limit_active()
                       ? fmt::format("These grids do not converge: {}. Measure without the limit, or finer grids.",
                                     limit_text)
                       : "These grids do not converge yet, and neither compression nor chaos is the cause: they are "
                         "too coarse for what moves. Measure finer ones (--levels, --budget).";
        case Verdict::unknown:
            return grids.left_out.empty()
                       ? "No order of grids: it takes three, and finer ones of this cloth are impossible."
                       : "No order of grids: it takes three, and --budget suffices for fewer.";
    }
    return "";
}

std::string on_grids(const GridConvergence& grids) {
    return verdict_text(grids) + disagreement_text(grids);
}

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t n = 0; n < names.size(); ++n)
        text += (n == 0 ? "" : n + 1 == names.size() ? " and " : ", ") + names[n];
    return text;
}

std::string on_steps(const std::vector<MethodConvergence>& methods) {
    const auto those = [&](const auto& wanted) {
        std::vector<std::string> names;
        for (const MethodConvergence& method : methods)
            if (wanted(verdict_on(method))) names.emplace_back(name_of(method.method));
        return names;
    };
    std::string text;
    const auto say = [&](const std::vector<std::string>& names, const std::string& what) {
        if (!names.empty()) text += (text.empty() ? "" : "; ") + joined(names) + ": " + what;
    };
    const auto is = [](const char* name) { return [name](const std::string& verdict) { return verdict == name; }; };
    say(those(is("asymptotic")), "the order declared");
    say(those(is("pre-asymptotic")), "not yet the order declared at the steps that fit the budget");
    say(those(is("chaos")), "no order at the steps that fit the budget, for the motion is chaotic");
    say(those(is("limit")), "a lower order, for the stretch limit moves masses after each step");
    say(those(is("rounding")), "exact but for rounding");
    say(those(is("diverged")), "diverged");
    say(those(is("left out")), "not measured, --budget does not suffice");
    return "Steps: " + text + ".";
}

}  // namespace

const char* name_of(StepRung::Flag flag) {
    constexpr const char* names[] = {"first", "asymptotic", "pre-asymptotic", "chaos", "limit", "rounding", "diverged"};
    return names[static_cast<int>(flag)];
}

std::string verdict_on(const MethodConvergence& method) {
    if (const StepRung* best = method.best()) return name_of(best->flag);
    if (!method.rungs.empty() && method.rungs.back().flag == StepRung::Flag::rounding) return "rounding";
    return method.rungs.empty() || method.rungs.back().flag != StepRung::Flag::diverged ? "left out" : "diverged";
}

std::string conclusion(const ConvergeFindings& found) {
    return on_grids(found.grids) + "\n" + on_steps(found.steps);
}

}  // namespace drapeau::lab
