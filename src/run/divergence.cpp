#include "run/divergence.hpp"

#include "io/text.hpp"
#include "run/method_remark.hpp"
#include "scene/file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace drapeau {
namespace {

/// Runs batches from where the engine stands to the step `last`; false once the watch says that it is broken. `now` is
/// then the end of the batch that broke, `before` its beginning, kept in `place` of the engine.
struct Replay {
    Engine& engine;
    Watch& watch;
    const std::atomic<bool>* abandon;
    int place;

    bool abandoned() const { return abandon && abandon->load(std::memory_order_relaxed); }

    bool holds(Progress& now, Progress& before, long long last) const {
        while (now.steps < last) {
            before = now;
            engine.save(place);
            watch.begin_batch(engine, now);
            Report report;
            const long long batch_end = now.next_batch(), to = std::min(batch_end, last);
            if (engine.advance(now.clock, now.steps, to, watch.accounted_step(), report, abandon) < to) return true;
            watch.count(report);
            now.steps = to;
            if (to == batch_end) watch.end_batch(engine, now);
            if (watch.is_broken() || !engine.is_finite(now.time())) return false;
        }
        return true;
    }
};

/// The first mass that is not finite, or else the fastest.
std::pair<int, int> worst(const State<double>& state) {
    std::pair<int, int> at{0, 0};
    double most = -1.0;
    for (int j = 0; j < state.rows(); ++j)
        for (int i = 0; i < state.columns(); ++i) {
            const auto x = state.position.at(i, j), v = state.velocity.at(i, j);
            const double speed = v.x * v.x + v.y * v.y + v.z * v.z;
            if (!std::isfinite(speed) || !std::isfinite(x.x + x.y + x.z)) return {i, j};
            if (speed > most) most = speed, at = {i, j};
        }
    return at;
}

std::string cause_and_remedy(Method method, const Divergence& d, bool bends) {
    const std::string_view name = name_of(method);
    const std::string step = quantity(d.dt, "s"), limit = d.limit.is_finite() ? quantity(d.limit.seconds(), "s") : "";
    const std::string remedy = d.safe_dt > 0.0                     ? "a step of " + quantity(d.safe_dt, "s") + " holds"
                               : method == method_id<ForwardEuler> ? "semi-implicit-euler takes far larger ones"
                               : bends ? "choose dt \"auto\", or weaker bending, wind or springs"
                                       : "choose dt \"auto\", more drag or damping, or weaker wind or springs";
    switch (d.cause) {
        case Divergence::Cause::past_the_limit:
            if (d.limit.is_none())
                return fmt::format("{} has no stable step without drag or friction: choose semi-implicit-euler", name);
            return fmt::format("the step {} is above {}, up to which {} is stable however {}; {}", step, limit, name,
                               bends ? "this cloth lies" : "these springs lie", remedy);
        case Divergence::Cause::too_soft:
            return fmt::format(
                "at steps of {} {} makes these springs so much too soft that they hold more energy than there is; {}",
                step, name, remedy);
        case Divergence::Cause::energy_created:
            if (d.limit.is_unlimited())
                return fmt::format("{} creates energy at steps of {} in motion as violent as this; {}", name, step,
                                   remedy);
            return fmt::format(
                "the step {} is within {}, up to which {} is stable, but the motion is so violent that it creates "
                "energy; {}",
                step, limit, name, remedy);
        case Divergence::Cause::energy_lost:
            if (d.limit.is_unlimited())
                return fmt::format("the step {} is too large for {} to keep the energy of this motion; {}", step, name,
                                   remedy);
            return fmt::format(
                "the step {} is within {}, up to which {} is stable, but too large for it to keep the energy of this "
                "motion; {}",
                step, limit, name, remedy);
        case Divergence::Cause::float_rounding:
            return fmt::format("float cannot honour steps of {} in this scene; choose double", step);
        case Divergence::Cause::beyond_precision:
            break;
    }
    return "forces are too large for this precision; weaken wind, gravity or springs";
}

}  // namespace

