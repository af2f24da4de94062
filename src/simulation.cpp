#include "simulation.hpp"

#include "divergence.hpp"
#include "engine.hpp"
#include "error.hpp"
#include "scene_file.hpp"
#include "start_state.hpp"

#include <cmath>

namespace drapeau {
namespace {

constexpr double safety_factor = 0.9;

/// The step the scene asks for, or the largest the closed bound allows.
double chosen_step(const Scene& scene, const Physics& physics) {
    if (scene.time.dt) return *scene.time.dt;
    const double limit = physics.largest_step();
    if (limit > 0.0) return std::min(safety_factor * limit, batch_seconds);
    const double wanted = std::min(safety_factor * largest_step(SemiImplicitEuler{}, physics.rates()), batch_seconds);
    char line[240];
    std::snprintf(line, sizeof line,
                  "time.dt = \"auto\": forward-euler has no stable step without drag or friction; "
                  "for a step of %s their sum must exceed %.3g N s/m, or choose semi-implicit-euler",
                  in_words(wanted).c_str(), damping_needed(ForwardEuler{}, physics.rates(), wanted));
    throw InputError(line);
}

/// What must be the same for position and velocity to go on through a change of scene.
bool goes_on(const FlagSettings& from, const FlagSettings& to) {
    return from.attach == to.attach && from.start == to.start && from.prestretch == to.prestretch;
}

}  // namespace

double whole_steps_per_batch(double dt) {
    // A step that divides the batch up to rounding divides it.
    constexpr double rounding = 1e-9;
    return batch_seconds / std::max(1.0, std::ceil(batch_seconds / dt * (1.0 - rounding)));
}

struct Simulation::Run {
    Scene scene;
    Physics physics;
    std::unique_ptr<Engine> engine;
    EnergyBudget budget;
    Clock clock;
    int threads = 1;
    long long steps = 0;

    Run(const Scene& wanted, Masses masses)
        : scene(wanted),
          physics(wanted),
          engine(make_engine(physics, wanted.time.precision)),
          budget(physics, (engine->set(masses), engine->energy())),
          clock{.dt = whole_steps_per_batch(chosen_step(wanted, physics))} {}

    double time() const { return clock.at(steps); }

    std::optional<Divergence> advance(long long count, const std::atomic<bool>* abandon) {
        const long long last = steps + count;
        engine->keep();
        if (!engine->advance(clock, steps, last, abandon)) {
            engine->return_to_kept();
            return {};
        }
        const auto more = budget.with_work_since_kept(*engine, physics, clock.at(steps), clock.at(last));
        if (has_diverged(engine->energy(), more.could_have()))
            return explain_divergence(*engine, physics, budget, clock, steps, last);
        budget = more;
        steps = last;
        return {};
    }

    void use_threads(int count) {
        threads = count;
        engine->use_threads(count);
    }

    static double dot(const glm::dvec3& a, const glm::dvec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
};

Simulation::Simulation(const Scene& scene) {
    check_scene(scene);
    run_ = std::make_unique<Run>(scene, start_masses(scene));
}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

const Scene& Simulation::scene() const {
    return run_->scene;
}

void Simulation::change(const Scene& scene) {
    check_scene(scene);
    auto next = std::make_unique<Run>(scene, goes_on(run_->scene.flag, scene.flag)
                                                 ? carried_over(run_->engine->masses(), run_->physics.grid, scene)
                                                 : start_masses(scene));
    next->clock.start = run_->time();
    next->clock.first = next->steps = run_->steps;
    next->use_threads(run_->threads);
    run_ = std::move(next);
}

std::optional<Divergence> Simulation::advance_batch(const std::atomic<bool>* abandon) {
    return run_->advance(steps_per_batch(), abandon);
}

std::optional<Divergence> Simulation::advance_steps(long long count) {
    return run_->advance(count, nullptr);
}

void Simulation::use_exact_dt() {
    run_->clock = {.start = run_->time(), .first = run_->steps, .dt = chosen_step(run_->scene, run_->physics)};
}

void Simulation::use_threads(int threads) {
    run_->use_threads(threads);
}

double Simulation::time() const {
    return run_->time();
}
long long Simulation::steps() const {
    return run_->steps;
}
double Simulation::dt() const {
    return run_->clock.dt;
}
int Simulation::steps_per_batch() const {
    return std::max(1, static_cast<int>(std::lround(batch_seconds / run_->clock.dt)));
}
double Simulation::stability_limit() const {
    return run_->physics.largest_step();
}

void Simulation::snapshot(Snapshot& into) const {
    run_->engine->snapshot(into);
    into.time = run_->time();
    into.steps = run_->steps;
}

Readings Simulation::readings() const {
    const auto energy = run_->engine->energy();
    const auto masses = run_->engine->masses();
    double gravity = 0.0;
    for (const auto& x : masses.x)
        gravity -= run_->physics.material.mass * Run::dot(run_->physics.gravity.acceleration, x);
    return {.kinetic_energy = energy.kinetic,
            .spring_energy = energy.spring,
            .gravity_energy = gravity,
            .greatest_stretch = energy.greatest_stretch,
            .mean_stretch = energy.mean_stretch,
            .greatest_spring_force = energy.greatest_force};
}

std::uint64_t Simulation::state_hash() const {
    return run_->engine->state_hash();
}

std::vector<double> Simulation::state() const {
    const auto masses = run_->engine->masses();
    std::vector<double> all;
    all.reserve(6 * masses.x.size());
    for (std::size_t n = 0; n < masses.x.size(); ++n)
        for (const auto& part : {masses.x[n], masses.v[n]})
            for (int k = 0; k < 3; ++k) all.push_back(part[k]);
    return all;
}

}  // namespace drapeau
