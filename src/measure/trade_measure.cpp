#include "measure/trade_measure.hpp"

#include "io/error.hpp"
#include "measure/clocks.hpp"
#include "measure/run_cost.hpp"
#include "run/carry_over.hpp"
#include "run/simulation.hpp"

#include "drapeau/stability.hpp"

#include <algorithm>
#include <cmath>

namespace drapeau {

namespace {

/// Evaluations of all forces so far. A product with the Hessian, which takes about as long, counts as one.
long long evaluations_of(const Simulation& simulation, Method method, long long steps) {
    return with_method(method, [&]<class M>(const M&) {
        if constexpr (!M::solves) return M::passes * steps;
        const Solves& solves = simulation.solves();
        return steps + solves.linear_solves + solves.iterations;
    });
}

bool is_finite(const Apart& apart) {
    return std::isfinite(apart.at_end + apart.over_time + apart.energy);
}

}  // namespace

bool Measured::is_below_resolution() const {
    constexpr double resolved = 10.0;
    return is_measured() && !(error_in_time.distance() >= resolved * known_to);
}

Measured measure_errors(const TradePoint& point, const Footing& ground, const Footing& scene,
                        const std::function<bool()>& may_go_on) {
    Measured measured;
    measured.point = point;
    const bool is_other = ground.variant.key != scene.variant.key;
    const bool has_own = !ground.reference.by_rk4.positions.empty();
    measured.known_to = (has_own ? ground : scene).reference.error();
    measured.error.at_end = measured.error.over_time = measured.error.greatest = NAN;
    measured.error.energy = measured.error.stretch = NAN;
    measured.error_in_time = measured.error;
    try {
        Simulation simulation = simulation_at(point.scene_on(ground.variant), ground.stretch);
        const Tip tip = tip_of(ground.model);
        Comparison in_time(ground.model, ground.reference.judge_of(point.method));
        Comparison in_all(scene.model, scene.reference.judge_of(point.method));
        std::vector<glm::dvec3> tips, tip_velocities;
        const auto diverge = [&](double at, const std::string& how) {
            measured.outcome = Measured::Outcome::diverged;
            measured.diverged_at = at;
            measured.remark = how;
        };
        std::optional<Divergence> divergence;
        for (long long batch = 1; batch <= ground.stretch.batches && !divergence; ++batch) {
            const double before = thread_seconds();
            divergence = simulation.advance_batch();
            measured.first_cost += thread_seconds() - before;
            measured.force_evaluations = evaluations_of(simulation, point.method, batch * point.steps_a_batch);
            if (divergence) break;
            if (!may_go_on()) {
                measured.remark = "stopped: it took longer than the budget allows";
                return measured;
            }
            const State<double> state = simulation.state();
            tips.push_back(state.position.at(tip.column, tip.row));
            tip_velocities.push_back(state.velocity.at(tip.column, tip.row));
            if (!ground.stretch.is_sample(batch)) continue;
            const Reading reading = ground.yardstick->read(state, simulation.time());
            if (has_own) in_time.take(state.position, reading);
            if (is_other) in_all.take(carried_over(state, scene.variant.scene).position, reading);
        }
        if (!divergence) divergence = simulation.check();
        if (divergence) {
            diverge(divergence->time - ground.stretch.time, divergence->message);
            return measured;
        }
        if (has_own) measured.error_in_time = in_time.result();
        measured.error = is_other ? in_all.result() : measured.error_in_time;
        if (!is_finite(measured.error)) {
            diverge(ground.stretch.seconds(), "a value is not finite");
            return measured;
        }
        measured.tip = statistics_of(tips, tip_velocities, batch_seconds);
        measured.outcome = Measured::Outcome::measured;
        measured.ms_per_second = 1e3 * measured.first_cost / ground.stretch.seconds();
    } catch (const InputError& refused) {
        measured.outcome = Measured::Outcome::refused;
        measured.remark = refused.what();
    }
    return measured;
}

double measure_cost(const Measured& measured, const Footing& ground) {
    constexpr double long_enough = 3e-3;  // s
    return run_cost(measured.point.scene_on(ground.variant), ground.stretch,
                    times_for(long_enough, measured.first_cost));
}

}  // namespace drapeau
