#include "run_results.hpp"

#include "io/text.hpp"
#include "scene/file.hpp"

#include <fmt/format.h>

#include <cmath>

namespace drapeau::lab {

namespace {

std::string with_unit(double value, const std::string& unit) {
    return fmt::format("{} {}", rounded(value, 4), unit);
}

/// What the step computes, in words: nothing that is not listed costs anything.
std::string modelled(const Model& model) {
    std::string words = "springs";
    const auto add = [&](bool listed, const char* name) {
        if (listed) words += std::string(" + ") + name;
    };
    add(model.has_diagonals(), "diagonal springs");
    add(model.is_damped(), "spring damping");
    model.terms.for_each([&](const auto& term) { add(true, term.name); });
    add(model.added_air() != nullptr, "added air");
    model.limits.for_each([&](const auto& limit) { add(true, limit.name); });
    return words;
}

}  // namespace

std::vector<Result> results_of(const Simulation& simulation, int threads, const Cost& cost,
                               const std::optional<Divergence>& divergence, const ErrorEstimate& error,
                               const std::string& reason) {
    const Scene& scene = simulation.scene();
    const FlagSettings& flag = scene.flag;
    const Readings readings = simulation.readings();
    const double time = simulation.time();
    const StableStep limit = simulation.stability_limit();
    // Neither is known of a run that took no step.
    const double milliseconds = time > 0.0 ? 1e3 * cost.processor / time : NAN;
    const double real_time = time > 0.0 ? time / cost.wall : NAN;
    const std::string of_limit = limit.is_none()        ? "no step is known to be stable"
                                 : limit.is_unlimited() ? "every step is stable"
                                                        : rounded(100.0 * simulation.dt() / limit.seconds(), 3) +
                                                              " % of the bound that is stable in any shape, " +
                                                              with_unit(limit.seconds(), "s");
    const std::string hash = fmt::format("{:016x}", simulation.state_hash());

    std::vector<Result> results;
    const auto text = [&](const std::string& key, std::string_view value, const std::string& label) {
        results.push_back({key, std::string(value), label, std::string(value)});
    };
    const auto number = [&](const std::string& key, auto value, const std::string& label, const std::string& shown) {
        results.push_back({key, value, label, std::isfinite(static_cast<double>(value)) ? shown : "-"});
    };
    const auto measure = [&](const std::string& key, double value, const std::string& label, const std::string& unit) {
        number(key, value, label, with_unit(value, unit));
    };
    text("scene", scene.name, "scene");
    number("columns", flag.columns, "masses", std::to_string(flag.columns) + " x " + std::to_string(flag.rows));
    number("rows", flag.rows, "", "");
    text("modelled", modelled(model_of(scene)), "modelled");
    text("method", name_of(scene.time.method), "method");
    text("precision", name_of(simulation.precision()), "precision");
    number("threads", threads, "threads", std::to_string(threads));
    measure("time_s", time, "time simulated", "s");
    number("steps", simulation.steps(), "steps", std::to_string(simulation.steps()));
    number("dt_s", simulation.dt(), "step", with_unit(simulation.dt(), "s") + " (" + of_limit + "; " + reason + ")");
    text("dt_reason", reason, "");
    number("stability_limit_s", limit.is_finite() ? limit.seconds() : NAN, "", "");
    const StableStep live = simulation.live_limit().value_or(StableStep::none());
    if (live.is_finite())
        number("live_limit_s", live.seconds(), "limit at the end",
               with_unit(live.seconds(), "s") + " (the step is " +
                   rounded(100.0 * simulation.dt() / live.seconds(), 3) + " % of it)");
    else
        number("live_limit_s", NAN, "", "");
    if (!simulation.method_remark().empty()) text("method_remark", simulation.method_remark(), "by nature");
    if (const Solves& solves = simulation.solves(); solves.steps > 0) {
        const auto steps = static_cast<double>(solves.steps);
        number(
            "linear_solves_per_step", static_cast<double>(solves.linear_solves) / steps, "solving",
            fmt::format("{} corrections a step, {} iterations each; {} of {} steps left unsolved",
                        rounded(static_cast<double>(solves.linear_solves) / steps, 3),
                        rounded(static_cast<double>(solves.iterations) / static_cast<double>(solves.linear_solves), 3),
                        solves.unsolved, solves.steps));
        number("iterations_per_step", static_cast<double>(solves.iterations) / steps, "", "");
        number("unsolved_steps", solves.unsolved, "", "");
        measure("worst_residual_m_per_s", solves.residual, "worst residual", "m/s");
    }
    measure("cpu_ms_per_simulated_s", milliseconds, "CPU per simulated second", "ms");
    results.push_back({"error_m_per_s", error.rate, "error of the method",
                       error.resolved() ? with_unit(1e3 * error.rate, "mm") + " per simulated second, over the last " +
                                              with_unit(error.seconds, "s")
                                        : "not resolvable: " + error.explanation()});
    text("error_reason", error.explanation(), "");
    const bool is_float = simulation.precision() == Precision::single_precision;
    const auto best = error.best_float_step();
    number("rounding_error_m_per_s", is_float && error.by_rounding > 0.0 ? error.by_rounding : NAN,
           is_float ? "error of float" : "", with_unit(1e3 * error.by_rounding, "mm") + " per simulated second");
    number("best_float_step_s", best.value_or(NAN), is_float ? "best step in float" : "",
           best ? with_unit(*best, "s") + (limit.allows(*best) ? "" : " (above the stability limit)") : "");
    number("real_time_factor", real_time, "real-time factor", rounded(real_time, 3));
    measure("kinetic_energy_J", readings.kinetic_energy, "kinetic energy", "J");
    measure("spring_energy_J", readings.spring_energy, "spring energy", "J");
    measure("gravity_energy_J", readings.gravity_energy, "gravity energy", "J");
    number("greatest_stretch", readings.max_stretch, "greatest stretch", with_unit(100.0 * readings.max_stretch, "%"));
    number("mean_stretch", readings.mean_stretch, "mean stretch", with_unit(100.0 * readings.mean_stretch, "%"));
    measure("greatest_spring_force_N", readings.max_spring_force, "greatest spring force", "N");
    const auto created = readings.created_share;
    number("created_energy_share", created.value_or(NAN), "energy created by the method",
           created ? with_unit(100.0 * *created, "% of all there could be") : "not known with this method");
    if (scene.limits.get<StretchLimit>()) {
        number("limit_sweeps", readings.limit.sweeps, "stretch limit",
               std::to_string(readings.limit.sweeps) + " sweeps in the last batch, " +
                   (readings.limit.met ? "met" : "not met") + ": at most " +
                   with_unit(100.0 * readings.limit.max_stretch, "%"));
        results.push_back({"limit_met", readings.limit.met, "", ""});
    }
    text("state_hash", hash, "state hash");
    results.push_back({"diverged", divergence.has_value(), "", ""});
    return results;
}

}  // namespace drapeau::lab
