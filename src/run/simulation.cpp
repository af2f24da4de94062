#include "run/simulation.hpp"

#include "run/carry_over.hpp"
#include "run/simulation_run.hpp"
#include "run/start_state.hpp"
#include "scene/file.hpp"

#include "drapeau/precision.hpp"

#include <cmath>

namespace drapeau {
namespace {

/// What must be the same for position and velocity to go on through a change of scene.
bool goes_on(const FlagSettings& from, const FlagSettings& to) {
    return from.attach == to.attach && from.start == to.start && from.prestretch == to.prestretch;
}

/// Whether what forces did in a step is known at its end.
bool knows_work(Method method) {
    return with_method(method, [](const auto& m) { return std::decay_t<decltype(m)>::counts_work; });
}

bool touch_alike(const Limits& a, const Limits& b) {
    const auto touches = [](const Limits& limits) { return limits.get<Ground>() || limits.get<Pole>(); };
    return touches(a) == touches(b);
}

bool bends_alike(const std::optional<Bending>& a, const std::optional<Bending>& b) {
    return a.has_value() == b.has_value() && (!a || a->damping.has_value() == b->damping.has_value());
}

/// Whether only strengths differ, which an engine takes over as it runs.
bool same_structure(const Scene& a, const Scene& b) {
    return a.flag.columns == b.flag.columns && a.flag.rows == b.flag.rows && a.flag.width == b.flag.width &&
           a.flag.height == b.flag.height && goes_on(a.flag, b.flag) && a.time.method == b.time.method &&
           a.time.precision == b.time.precision && a.time.half_kick_start == b.time.half_kick_start &&
           a.fabric.has_value() == b.fabric.has_value() && a.diagonals().has_value() == b.diagonals().has_value() &&
           a.damping().has_value() == b.damping().has_value() && touch_alike(a.limits, b.limits) &&
           a.terms.get<Air>().has_value() == b.terms.get<Air>().has_value() &&
           bends_alike(a.terms.get<Bending>(), b.terms.get<Bending>());
}

}  // namespace

Simulation::Simulation(const Scene& scene, const std::atomic<bool>* abandon) {
    check_scene(scene);
    StartState start = start_state(scene, abandon);
    run_ = std::make_unique<Run>(scene, start.state, 0.0, 0, false);
    run_->meet_tolerance_at_once(abandon);
    run_->start_remark = std::move(start.remark);
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

const Scene& Simulation::scene() const {
    return run_->scene;
}
const Model& Simulation::model() const {
    return run_->engine->model();
}

void Simulation::put(const State<double>& state, std::optional<double> time) {
    run_->put(state, time.value_or(run_->now.time()));
}

void Simulation::change(const Scene& scene, const std::atomic<bool>* abandon) {
    check_scene(scene);
    if (same_structure(run_->scene, scene))
        run_->refill(scene, abandon);
    else
        rebuild(scene, abandon);
    if (scene.flag.start == Start::flat && is_pushed_across(model())) run_->start_remark.clear();  // its plane is left
}

void Simulation::rebuild(const Scene& scene, const std::atomic<bool>* abandon) {
    const StartState start =
        goes_on(run_->scene.flag, scene.flag)
            ? StartState{carried_over(run_->engine->state(run_->now.time()), scene), run_->start_remark}
            : start_state(scene, abandon);
    auto next = std::make_unique<Run>(scene, start.state, run_->now.time(), run_->now.steps, run_->exact);
    next->start_remark = start.remark;
    next->use_threads(run_->threads);
    next->error_mode = run_->error_mode;
    next->pull = run_->pull;
    next->meet_tolerance_at_once(abandon);
    run_ = std::move(next);
}

std::optional<Divergence> Simulation::advance_batch(const std::atomic<bool>* abandon) {
    return run_->advance(steps_per_batch(), abandon);
}

std::optional<Divergence> Simulation::advance_steps(long long count, const std::atomic<bool>* abandon) {
    return run_->advance(count, abandon);
}

std::optional<Divergence> Simulation::check() {
    return run_->check();
}

void Simulation::pull(const std::optional<Pull>& by) {
    run_->pull = by;
}
double Simulation::pull_force() const {
    return run_->pulled.force();
}

void Simulation::use_exact_dt() {
    run_->exact = true;
    run_->restart_clock(run_->now.time(), run_->now.steps);
}

void Simulation::use_threads(int threads) {
    run_->use_threads(threads);
}

double Simulation::time() const {
    return run_->now.time();
}
long long Simulation::steps() const {
    return run_->now.steps;
}
double Simulation::dt() const {
    return run_->now.clock.dt;
}
long long Simulation::steps_per_batch() const {
    return std::max(1LL, std::llround(batch_seconds / run_->now.clock.dt));
}
StableStep Simulation::stability_limit() const {
    return run_->stable();
}

const Solves& Simulation::solves() const {
    return run_->solves;
}

void Simulation::watch_error(ErrorWatch::Mode mode) {
    run_->error_mode = mode;
    run_->errors.restart();
}
void Simulation::use_own_thread() {
    run_->errors.use_own_thread();
}
const std::optional<ErrorEstimate>& Simulation::error() const {
    return run_->error;
}
ErrorWindow Simulation::error_window() const {
    return run_->window();
}
ErrorEstimate Simulation::error_since(const ErrorWindow& begin) const {
    ErrorWindow window = begin;
    window.seconds = run_->now.time() - begin.time;
    return run_->error_of(window);
}

Precision Simulation::precision() const {
    return run_->precision;
}

const std::string& Simulation::start_remark() const {
    return run_->start_remark;
}

void Simulation::snapshot(Snapshot& into) const {
    run_->engine->snapshot(into.position);
    into.time = run_->now.time();
    into.steps = run_->now.steps;
}

void Simulation::velocity(Snapshot& into) const {
    run_->engine->velocity(into.velocity);
}

Readings Simulation::readings() const {
    const double now = run_->now.time();
    const auto here = run_->engine->measure(now);
    return {.kinetic_energy = here.kinetic_now,
            .spring_energy = here.elastic,
            .gravity_energy = run_->engine->model().potential(here.moment),
            .max_stretch = here.max_stretch,
            .mean_stretch = here.mean_stretch,
            .max_spring_force = here.max_force,
            .rms_spring_force = here.rms_force,
            .created_share = knows_work(run_->scene.time.method) ? std::optional(run_->watch.ledger().created_share())
                                                                 : std::nullopt,
            .limit = run_->limit,
            .time = now};
}

const Readings& Simulation::recent_readings() {
    if (run_->readings_batches >= run_->batches_between_readings()) {
        run_->readings = readings();
        run_->readings_batches = 0;
    }
    return run_->readings;
}

std::uint64_t Simulation::state_hash() const {
    return run_->engine->state_hash();
}

State<double> Simulation::state() const {
    return run_->engine->state(run_->now.time());
}

std::shared_ptr<const KeptRun> Simulation::keep() const {
    return run_->keep();
}

void Simulation::restore(const KeptRun& kept) {
    run_->restore(*kept.parts_);
}

}  // namespace drapeau
