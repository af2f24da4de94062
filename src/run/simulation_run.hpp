// What a simulation consists of, and how it advances: batches under a watch that lowers an automatic step or stops, the
// error that a tolerance asks about, and the fastest mode. For simulation.cpp and simulation_remarks.cpp alone.
#pragma once

#include "run/divergence.hpp"
#include "run/simulation.hpp"
#include "run/step_choice.hpp"
#include "run/tolerance_step.hpp"
#include "run/watch.hpp"
#include "scene/surroundings.hpp"

#include "drapeau/precision.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace drapeau {

/// What a run is besides its masses and what is under way on other threads: all that is kept of a moment.
struct RunState {
    Scene scene;
    Precision precision{};  // in use
    Progress now;
    Watch watch;
    bool exact = false;                  // a numeric dt is used as given
    double lowered = 1.0;                // of the usual automatic step, after energy was created
    double lowered_at = 0.0;             // s, when that last changed
    std::optional<ErrorEstimate> error;  // the newest, of the step in use
    ToleranceStep tolerated;
    bool float_misses_tolerance = false;
    PassReport limit;                // of the steps last asked for
    Solves solves{};                 // of all since the settings last changed
    std::optional<Oscillator> mode;  // the fastest here and now, of methods whose limit follows from it
    Readings readings;               // the newest
    long long readings_batches = 0;  // batches since then
    std::string start_remark;
    double typical_speed = 0.0;  // m/s, of the model
    bool is_promised = true;     // the step is within the limit
    long long batches = 0;       // since the run began
    long long in_batch = 0;      // steps of the batch under way that are done
    long long batch_end = 0;     // its end
    long long steps_unseen = 0;  // since the last look at the fastest mode
};

struct KeptRun::Parts {
    RunState run;
    ErrorWatch::Kept errors;
    std::shared_ptr<const EngineState> masses;
    std::array<std::shared_ptr<const EngineState>, Watch::places> good;  // that the watch may return to
};

struct Simulation::Run : RunState {
    std::unique_ptr<Engine> engine;
    int threads = 1;
    ErrorWatch errors;
    ErrorWatch::Mode error_mode = ErrorWatch::Mode::off;
    std::optional<Pull> pull;  // of a hand, from the next batch on: no part of what is kept
    PullReport pulled;         // of the steps last asked for

    Run(const Scene& wanted, const State<double>& state, double time, long long steps, bool exact_dt) {
        scene = wanted;
        exact = exact_dt;
        const Model model = model_of(wanted);
        precision = chosen_precision(wanted, model, chosen_step(wanted, model, exact, 1.0));
        engine = make_engine(model, wanted.time.method, precision, wanted.time.half_kick_start);
        engine->set(state);
        restart_clock(time, steps);
    }

    bool automatic() const { return !scene.time.dt.has_value(); }
    StableStep stable() const { return stable_step(scene.time.method, engine->model()); }

    /// What stability allows, and with a tolerance accuracy too.
    double usual_step() const { return chosen_step(scene, engine->model(), exact, lowered); }
    bool accuracy_decides() const { return automatic() && tolerated.allowed() < usual_step(); }
    double step() const { return accuracy_decides() ? whole_steps_per_batch(tolerated.allowed()) : usual_step(); }

    /// The step chosen anew, from a moment on; opens a new ledger.
    void restart_clock(double time, long long steps) {
        now = {{time, steps, step()}, steps};
        forget_errors();
        in_batch = 0;
        limit = {};
        typical_speed = drapeau::typical_speed(engine->model());
        is_promised = stable().allows(now.clock.dt);
        open();
        readings_batches = max_batches;
    }

    /// Other places and velocities, at a time (s).
    void put(const State<double>& state, double time) {
        const double smallest = smallest_float_step(engine->reach(state.position.at(0, 0)), typical_speed);
        if (precision == Precision::single_precision && !automatic())
            check_float_step(now.clock.dt, smallest, *scene.time.dt);
        engine->set(state);
        lowered = 1.0;
        if (automatic() && float_resolves_too_little()) use_precision(Precision::double_precision);
        restart_clock(time, now.steps);
    }

