#include "trade_outcome.hpp"

#include "exit_status.hpp"
#include "gnuplot.hpp"
#include "io/error.hpp"
#include "io/terminal.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "program.hpp"
#include "report_text.hpp"
#include "saved_scene.hpp"
#include "scene/file.hpp"
#include "trade_plot.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <utility>

namespace drapeau::lab {

namespace {

std::string errors_text(const Measured& measured) {
    return measured.is_measured() ? fmt::format("{} at the end, {} over the time", quantity(measured.error.at_end, "m"),
                                                quantity(measured.error.over_time, "m"))
                                  : measured.remark;
}

/// A check whose error is within the tolerance, against a reference that is not known as well as it should be.
std::string verdict_on(const Measured& verified, double tolerance) {
    if (meets(verified, tolerance)) return "it holds";
    if (verified.is_measured() && verified.error.distance() <= tolerance)
        return "it is not known to hold, for the reference there is known to " + quantity(verified.known_to, "m") +
               " only; a larger --budget may find a better one";
    return "it does not hold";
}

/// What is said of the setting that meets the tolerance; the exit status.
int conclude(const TradeSweep& sweep, const TradeFindings& findings, std::FILE* table) {
    const double tolerance = *sweep.request().tolerance;
    const Recommendation& found = findings.recommended;
    const std::string span = quantity(sweep.grounds().front().stretch.seconds(), "s");
    const auto say = [&](const std::string& text) { std::fputs((text + "\n").c_str(), table); };
    for (const Measured& rejected : found.rejected)
        say(fmt::format("not {}: within {} in the sweep, but not in the {} that follow: {}",
                        name_of(rejected.point, sweep.variants()), quantity(tolerance, "m"), span,
                        errors_text(rejected)));
    if (!found.place) {
        const Measured* nearest = nullptr;
        for (const Measured& point : findings.points)
            if (point.is_measured() && (!nearest || point.error.distance() < nearest->error.distance()))
                nearest = &point;
        say("no setting measured is within " + quantity(tolerance, "m") +
            (nearest ? "; the nearest is " + name_of(nearest->point, sweep.variants()) + ": " + errors_text(*nearest)
                     : std::string()));
        return exit_not_met;
    }
    const Measured& best = findings.points[*found.place];
    const bool holds = meets(found.verified, tolerance);
    say(fmt::format("cheapest within {}: {}, {} of CPU a simulated second", quantity(tolerance, "m"),
                    name_of(best.point, sweep.variants()), quantity(1e-3 * best.ms_per_second, "s")));
    say("  error (rms) in the sweep:  " + errors_text(best));
    say("  in the " + span + " that follow: " + errors_text(found.confirmed));
    say("  check, in the " + span + " after that: " + errors_text(found.verified) + ": " +
        verdict_on(found.verified, tolerance));
    return holds ? exit_good : exit_not_met;
}

}  // namespace

TradeFindings findings_of(const TradeSweep& sweep, std::vector<Measured> points, const Tick& tick) {
    TradeFindings findings;
    findings.points = std::move(points);
    if (sweep.is_beyond_horizon()) return findings;
    findings.front = efficient_front(findings.points);
    findings.orders = orders_of(findings.points);
    if (sweep.request().tolerance) findings.recommended = sweep.recommend(findings.points, tick);
    return findings;
}

int report(const TradeSweep& sweep, const TradeFindings& findings, const SweepOutputs& outputs) {
    std::FILE* table = place_of_table(outputs.files());
    std::fputs((reference_text(sweep) + "\n" + points_table(sweep, findings)).c_str(), table);
    if (!sweep.is_beyond_horizon()) {
        std::fputs(("\n" + orders_text(sweep, findings)).c_str(), table);
        std::fputs(("\nthe efficient front, the cheapest first\n" + front_table(sweep, findings)).c_str(), table);
    }
    int status = exit_good;
    if (sweep.request().tolerance) {
        std::fputs("\n", table);
        status = conclude(sweep, findings, table);
    }
    if (!outputs.json.empty())
        write_text_file(outputs.json, [&](const Append& append) { append(as_json(sweep, findings).dump(2) + "\n"); });
    if (!outputs.plot.empty() && sweep.is_beyond_horizon())
        complain(program, "--plot: nothing drawn: beyond the horizon errors of positions say nothing");
    else if (!outputs.plot.empty())
        plot(outputs.plot, work_precision_script(sweep, findings));
    if (!outputs.write.empty() && status == exit_good) {
        const TradePoint& best = findings.points[*findings.recommended.place].point;
        const std::string text =
            write_scene(as_saved(best.scene_on(sweep.variants()[best.variant]), outputs.scene_file));
        write_text_file(outputs.write, [&](const Append& append) { append(text); });
    }
    return status;
}

}  // namespace drapeau::lab
