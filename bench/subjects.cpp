#include "subjects.hpp"

#include "cloth_check.hpp"
#include "composition.hpp"
#include "evaluation.hpp"
#include "report_arrangement.hpp"

#include "kernels/kernels.hpp"
#include "run/engine.hpp"
#include "run/simulation.hpp"
#include "run/start_state.hpp"

#include "drapeau/stability.hpp"

#include <cstring>

namespace drapeau::bench {
namespace {

Model case_model(const Case& c) {
    return model_of(scene_of(c));
}

class EngineSteps : public Subject {
public:
    EngineSteps(const Case& c, const State<double>& start)
        : engine_(make_engine(case_model(c), c.method, c.precision)) {
        dt = auto_step(c.method, engine_->model());
        engine_->use_threads(c.threads);
        engine_->set(start);
        // The first step lets the method start, which later ones do not have to.
        advance(1, no_step);
        engine_->save(0);
    }
    void restore() override {
        engine_->restore(0);
        steps_ = 1;
    }
    void run(int times) override { advance(times, no_step); }
    std::uint64_t hash() const override { return engine_->state_hash(); }
    double greatest_stretch() const override { return stretch_if_finite(engine_->measure(now())); }
    long long steps() const override { return steps_; }
    State<double> state() const { return engine_->state(now()); }

protected:
    void advance(int count, long long accounted) {
        engine_->advance({.dt = dt}, steps_, steps_ + count, accounted, report_, nullptr);
        steps_ += count;
    }
    double now() const { return static_cast<double>(steps_) * dt; }

    std::unique_ptr<Engine> engine_;
    Report report_;
    long long steps_ = 0;
};

class AccountedSteps final : public EngineSteps {
public:
    using EngineSteps::EngineSteps;
    void run(int times) override {
        for (int n = 0; n < times; ++n) advance(1, steps_);
    }
};

class Measurements final : public EngineSteps {
public:
    using EngineSteps::EngineSteps;
    void restore() override {}
    void run(int times) override {
        for (int n = 0; n < times; ++n) here_ = engine_->measure(now());
    }
    std::uint64_t hash() const override {
        std::uint64_t hash = 0;
        for (const double value : {here_.kinetic, here_.elastic, here_.power, here_.mean_stretch, here_.max_stretch,
                                   here_.rms_force, here_.max_force, here_.moment.x, here_.moment.y, here_.moment.z})
            hash = mix(hash ^ std::bit_cast<std::uint64_t>(value));
        return hash;
    }

private:
    Measurement here_;
};

/// Looks at the fastest mode, which each engine finds anew and then keeps.
class ModeLooks final : public EngineSteps {
public:
    ModeLooks(const Case& c, const State<double>& start) : EngineSteps(c, start), case_(c), start_(start) {}
    void restore() override { static_cast<EngineSteps&>(*this) = EngineSteps(case_, start_); }
    void run(int times) override { mode_ = engine_->fastest_mode(2.0, 2.0, dt, times, 0.0); }
    std::uint64_t hash() const override { return std::bit_cast<std::uint64_t>(mode_.stiffness); }

private:
    Case case_;
    const State<double>& start_;
    Oscillator mode_{};
};

/// What the simulation's thread hands to the window each frame.
class Snapshots final : public EngineSteps {
public:
    using EngineSteps::EngineSteps;
    void restore() override {}
    void run(int times) override {
        for (int n = 0; n < times; ++n) engine_->snapshot(snapshot_);
    }
    std::uint64_t hash() const override { return hash_of(0, snapshot_); }

private:
    FieldBuffer<float> snapshot_;
};

/// Batches as the simulation's thread takes them for the window.
class WatchedBatches final : public Subject {
public:
    explicit WatchedBatches(const Case& c) : scene_(scene_of(c)), threads_(c.threads) {
        scene_.time.dt = dt = auto_step(c.method, case_model(c));
        restore();
        steps_a_time = simulation_->steps_per_batch();
    }
    void restore() override {
        simulation_.emplace(scene_);
        simulation_->use_threads(threads_);
        run(1);  // as with plain steps
    }
    void run(int times) override {
        for (int n = 0; n < times; ++n) {
            diverged_ = diverged_ || simulation_->advance_batch();
            readings_ = simulation_->recent_readings();
            simulation_->snapshot(snapshot_);
        }
    }
    std::uint64_t hash() const override { return simulation_->state_hash(); }
    double greatest_stretch() const override {
        const Readings here = simulation_->readings();
        const bool finite = std::isfinite(here.kinetic_energy + here.spring_energy);
        return finite && !diverged_ ? here.max_stretch : std::numeric_limits<double>::quiet_NaN();
    }
    long long steps() const override { return simulation_->steps(); }

private:
    Scene scene_;
    int threads_;
    std::optional<Simulation> simulation_;
    Readings readings_;
    Snapshot snapshot_;
    bool diverged_ = false;
};

/// Of a state in whatever precision, by the double kernels.
double greatest_stretch_of(const Case& c, const State<double>& state) {
    const auto engine = make_engine(case_model(c), c.method, Precision::double_precision);
    engine->set(state);
    return stretch_if_finite(engine->measure(0.0));
}

template <class Real>
class Forces final : public Subject {
public:
    Forces(const Case& c, const State<double>& start) : Forces(c, start, case_model(c)) {}
    void restore() override {}
    void run(int times) override {
        for (int n = 0; n < times; ++n) evaluation_.run();
    }
    std::uint64_t hash() const override { return hash_of(0, evaluation_.result()); }
    double greatest_stretch() const override { return greatest_stretch_of(case_, start_); }

private:
    Forces(const Case& c, const State<double>& start, const Model& model)
        : case_(c),
          start_(start),
          evaluation_(model, find_kernels<Real>(c.method, model.has_diagonals(), model.is_damped()), start,
                      auto_step(c.method, model)) {}