    /// Other strengths.
    void refill(const Scene& wanted, const std::atomic<bool>* abandon) {
        const Model model = model_of(wanted);
        const bool keeps_tolerance = scene.time.tolerance == wanted.time.tolerance;
        const double allowed = keeps_tolerance ? tolerated.allowed() : INFINITY;
        // Throws before anything is changed.
        Precision wanted_precision =
            chosen_precision(wanted, model, std::min(chosen_step(wanted, model, exact, 1.0), allowed));
        if (keeps_tolerance && float_misses_tolerance) wanted_precision = Precision::double_precision;
        if (wanted_precision != precision) use_precision(wanted_precision);
        engine->synchronise(now.time());
        engine->refill(model);
        scene = wanted;
        lowered = 1.0;
        solves = {};
        if (!keeps_tolerance) tolerated = {}, float_misses_tolerance = false;
        restart_clock(now.time(), now.steps);
        if (!keeps_tolerance) meet_tolerance_at_once(abandon);
    }

    /// The step to begin with: measured from where the masses are, until it is small enough.
    void meet_tolerance_at_once(const std::atomic<bool>* abandon) {
        constexpr int tries = 8;
        if (!automatic() || !scene.time.tolerance) return;
        for (int n = 0; n < tries; ++n) {
            const auto estimate = error_of(window(), abandon);
            if (follow(estimate, true)) continue;
            error = estimate;
            return;
        }
    }

    /// Advances to a number of steps or, where an automatic step changes on the way, to about the time of their end.
    std::optional<Divergence> advance(long long count, const std::atomic<bool>* abandon) {
        const double end = now.clock.at(now.steps + count);
        const auto steps_left = [&] { return std::llround((end - now.time()) / now.clock.dt); };
        limit = {};
        pulled = {};
        for (long long left = count; left > 0;) {
            if (in_batch == 0) {
                const double dt = now.clock.dt;
                haul();
                engine->pull(now.steps, pull);
                if (pull) forget_errors();  // what is run again is not pulled
                if (!heed_errors(abandon)) return {};
                if (now.clock.dt != dt) left = std::max(1LL, steps_left());
                watch.begin_batch(*engine, now);
                batch_end = now.next_batch();
            }
            const long long to = std::min(now.steps + left, batch_end);
            Report report;
            const long long reached =
                engine->advance(now.clock, now.steps, to, watch.accounted_step(), report, abandon);
            left -= reached - now.steps;
            in_batch += reached - now.steps;
            now.steps = reached;
            watch.count(report);
            limit.add(report.limit);
            pulled.add(report.pull);
            solves.add(report.solves);
            if (reached < to) return {};  // abandoned
            const bool within = reached < batch_end;
            if (!within) {
                watch.end_batch(*engine, now);
                ++readings_batches;
                errors.end_batch();
                follow_fastest_mode(in_batch);
            }
            // What is handed out here. Past the limit a step may multiply anything by anything.
            if (within || !is_promised) watch.look_for_infinities(*engine, now);
            if (within && !watch.is_broken()) continue;
            in_batch = 0;
            if (++batches % batches_between_looks == 0 && automatic() && float_resolves_too_little()) {
                use_precision(Precision::double_precision);
                restart_clock(now.time(), now.steps);
            }
            const auto alarms = [&] { return automatic() ? watch.warns() : watch.is_broken(); };
            // Samples may mislead, or leave too much in doubt.
            if (alarms() || watch.suspects()) {
                watch.count_again(*engine, now, abandon);
                if (!is_promised) watch.look_for_infinities(*engine, now);
            }
            if (alarms()) {
                if (!may_lower()) return stopped(abandon);
                take_back();
                left = steps_left();
            } else if (lowered < 1.0 && watch.calm_for(calm, now.time()) && now.time() - lowered_at > calm) {
                lower(1.0 / 0.8);
                left = steps_left();
            }
        }
        return {};
    }

    std::optional<Divergence> check() {
        for (const double end = now.time();;) {
            if (now.steps > now.clock.first && !watch.count_again(*engine, now, nullptr)) watch.look_now(*engine, now);
            if (!watch.is_broken()) return {};
            in_batch = 0;
            if (!may_lower()) return stopped(nullptr);
            take_back();
            if (auto divergence = advance(std::llround((end - now.time()) / now.clock.dt), nullptr)) return divergence;
        }
    }

