// What a simulation says of its step, its method and its precision, in words for a person.
#include "run/simulation.hpp"

#include "io/text.hpp"
#include "run/method_remark.hpp"
#include "run/simulation_run.hpp"
#include "scene/file.hpp"

#include <fmt/format.h>

#include <cmath>

namespace drapeau {

std::optional<StableStep> Simulation::live_limit() const {
    return run_->live_limit();
}

std::optional<StableStep> Simulation::Run::live_limit() const {
    if (!mode) return {};
    return with_method(scene.time.method, [&]<class M>(const M& method) -> std::optional<StableStep> {
        if constexpr (has_live_limit<M>)
            return smaller(exact_step(method, *mode), added_air_step(engine->model()));
        else
            return {};
    });
}

std::string Simulation::limit_remark() const {
    return run_->limit_remark();
}

std::string Simulation::Run::limit_remark() const {
    const auto live = live_limit();
    const double dt = now.clock.dt;
    if (!live || !live->is_finite() || live->allows(dt)) return "";
    const double growth = with_method(scene.time.method, [&]<class M>(const M&) {
        if constexpr (has_live_limit<M>)
            return M::growth(*mode, dt);
        else
            return 1.0;
    });
    const double share = dt / live->seconds(), steps = std::log(10.0) / std::log(growth);
    const std::string its_limit = quantity(live->seconds(), "s");
    const std::string past = share < 2.0 ? rounded(100.0 * (share - 1.0), 2) + " % past the limit of " + its_limit
                                         : rounded(share, 3) + " times the limit of " + its_limit;
    if (!(growth > 1.0)) return fmt::format("the step is {} that added air stands", past);
    return fmt::format("the step is {}: noise grows tenfold every {} steps", past, rounded(std::max(1.0, steps), 2));
}

std::string Simulation::method_remark() const {
    const Solves& solves = run_->solves;
    if (2 * solves.unsolved > solves.steps)
        return fmt::format("{} left {} of {} steps unsolved, so forces and stretch mean little: choose smaller steps",
                           name_of(run_->scene.time.method), solves.unsolved, solves.steps);
    return drapeau::method_remark(run_->scene.time.method, model(), dt());
}

std::string Simulation::lowered_because() const {
    if (run_->lowered == 1.0) return "";
    return fmt::format(
        "the automatic step is at {:.2g} % of its usual size: the motion is violent and a larger step would create "
        "energy",
        100.0 * run_->lowered);
}

std::string Simulation::step_reason() const {
    const Run& run = *run_;
    if (!run.automatic()) return "given";
    if (run.accuracy_decides()) {
        const bool known = run.error && run.error->resolved();
        const std::string measured = known ? rounded(1e3 * run.error->rate, 2) + " of " : "";
        return fmt::format("limit: {}{:.3g} mm/s asked", measured, 1e3 * *run.scene.time.tolerance);
    }
    if (run.lowered < 1.0) return "limit: energy was being created";
    const std::string limit = "limit: " + limit_of_step(run.scene.time.method, run.engine->model());
    const auto tolerance = run.scene.time.tolerance;
    if (!tolerance || !run.error || !run.error->resolved() || run.error->rate <= *tolerance) return limit;
    // The step follows in a second or two.
    return fmt::format("{}; {} of {:.3g} mm/s asked by now", limit, rounded(1e3 * run.error->rate, 2),
                       1e3 * *tolerance);
}

std::string Simulation::precision_remark() const {
    const Run& run = *run_;
    if (run.precision != run.scene.time.precision)
        return "computed in double: float cannot honour steps of " + quantity(run.now.clock.dt, "s") + " in this scene";
    if (!run.float_resolves_too_little()) return "";
    const double unit = float_velocity_unit(run.engine->reach(), run.now.clock.dt);
    return "at steps of " + quantity(run.now.clock.dt, "s") + " float knows velocities to " + quantity(unit, "m/s", 2) +
           " only, and masses move too far or not at all: choose double";
}

}  // namespace drapeau