    const Case case_;
    const State<double>& start_;
    Evaluation<Real> evaluation_;
};

template <class Real>
State<Real> in(const State<double>& state) {
    State<Real> other(state.columns(), state.rows());
    other.position.take(state.position);
    other.velocity.take(state.velocity);
    return other;
}

template <class Real>
class Copies final : public Subject {
public:
    Copies(const Case& c, const State<double>& start)
        : case_(c), start_(start), from_(in<Real>(start)), to_(c.columns, c.rows) {}
    void restore() override {}
    void run(int times) override {
        for (int n = 0; n < times; ++n) copy(from_.position, to_.position), copy(from_.velocity, to_.velocity);
    }
    std::uint64_t hash() const override { return hash_of(to_); }
    double greatest_stretch() const override { return greatest_stretch_of(case_, start_); }

private:
    static void copy(const FieldBuffer<Real>& from, FieldBuffer<Real>& to) {
        for (int c = 0; c < 3; ++c) {
            std::memcpy(to.component(c).data(), from.component(c).data(), from.component(c).size() * sizeof(Real));
            asm volatile("" ::: "memory");  // every copy is made, not only the last
        }
    }

    const Case case_;
    const State<double>& start_;
    State<Real> from_, to_;
};

template <class Real>
class ReportSteps final : public Subject {
public:
    ReportSteps(const Case& c, const State<double>& start) : case_(c), start_(start), flag_(arranged(c)) {
        dt = auto_step(c.method, case_model(c));
        restore();
    }
    void restore() override {
        for (int j = 0; j < case_.rows; ++j)
            for (int i = 0; i < case_.columns; ++i) flag_.set(i, j, start_.position.at(i, j), start_.velocity.at(i, j));
    }
    void run(int times) override { flag_.advance(dt, times); }
    std::uint64_t hash() const override { return hash_of(state()); }
    double greatest_stretch() const override { return greatest_stretch_of(case_, state()); }

private:
    static ReportArrangement<Real> arranged(const Case& c) {
        const Scene scene = scene_of(c);
        const Model model = model_of(scene);
        const auto& terms = model.terms;
        return {model.grid,
                scene.flag.attach,
                model.springs,
                {.gravity = terms.get<Gravity>()->acceleration,
                 .wind = terms.get<Wind>()->velocity,
                 .drag = terms.get<AirDrag>()->d}};
    }
    State<double> state() const {
        State<double> state(case_.columns, case_.rows);
        for (int j = 0; j < case_.rows; ++j)
            for (int i = 0; i < case_.columns; ++i) {
                state.position.set(i, j, flag_.position(i, j));
                state.velocity.set(i, j, flag_.velocity(i, j));
            }
        return state;
    }