    std::shared_ptr<const KeptRun> keep() const {
        auto parts = std::make_unique<KeptRun::Parts>();
        parts->run = *this;
        parts->errors = errors.keep();
        parts->masses = engine->keep();
        for (int place = 0; place < Watch::places; ++place)
            parts->good[static_cast<std::size_t>(place)] = engine->kept_in(place);
        return std::make_shared<KeptRun>(std::move(parts));
    }

    /// Goes on from there. Threads, and how errors are measured, stay.
    void restore(const KeptRun::Parts& kept) {
        const bool fits = scene == kept.run.scene && precision == kept.run.precision;
        if (!fits) {  // throws before anything is changed
            auto next = make_engine(model_of(kept.run.scene), kept.run.scene.time.method, kept.run.precision,
                                    kept.run.scene.time.half_kick_start);
            next->use_threads(threads);
            engine = std::move(next);
        }
        engine->restore(*kept.masses);
        for (int place = 0; place < Watch::places; ++place)
            engine->put_in(place, kept.good[static_cast<std::size_t>(place)]);
        static_cast<RunState&>(*this) = kept.run;
        if (!fits) look_at_fastest_mode(first_looks), mode = kept.run.mode;  // a new engine knows none yet
        errors.restore(kept.errors, automatic() && scene.time.tolerance ? ErrorWatch::Mode::awaited : error_mode);
    }

    void use_threads(int count) {
        engine->use_threads(count);
        threads = count;
    }

    /// Whether the step is one that float does not honour, where the masses are now.
    bool float_resolves_too_little() const {
        return precision == Precision::single_precision &&
               now.clock.dt < smallest_float_step(engine->reach(), typical_speed);
    }

    std::optional<StableStep> live_limit() const;
    std::string limit_remark() const;

    ErrorWindow window() { return {engine->state(now.time()), now.time()}; }
    ErrorEstimate error_of(const ErrorWindow& window, const std::atomic<bool>* abandon = nullptr) const {
        return measure_error(engine->model(), scene.time.method, precision, window, now.clock.dt, abandon,
                             scene.time.half_kick_start);
    }

    /// How many batches go by between two readings for the picture, so that they cost a hundredth of the steps, or a
    /// little more where a second has few.
    long long batches_between_readings() const {
        constexpr double steps_a_reading = 200.0;  // hundred times what it costs, in steps
        return std::clamp(std::llround(steps_a_reading * now.clock.dt / batch_seconds), 1LL, max_batches);
    }
    static constexpr long long max_batches = 60;

private:
    static constexpr long long batches_between_looks = 60;
    static constexpr double smallest_lowered = 1e-3;
    static constexpr int first_looks = 10, final_looks = 200;
    static constexpr double calm = 2.0;  // s without energy created until a lowered step may grow again

    /// Looks at the fastest mode once for every so many steps taken, so that it costs a few per cent of them.
    void follow_fastest_mode(long long steps) {
        constexpr long long steps_a_look = 30;
        steps_unseen += steps;
        if (steps_unseen < steps_a_look) return;
        steps_unseen = 0;
        look_at_fastest_mode(1);
    }
    void look_at_fastest_mode(int looks) {
        with_method(scene.time.method, [&]<class M>(const M&) {
            if constexpr (has_live_limit<M>) {
                const StableStep bound = stable();
                if (!bound.is_finite()) return mode.reset();
                mode = engine->fastest_mode(M::damping_weight, M::on_mass_weight,
                                            std::clamp(now.clock.dt, bound.seconds(), 2.0 * bound.seconds()), looks,
                                            now.time());
            } else {
                mode.reset();
            }
        });
    }

    void open() {
        look_at_fastest_mode(first_looks);
        auto nature = Watch::Nature::of(scene.time.method);
        if (automatic()) nature.dissipates = false;  // its step is too small for that
        watch.open(*engine, now, batch_seconds / now.clock.dt, nature);
    }

