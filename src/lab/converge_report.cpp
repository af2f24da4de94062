#include "converge_report.hpp"

#include "converge_conclusion.hpp"
#include "io/text.hpp"
#include "progress.hpp"
#include "report_text.hpp"
#include "scene/file.hpp"
#include "text_table.hpp"

#include "drapeau/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace drapeau::lab {

namespace {

using Flag = StepRung::Flag;

std::string order_text(double order) {
    return std::isfinite(order) ? fmt::format("{:.2f}", order) : "-";
}
std::string per_cent(double share) {
    return rounded(100.0 * share, 2) + " %";
}

std::string flag_text(const StepRung& rung, int declared) {
    std::string text;
    switch (rung.flag) {
        case Flag::first:
            break;
        case Flag::asymptotic:
            text = fmt::format("order {}, as declared", declared);
            break;
        case Flag::pre_asymptotic:
            text = "not yet: the step is too large for its order";
            break;
        case Flag::chaos:
            text = "chaos: runs at such steps part, each its own way";
            break;
        case Flag::limit:
            text = "the stretch limit lowers the order";
            break;
        case Flag::rounding:
            text = "rounding";
            break;
        case Flag::diverged:
            text = "diverged";
            break;
    }
    if (rung.is_below_resolution) text += std::string(text.empty() ? "" : "; ") + "error below resolution";
    return text;
}

std::string cell_of(const ConvergeRequest& request, const GridLevel& level) {
    const Grid grid = spread(level.columns, level.rows, request.scene.flag.width, request.scene.flag.height);
    const double x = grid.columns > 1 ? grid.pitch_x : 0.0, y = grid.rows > 1 ? grid.pitch_y : 0.0;
    if (x == 0.0 || y == 0.0 || std::abs(x - y) < 1e-3 * x) return quantity(std::max(x, y), "m");
    return quantity(x, "m") + " x " + quantity(y, "m");
}

std::string flag_of(const GridLevel& level, const GridConvergence& grids) {
    if (!std::isfinite(level.order)) return "first";
    if (level.is_converging()) return grids.does_converge() ? "converging" : "unsteady";
    if (level.is_folded_by_compression()) return "compression";
    return level.growth && level.growth->is_seen() ? "chaos" : "too coarse";
}

std::string flag_text(const GridLevel& level, const GridConvergence& grids) {
    const std::string flag = flag_of(level, grids);
    if (flag == "first") return "";
    if (flag == "compression") return "not converging: compressed, folds as fine as the grid";
    if (flag == "chaos") return "not converging: neighbouring motions part";
    if (flag == "unsteady") return "smaller, but not steadily";
    return flag == "converging" ? flag : "not converging yet";
}

constexpr const char* grid_verdicts[] = {"converges",
                                         "converges, borders lower the order",
                                         "converges, the stretch limit lowers the order",
                                         "converges slowly",
                                         "no matter",
                                         "compression",
                                         "chaos",
                                         "too coarse",
                                         "too few grids"};

}  // namespace

std::string compared_text(const ConvergeRequest& request, const ConvergeFindings& found) {
    const std::string start = "its own start (" + std::string(name_of(request.scene.flag.start)) + ")";
    std::string text =
        fmt::format("{}: {} compared, {}\n", request.scene.name, quantity(found.seconds, "s"),
                    request.settle > 0.0 ? "after " + quantity(request.settle, "s") + " to swing in from " + start
                                         : "from " + start + " on");
    text += fmt::format("reference: rk4 in double at {}, {}\n",
                        quantity(batch_seconds / static_cast<double>(found.reference.rk4_steps), "s"),
                        known_text(found.reference.error(), found.is_beyond_horizon()));
    if (found.growth.is_seen())
        text += fmt::format("chaos: what is apart becomes tenfold every {}: 1 nm becomes 1 mm in {}{}\n",
                            quantity(std::log(10.0) / found.growth.rate, "s", 2), quantity(found.horizon(), "s", 2),
                            found.is_shortened ? "; half of that is compared (--seconds overrides)" : "");
    else
        text +=
            fmt::format("chaos: none seen: what was 1 nm apart is {} apart at the end\n", metres(found.growth.last));
    return text;
}