Divergence explain_divergence(Engine& engine, Watch& watch, Method method, const Progress& good, double broken_at,
                              Divergence::Cause cause, const std::atomic<bool>* abandon) {
    constexpr int good_place = Watch::places, batch_place = Watch::places + 1;
    const Watch watch_then = watch;
    engine.save(good_place);
    const Replay replay{engine, watch, abandon, batch_place};

    Divergence d;
    d.dt = good.clock.dt;
    d.limit = stable_step(method, engine.model());
    d.cause = !d.limit.allows(d.dt) ? Divergence::Cause::past_the_limit : Divergence::Cause::energy_created;

    // The batch that broke, then the step within it, by halving.
    Progress now = good, before = good;
    const long long end = good.steps + std::llround((broken_at - good.time()) / good.clock.dt);
    const bool found = !replay.holds(now, before, end);
    const bool finite = engine.is_finite(now.time());
    if (finite && d.cause == Divergence::Cause::energy_created) d.cause = cause;
    constexpr double much_too_soft = 1.5;
    if (d.cause == Divergence::Cause::energy_created && softness(method, engine.model(), d.dt) > much_too_soft)
        d.cause = Divergence::Cause::too_soft;
    long long bad = found ? now.steps : end;  // counted by samples the replay may hold
    if (found && !finite && before.steps < bad) {
        long long fine = before.steps;
        while (bad - fine > 1 && !replay.abandoned()) {
            const long long middle = fine + (bad - fine) / 2;
            Report ignored;
            engine.restore(batch_place);
            engine.advance(now.clock, fine, middle, no_step, ignored, abandon);
            if (engine.is_finite(now.clock.at(middle))) {
                fine = middle;
                engine.save(batch_place);
            } else {
                bad = middle;
            }
        }
        Report ignored;
        engine.restore(batch_place);
        engine.advance(now.clock, fine, bad, no_step, ignored, abandon);
    }
    d.step = bad;
    d.time = now.clock.at(bad);
    std::tie(d.column, d.row) = worst(engine.state(d.time));
    if (!finite && d.cause == Divergence::Cause::energy_created && before.steps == good.steps && bad - good.steps <= 1)
        d.cause = Divergence::Cause::beyond_precision;

    // A remedy is a step that holds from the same state for as long.
    if (d.cause != Divergence::Cause::beyond_precision && !d.limit.is_none()) {
        const double usual =
            with_method(method, [&](const auto& chosen) { return automatic_step(chosen, engine.model()); });
        double work_left = 3e7;  // some tenths of a second
        const double a_step = engine.step_cost() * (engine.model().is_limited() ? 40.0 : 1.0);  // a limit that acts
        const double span = broken_at + 2.0 * batch_seconds - good.time();
        double dt = whole_steps_per_batch(std::min(usual, 0.7 * d.dt));
        for (int tries = 0; tries < 5 && !replay.abandoned(); ++tries, dt = whole_steps_per_batch(0.6 * dt)) {
            work_left -= span / dt * a_step;
            if (work_left < 0.0) break;
            engine.restore(good_place);
            engine.synchronise(good.time());
            watch = watch_then;
            Progress tried = good, ignored;
            tried.clock = {good.time(), good.steps, dt};
            watch.open(engine, tried, batch_seconds / dt, Watch::Nature::of(method));
            if (replay.holds(tried, ignored, good.steps + std::llround(std::ceil(span / dt))) && !replay.abandoned()) {
                d.safe_dt = dt;
                break;
            }
        }
    }

    d.message = fmt::format("diverged at step {} (t = {:.4g} s) at column {}, row {}: {}", d.step, d.time, d.column,
                            d.row, cause_and_remedy(method, d, engine.model().bending() != nullptr));
    engine.restore(good_place);
    watch = watch_then;
    return d;
}

}  // namespace drapeau