    bool may_lower() const { return automatic() && lowered >= smallest_lowered; }
    /// Back on the last good state, to go on with a smaller step.
    void take_back() {
        watch.return_to_good(*engine, now);
        lower(0.6);
        open();  // what was created until then is not held against the smaller step
    }

    /// Back on the last good state, with the reason.
    Divergence stopped(const std::atomic<bool>* abandon) {
        const double broken_at = now.time();
        const auto cause = float_resolves_too_little()            ? Divergence::Cause::float_rounding
                           : watch.ledger().created_share() < 0.0 ? Divergence::Cause::energy_lost
                                                                  : Divergence::Cause::energy_created;
        watch.return_to_good(*engine, now);
        auto divergence = explain_divergence(*engine, watch, scene.time.method, now, broken_at, cause, abandon);
        look_at_fastest_mode(final_looks);  // what was seen of it on the way may be little
        if (const std::string remark = limit_remark(); !remark.empty()) divergence.message += "; " + remark;
        return divergence;
    }

    /// The same masses in another precision; a new clock must follow.
    void use_precision(Precision wanted) {
        auto next = make_engine(engine->model(), scene.time.method, wanted, scene.time.half_kick_start);
        next->use_threads(threads);
        next->set(engine->state(now.time()));
        engine = std::move(next);
        precision = wanted;
    }

    /// Another share of the usual automatic step from now on.
    void lower(double by) {
        lowered = std::min(1.0, by * lowered);
        lowered_at = now.time();
        take_step();
    }

    /// The step as it is chosen now; the ledger goes on.
    void take_step() {
        engine->synchronise(now.time());
        now.clock = {now.time(), now.steps, step()};
        forget_errors();
    }

    void forget_errors() {
        errors.restart();
        error.reset();
    }

    /// At the beginning of a batch: moves what is held towards its place on the pole, no faster than a hand hauls.
    void haul() {
        constexpr double fastest = 0.5;  // m/s
        double speed = 0.0;
        if (scene.flag.halyard && !engine->model().is_free()) {
            const double far = hoisted_height(scene) - engine->corner().y;
            const auto steps = static_cast<double>(now.next_batch() - now.steps);
            const bool there = std::abs(far) <= steps * engine->epsilon() * engine->reach();  // as steps round
            if (!there) speed = std::clamp(far / (steps * now.clock.dt), -fastest, fastest);
        }
        const double change = std::abs(speed - engine->hauled());
        if (change > 1e-5 * fastest || (speed == 0.0 && change > 0.0)) {
            engine->haul(now.time(), speed);
            restart_clock(now.time(), now.steps);
        }
        if (speed != 0.0) forget_errors();  // what is run again holds still what is held
    }

    /// At the beginning of a batch: what is known of the error by now, and the step that follows from it. False if
    /// `abandon` came while that was waited for.
    bool heed_errors(const std::atomic<bool>* abandon) {
        const bool asked = automatic() && scene.time.tolerance;
        const auto how = asked ? ErrorWatch::Mode::awaited : error_mode;
        bool abandoned = false;
        if (const auto estimate = errors.take(how, abandon, abandoned)) {
            error = estimate;
            if (asked) follow(*estimate, false);
        }
        if (abandoned) return false;
        errors.begin_batch(how, *engine, scene.time, precision, now);
        return true;
    }

    /// The step and the precision that a tolerance asks for after an estimate. Whether they changed.
    bool follow(const ErrorEstimate& estimate, bool at_once) {
        const double tolerance = *scene.time.tolerance;
        if (needs_double(estimate, tolerance)) {
            float_misses_tolerance = true;
            use_precision(Precision::double_precision);
            restart_clock(now.time(), now.steps);
            return true;
        }
        const bool changed = at_once ? tolerated.lower_at_once(estimate, tolerance)
                                     : tolerated.take_in(estimate, tolerance, usual_step());
        if (!changed || step() == now.clock.dt) return false;
        take_step();
        if (!float_resolves_too_little()) return true;
        use_precision(Precision::double_precision);
        restart_clock(now.time(), now.steps);
        return true;
    }
};

}  // namespace drapeau
