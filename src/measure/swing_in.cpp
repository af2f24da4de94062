#include "measure/swing_in.hpp"

#include "io/error.hpp"
#include "measure/clocks.hpp"
#include "run/simulation.hpp"

#include "drapeau/stability.hpp"

#include <algorithm>
#include <cmath>

namespace drapeau {

namespace {

bool has_free_masses(const Model& model) {
    for (int j = 0; j < model.grid.rows; ++j)
        for (int i = 0; i < model.grid.columns; ++i)
            if (!model.held(i, j)) return true;
    return false;
}

}  // namespace

Scene as_reference(Scene scene) {
    scene.time.method = method_id<Rk4>;
    scene.time.precision = Precision::double_precision;
    scene.time.dt.reset();
    scene.time.tolerance.reset();
    return scene;
}

SwungIn swing_in(const Scene& scene, double seconds, const std::function<void()>& tick) {
    SwungIn there;
    Simulation simulation(as_reference(scene));
    const auto batches = std::llround(seconds / batch_seconds);
    std::optional<Divergence> divergence;
    for (long long batch = 0; batch < batches && !divergence; ++batch) {
        divergence = simulation.advance_batch();
        tick();
    }
    if (!divergence) divergence = simulation.check();
    if (divergence) there.diverged = divergence->message;
    there.state = simulation.state();
    there.time = simulation.time();
    return there;
}

long long trusted_batches(double horizon) {
    constexpr double trusted = 0.5;  // of the horizon
    return std::max(1LL, static_cast<long long>(std::floor(trusted * horizon / batch_seconds)));
}

long long sampling(const Grid& grid, long long batches) {
    constexpr double most_samples = 60.0, most_numbers = 3e6;
    const double samples = std::clamp(most_numbers / (3.0 * static_cast<double>(grid.masses())), 2.0, most_samples);
    return std::max(1LL, static_cast<long long>(std::ceil(static_cast<double>(batches) / samples)));
}

double finest_goal(const Model& model) {
    const Grid& grid = model.grid;
    return 1e-12 * std::hypot(grid.columns * grid.pitch_x, grid.rows * grid.pitch_y);
}

void check_that_it_moves(const Model& model) {
    if (!has_free_masses(model)) throw InputError("flag.attach: every mass is held, so there is no motion to compare");
}

double measured_unit(const Model& model) {
    constexpr double long_enough = 0.02;  // s
    constexpr long long most_steps = 64;  // of one of several measurements
    const auto engine = make_engine(model, method_id<Rk4>, Precision::double_precision);
    const double dt = std::min(0.1 * stable_step(Rk4{}, model).seconds(), batch_seconds);
    // The least of several, of this thread's own time: whatever else the machine does comes and goes.
    const double began = thread_seconds();
    double least = INFINITY;  // s a step
    long long done = 0;
    for (long long steps = 1; thread_seconds() - began < long_enough; steps = std::min(2 * steps, most_steps)) {
        Report report;
        const double before = thread_seconds();
        engine->advance({.dt = dt}, done, done + steps, no_step, report, nullptr);
        least = std::min(least, (thread_seconds() - before) / static_cast<double>(steps));
        done += steps;
    }
    return least / engine->step_cost();
}

}  // namespace drapeau