    const Case case_;
    const State<double>& start_;
    ReportArrangement<Real> flag_;
};

std::unique_ptr<Subject> composition(const Case& c, const State<double>& start) {
    const Scene scene = scene_of(c);
    const Model model = model_of(scene);
    const Grid& grid = model.grid;
    const Springs& springs = model.springs;
    const auto& gravity = model.terms.get<Gravity>();
    const auto& drag = model.terms.get<AirDrag>();
    const auto& wind = model.terms.get<Wind>();
    const glm::dvec3 g = gravity ? gravity->acceleration : glm::dvec3(0.0);
    const glm::dvec3 w = wind ? wind->velocity : glm::dvec3(0.0);
    return make_composition({.columns = grid.columns,
                             .rows = grid.rows,
                             .pitch_x = grid.pitch_x,
                             .pitch_y = grid.pitch_y,
                             .attach = scene.flag.attach,
                             .mass = springs.mass,
                             .stiffness = springs.stiffness,
                             .diagonal_stiffness = springs.diagonal_stiffness.value_or(0.0),
                             .damping = springs.damping.value_or(0.0),
                             .gravity = {g.x, g.y, g.z},
                             .drag = drag ? drag->d : 0.0,
                             .wind = {w.x, w.y, w.z},
                             .has_diagonals = model.has_diagonals(),
                             .is_damped = model.is_damped(),
                             .has_gravity = gravity.has_value(),
                             .has_drag = drag.has_value(),
                             .has_wind = wind.has_value(),
                             .in_double = c.precision == Precision::double_precision,
                             .position = start.position.view(),
                             .velocity = start.velocity.view()});
}

template <template <class> class SubjectOf>
std::unique_ptr<Subject> in_precision(const Case& c, const State<double>& start) {
    if (c.precision == Precision::double_precision) return std::make_unique<SubjectOf<double>>(c, start);
    return std::make_unique<SubjectOf<float>>(c, start);
}

State<double> rippled(const Grid& grid) {
    constexpr double pi = 3.14159265358979323846;
    constexpr double wave_length = 0.6, amplitude = 0.04, wave_speed = 3.0;  // m, m, m/s
    constexpr double shortening = 0.95;                                      // the cloth's length goes into the ripple
    State<double> state(grid.columns, grid.rows);
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            const auto rest = grid.rest(i, j);
            const double phase = 2.0 * pi * (rest.x + 0.3 * rest.y) / wave_length;
            const double slope = 2.0 * pi / wave_length * amplitude * std::cos(phase);
            state.position.set(i, j, {shortening * rest.x, rest.y, amplitude * std::sin(phase)});
            state.velocity.set(i, j, {0.1 * std::sin(phase), -0.1 * std::cos(phase), -wave_speed * slope});
        }
    return state;
}

}  // namespace

std::unique_ptr<Subject> make_subject(const Case& c, const State<double>& start) {
    switch (c.work) {
        case Work::step:
            return std::make_unique<EngineSteps>(c, start);
        case Work::watched:
            return std::make_unique<WatchedBatches>(c);
        case Work::accounted:
            return std::make_unique<AccountedSteps>(c, start);
        case Work::measure:
            return std::make_unique<Measurements>(c, start);
        case Work::mode:
            return std::make_unique<ModeLooks>(c, start);
        case Work::terms:
            return composition(c, start);
        case Work::forces:
            return in_precision<Forces>(c, start);
        case Work::snapshot:
            return std::make_unique<Snapshots>(c, start);
        case Work::copy:
            return in_precision<Copies>(c, start);
        case Work::report:
            break;
    }
    return in_precision<ReportSteps>(c, start);
}

std::unique_ptr<Subject> make_plain_rival(const Case& c, const State<double>& start) {
    return std::make_unique<EngineSteps>(c, c.work == Work::watched ? start_state(scene_of(c)).state : start);
}

const State<double>& flying_state(int columns, int rows) {
    // Large states are kept one at a time; cases come with their grids in order.
    static State<double> kept;
    if (columns == kept.columns() && rows == kept.rows()) return kept;
    EngineSteps flag({.columns = columns, .rows = rows, .precision = Precision::double_precision},
                     rippled(case_model({.columns = columns, .rows = rows}).grid));
    flag.run(31);
    return kept = flag.state();
}

double auto_step(Method method, const Model& model) {
    return with_method(method, [&](const auto& m) { return whole_steps_per_batch(automatic_step(m, model)); });
}

}  // namespace drapeau::bench
