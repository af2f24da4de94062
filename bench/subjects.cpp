#include "subjects.hpp"

#include "cloth_check.hpp"
#include "report_arrangement.hpp"

#include "kernels/kernels.hpp"

#include <cstring>

namespace drapeau::bench {
namespace {

Physics physics_of(const Case& c) {
    return Physics(flag_scene(c.columns, c.rows, c.method, c.terms));
}

class EngineSteps : public Subject {
public:
    EngineSteps(const Case& c, const Masses& start)
        : physics_(physics_of(c)), engine_(make_engine(physics_, c.precision)) {
        dt = auto_step(physics_.largest_step());
        engine_->use_threads(c.threads);
        engine_->set(start);
        engine_->keep();
    }
    void restore() override { engine_->return_to_kept(); }
    void run(int times) override { engine_->advance({.dt = dt}, 0, times); }
    std::uint64_t hash() const override { return engine_->state_hash(); }
    double greatest_stretch() const override { return stretch_if_finite(engine_->energy()); }

protected:
    Physics physics_;
    std::unique_ptr<Engine> engine_;
};

/// What the simulation's thread hands to the window each frame.
class Snapshots final : public EngineSteps {
public:
    using EngineSteps::EngineSteps;
    void restore() override {}
    void run(int times) override {
        for (int n = 0; n < times; ++n) engine_->snapshot(snapshot_);
    }
    std::uint64_t hash() const override {
        std::uint64_t hash = 0;
        for (const auto* component : {&snapshot_.x, &snapshot_.y, &snapshot_.z})
            for (const float value : *component) hash = mix(hash ^ std::bit_cast<std::uint32_t>(value));
        return hash;
    }

private:
    Snapshot snapshot_;
};

template <class Real>
class Forces final : public Subject {
public:
    Forces(const Case& c, const Masses& start)
        : physics_(physics_of(c)),
          kernel_(find_kernel<Real>(c.method, c.terms.diagonal, c.terms.damping)),
          cloth_(physics_.grid),
          fabric_(physics_.grid, physics_.attach, physics_.material),
          buffers_(cloth_.width()) {
        set_masses(cloth_, start, physics_.attach);
        for (auto& component : force_) component = Array<Real>(cloth_.count());
    }
    void restore() override {}
    void run(int times) override {
        const ForceRow<Real> force{force_[0].data(), force_[1].data(), force_[2].data()};
        for (int n = 0; n < times; ++n) kernel_.spring_forces(cloth_.view(), fabric_.view(), force, buffers_);
    }
    std::uint64_t hash() const override {
        std::uint64_t hash = 0;
        for (int j = 0; j < physics_.grid.rows; ++j)
            for (int i = 0; i < physics_.grid.columns; ++i) {
                const auto n = static_cast<std::size_t>(j) * cloth_.stride() + i;
                hash = hash_of(hash, glm::dvec3(force_[0][n], force_[1][n], force_[2][n]));
            }
        return hash;
    }
    double greatest_stretch() const override { return stretch_if_finite(measure(cloth_, physics_.material)); }

private:
    Physics physics_;
    const Kernel<Real>& kernel_;
    Cloth<Real> cloth_;
    Fabric<Real> fabric_;
    SweepBuffers<Real> buffers_;
    Array<Real> force_[3];
};

template <class Real>
class Copies final : public Subject {
public:
    Copies(const Case& c, const Masses& start) : physics_(physics_of(c)), from_(physics_.grid), to_(physics_.grid) {
        set_masses(from_, start, physics_.attach);
    }
    void restore() override {}
    void run(int times) override {
        for (int n = 0; n < times; ++n)
            for (int c = 0; c < 6; ++c) {
                std::memcpy(to_.component(c).data(), from_.component(c).data(), from_.count() * sizeof(Real));
                asm volatile("" ::: "memory");  // every copy is made, not only the last
            }
    }
    std::uint64_t hash() const override { return hash_of(to_, physics_.grid); }
    double greatest_stretch() const override { return stretch_if_finite(measure(to_, physics_.material)); }

private:
    Physics physics_;
    Cloth<Real> from_, to_;
};

template <class Real>
class ReportSteps final : public Subject {
public:
    ReportSteps(const Case& c, const Masses& start)
        : physics_(physics_of(c)),
          start_(start),
          flag_(physics_.grid, physics_.attach, physics_.material,
                {.gravity = physics_.gravity.acceleration, .wind = physics_.wind.wind.mean, .drag = physics_.drag.d}) {
        dt = auto_step(physics_.largest_step());
        restore();
    }
    void restore() override {
        std::size_t n = 0;
        for (int j = 0; j < physics_.grid.rows; ++j)
            for (int i = 0; i < physics_.grid.columns; ++i, ++n) flag_.set(i, j, start_.x[n], start_.v[n]);
    }
    void run(int times) override { flag_.advance(dt, times); }
    std::uint64_t hash() const override { return hash_of(flag_, physics_.grid); }
    double greatest_stretch() const override {
        Cloth<Real> cloth(physics_.grid);
        for (int j = 0; j < physics_.grid.rows; ++j)
            for (int i = 0; i < physics_.grid.columns; ++i) {
                cloth.set_position(i, j, flag_.position(i, j));
                cloth.set_velocity(i, j, flag_.velocity(i, j));
            }
        return stretch_if_finite(measure(cloth, physics_.material));
    }

private:
    Physics physics_;
    const Masses& start_;
    ReportArrangement<Real> flag_;
};

template <template <class> class SubjectOf>
std::unique_ptr<Subject> in_precision(const Case& c, const Masses& start) {
    if (c.precision == Precision::double_precision) return std::make_unique<SubjectOf<double>>(c, start);
    return std::make_unique<SubjectOf<float>>(c, start);
}

Masses rippled(const Grid& grid) {
    constexpr double pi = 3.14159265358979323846;
    constexpr double wave_length = 0.6, amplitude = 0.04, wave_speed = 3.0;  // m, m, m/s
    constexpr double shortening = 0.95;                                      // the cloth's length goes into the ripple
    Masses masses;
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            const auto rest = grid.rest(i, j);
            const double phase = 2.0 * pi * (rest.x + 0.3 * rest.y) / wave_length;
            const double slope = 2.0 * pi / wave_length * amplitude * std::cos(phase);
            masses.x.push_back({shortening * rest.x, rest.y, amplitude * std::sin(phase)});
            masses.v.push_back({0.1 * std::sin(phase), -0.1 * std::cos(phase), -wave_speed * slope});
        }
    return masses;
}

}  // namespace

std::unique_ptr<Subject> make_subject(const Case& c, const Masses& start) {
    switch (c.work) {
        case Work::step:
            return std::make_unique<EngineSteps>(c, start);
        case Work::terms:
            return make_composition(c, start);
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

const Masses& start_state(int columns, int rows) {
    // Large states are kept one at a time; cases come with their grids in order.
    static int kept_columns = 0, kept_rows = 0;
    static Masses kept;
    if (columns == kept_columns && rows == kept_rows) return kept;
    kept = {};
    const Physics physics(flag_scene(columns, rows, Method::semi_implicit_euler, Terms{}));
    const auto engine = make_engine(physics, Precision::double_precision);
    engine->set(rippled(physics.grid));
    engine->advance({.dt = auto_step(physics.largest_step())}, 0, 32);
    kept = engine->masses();
    kept_columns = columns, kept_rows = rows;
    return kept;
}

double auto_step(double largest_stable) {
    return whole_steps_per_batch(std::min(0.9 * largest_stable, batch_seconds));
}

}  // namespace drapeau::bench