std::string steps_table(const ConvergeFindings& found) {
    std::vector<Row> rows{{"method", "step", "difference", "error", "order", ""}};
    std::string left_out;
    for (const MethodConvergence& method : found.steps) {
        const std::string name(name_of(method.method));
        for (const StepRung& rung : method.rungs)
            rows.push_back({name, quantity(rung.dt(), "s"), metres(rung.difference), metres(rung.error),
                            order_text(rung.order), flag_text(rung, method.declared)});
        if (!method.left_out.empty()) left_out += "left out: " + name + ": " + method.left_out + "\n";
    }
    return "steps, each half of the one before; difference: from that one; error: from the reference\n" +
           aligned(rows) + left_out;
}

std::string grids_table(const ConvergeRequest& request, const ConvergeFindings& found) {
    const GridConvergence& grids = found.grids;
    std::vector<Row> rows{{"grid", "cell", "difference", "order", "compressed", "folds", "1 nm becomes", ""}};
    for (const GridLevel& level : grids.levels) {
        const std::string folds =
            std::isfinite(level.fold_cells)
                ? fmt::format("{} ({} cells)", quantity(level.fold_wavelength, "m", 2), rounded(level.fold_cells, 2))
                : "flat";
        rows.push_back({fmt::format("{} x {}", level.columns, level.rows), cell_of(request, level),
                        metres(level.difference), order_text(level.order), per_cent(level.compressed_share), folds,
                        level.growth ? metres(level.growth->last) : "-", flag_text(level, grids)});
    }
    std::string text =
        "grids, each with half the cells of the one before, from one smooth start; difference: from that one\n" +
        aligned(rows);
    if (std::isfinite(grids.error_in_time()))
        text += fmt::format("(flown by rk4; on the coarsest grid half the step changes {})\n",
                            metres(grids.error_in_time()));
    for (const auto& [columns, rows_left, seconds] : grids.left_out)
        text += fmt::format("left out: {} x {}: it takes about {}, more than --budget leaves\n", columns, rows_left,
                            duration(seconds));
    return text;
}

nlohmann::ordered_json as_json(const ConvergeRequest& request, const ConvergeFindings& found) {
    nlohmann::ordered_json json{{"scene", request.scene.name},
                                {"settle_s", request.settle},
                                {"seconds", found.seconds},
                                {"growth_per_s", found.growth.is_seen() ? found.growth.rate : NAN},
                                {"horizon_s", found.horizon()},
                                {"reference_error_m", found.is_beyond_horizon() ? NAN : found.reference.error()}};
    auto& methods = json["methods"] = nlohmann::ordered_json::array();
    auto& steps = json["steps"] = nlohmann::ordered_json::array();
    for (const MethodConvergence& method : found.steps) {
        methods.push_back({{"method", name_of(method.method)},
                           {"declared_order", method.declared},
                           {"order", method.best() ? method.best()->order : NAN},
                           {"flag", verdict_on(method)},
                           {"left_out", method.left_out}});
        for (const StepRung& rung : method.rungs)
            steps.push_back({{"method", name_of(method.method)},
                             {"dt", rung.dt()},
                             {"difference_m", rung.difference},
                             {"error_m", rung.error},
                             {"order", rung.order},
                             {"alignment", rung.alignment},
                             {"below_resolution", rung.is_below_resolution},
                             {"flag", name_of(rung.flag)}});
    }
    auto& grids = json["grids"] = nlohmann::ordered_json::array();
    for (const GridLevel& level : found.grids.levels)
        grids.push_back({{"columns", level.columns},
                         {"rows", level.rows},
                         {"difference_m", level.difference},
                         {"order", level.order},
                         {"compressed_share", level.compressed_share},
                         {"fold_wavelength_m", level.fold_wavelength},
                         {"fold_cells", level.fold_cells},
                         {"growth_per_s", level.growth && level.growth->is_seen() ? level.growth->rate : NAN},
                         {"flag", flag_of(level, found.grids)}});
    auto& left_out = json["left_out_grids"] = nlohmann::ordered_json::array();
    for (const auto& [columns, rows, seconds] : found.grids.left_out)
        left_out.push_back({{"columns", columns}, {"rows", rows}, {"flight_s", seconds}});
    json["light_borders"] = {{"order", found.grids.light_order()}, {"difference_m", found.grids.light_difference()}};
    json["grids_verdict"] = grid_verdicts[static_cast<int>(found.grids.verdict)];
    json["orders_disagree"] = found.grids.do_orders_disagree();
    json["conclusion"] = conclusion(found);
    return json;
}

}  // namespace drapeau::lab
