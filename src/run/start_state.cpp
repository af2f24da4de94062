#include "run/start_state.hpp"

#include "drapeau/precision.hpp"
#include "drapeau/stability.hpp"
#include "drapeau/start.hpp"

#include <algorithm>
#include <cmath>

namespace drapeau {
namespace {

constexpr std::uint64_t crumple_seed = 1;

/// Bilinear in the flag's own coordinates: column and row as shares of the way along and down.
glm::dvec3 sample(const FieldBuffer<double>& field, double along, double down) {
    const auto split = [](double share, int count, int& n) {
        const double place = share * (count - 1);
        n = std::clamp(static_cast<int>(place), 0, std::max(count - 2, 0));
        return count > 1 ? place - n : 0.0;
    };
    int i = 0, j = 0;
    const double a = split(along, field.columns(), i), b = split(down, field.rows(), j);
    const int i2 = std::min(i + 1, field.columns() - 1), j2 = std::min(j + 1, field.rows() - 1);
    return (1.0 - b) * ((1.0 - a) * field.at(i, j) + a * field.at(i2, j)) +
           b * ((1.0 - a) * field.at(i, j2) + a * field.at(i2, j2));
}

double share(int n, int count) {
    return count > 1 ? static_cast<double>(n) / (count - 1) : 0.0;
}

/// Stops every mass and lets it go with half a kick, x + dt^2 a/2 and dt a/2, as leapfrog starts. A whole kick would
/// give the fastest modes energy, five times what they had at nine tenths of the largest step.
void let_go(Engine& engine, double dt) {
    const auto before = engine.state(0.0);
    State<double> stopped(before.columns(), before.rows());
    stopped.position = before.position;
    engine.set(stopped);
    Report ignored;
    engine.advance({.dt = dt}, 0, 1, no_step, ignored, nullptr);
    auto after = engine.state(0.0);
    for (int j = 0; j < after.rows(); ++j)
        for (int i = 0; i < after.columns(); ++i) {
            after.position.set(i, j, 0.5 * (before.position.at(i, j) + after.position.at(i, j)));
            after.velocity.set(i, j, 0.5 * after.velocity.at(i, j));
        }
    engine.set(after);
}

/// Lets a flag come to rest under gravity: whenever its kinetic energy falls, all of it is taken out (kinetic damping).
/// Bounded in work, so that a large grid starts soon, if not quite at rest.
State<double> settled(const Scene& scene, const State<double>& start) {
    constexpr double mass_steps = 1.5e8;  // about a second of one core
    constexpr double still = 1e-4;        // m/s, root mean square
    Scene quiet = scene;
    quiet.wind().reset();
    quiet.time.method = method_id<SemiImplicitEuler>;
    const Model model = model_of(quiet);
    const auto engine = make_engine(model, quiet.time.method, Precision::double_precision);

    const double dt = std::min(0.9 * stable_step(SemiImplicitEuler{}, model).seconds(), batch_seconds);
    const double total_mass = model.springs.mass * static_cast<double>(model.grid.masses());
    const auto max_steps = static_cast<long long>(mass_steps / static_cast<double>(model.grid.masses()));
    constexpr long long look_every = 8;

    double before = 0.0;
    bool moved = false;
    engine->set(start);
    Report ignored;
    for (long long step = 0; step < max_steps; step += look_every) {
        engine->advance({.dt = dt}, 0, look_every, no_step, ignored, nullptr);
        const double kinetic = engine->kinetic();
        if (kinetic < before) {
            if (moved && before < 0.5 * total_mass * still * still) break;
            let_go(*engine, dt);
            before = 0.0;
            moved = true;
        } else {
            before = kinetic;
        }
    }
    State<double> rest = engine->state(0.0);
    rest.velocity = FieldBuffer<double>(rest.columns(), rest.rows());
    return rest;
}

/// A flag exactly in its plane would stay in it: the lightest of folds, `size` high (m), let it choose a side.
void ripple(State<double>& state, const Model& model, double size) {
    const Grid& grid = model.grid;
    if (size == 0.0) return;
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i)
            if (!model.held(i, j)) {
                auto x = state.position.at(i, j);
                x.z += size * smooth_noise(crumple_seed, 103, 5.0 * i * grid.pitch_x + 0.37 * j);
                state.position.set(i, j, x);
            }
}

}  // namespace

State<double> start_state(const Scene& scene) {
    const Model model = model_of(scene);
    const Grid& grid = model.grid;
    const double prestretch = scene.flag.prestretch;
    auto state = scene.flag.start == Start::crumpled ? crumpled_start(model, prestretch, crumple_seed)
                                                     : flat_start(grid, prestretch);
    if (scene.flag.start == Start::flat) {
        constexpr double unseen = 1e-9;  // m
        const bool in_plane = grid.columns > 1 && grid.rows > 1 && !is_pushed_across(model);
        ripple(state, model, scene.flag.disturbance.value_or(in_plane ? unseen : 0.0));
    }
    const bool can_hang = scene.gravity() && scene.flag.attach != Attach::none;  // otherwise it would fall for ever
    if (scene.flag.start != Start::hanging || !can_hang) return state;

    ripple(state, model, 0.02 * grid.pitch_x);
    return settled(scene, state);
}

State<double> carried_over(const State<double>& old, const Scene& scene) {
    const Model model = model_of(scene);
    const Grid& grid = model.grid;
    State<double> state(grid.columns, grid.rows);
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            const bool held = model.held(i, j);
            const double along = share(i, grid.columns), down = share(j, grid.rows);
            state.position.set(
                i, j, held ? (1.0 + scene.flag.prestretch) * grid.rest(i, j) : sample(old.position, along, down));
            if (!held) state.velocity.set(i, j, sample(old.velocity, along, down));
        }
    return state;
}

}  // namespace drapeau
