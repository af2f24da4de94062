#include "start_state.hpp"

#include "drapeau/start.hpp"

#include <algorithm>
#include <cmath>

namespace drapeau {
namespace {

constexpr std::uint64_t crumple_seed = 1;

/// Bilinear in the flag's own coordinates: column and row as shares of the way along and down.
template <class Field>
glm::dvec3 sample(const Field& field, const Grid& from, double along, double down) {
    const auto split = [](double share, int count, int& n) {
        const double place = share * (count - 1);
        n = std::clamp(static_cast<int>(place), 0, std::max(count - 2, 0));
        return count > 1 ? place - n : 0.0;
    };
    int i = 0, j = 0;
    const double a = split(along, from.columns, i), b = split(down, from.rows, j);
    const int i2 = std::min(i + 1, from.columns - 1), j2 = std::min(j + 1, from.rows - 1);
    const auto at = [&](int column, int row) { return field[static_cast<std::size_t>(row) * from.columns + column]; };
    return (1.0 - b) * ((1.0 - a) * at(i, j) + a * at(i2, j)) + b * ((1.0 - a) * at(i, j2) + a * at(i2, j2));
}

double share(int n, int count) {
    return count > 1 ? static_cast<double>(n) / (count - 1) : 0.0;
}

/// Stops every mass and lets it go with half a kick, x + dt^2 a/2 and dt a/2, as leapfrog starts. A whole kick would
/// give the fastest modes energy, five times what they had at nine tenths of the largest step.
void let_go(Engine& engine, double dt) {
    auto masses = engine.masses();
    const auto x = masses.x;
    std::fill(masses.v.begin(), masses.v.end(), glm::dvec3(0.0));
    engine.set(masses);
    engine.advance({.dt = dt}, 0, 1);
    masses = engine.masses();
    for (std::size_t n = 0; n < x.size(); ++n) {
        masses.x[n] = 0.5 * (x[n] + masses.x[n]);
        masses.v[n] *= 0.5;
    }
    engine.set(masses);
}

/// Lets a flag come to rest under gravity: whenever its kinetic energy falls, all of it is taken out (kinetic damping).
/// Bounded in work, so that a large grid starts soon, if not quite at rest.
Masses settled(const Scene& scene, Masses masses) {
    constexpr double mass_steps = 1.5e8;  // about a second of one core
    constexpr double still = 1e-4;        // m/s, root mean square
    Scene quiet = scene;
    quiet.wind.reset();
    quiet.time.method = Method::semi_implicit_euler;
    const Physics physics(quiet);
    const auto engine = make_engine(physics, Precision::double_precision);

    const double dt = 0.9 * physics.largest_step();
    const double total_mass = physics.material.mass * static_cast<double>(physics.grid.masses());
    const auto most_steps = static_cast<long long>(mass_steps / static_cast<double>(physics.grid.masses()));
    constexpr long long look_every = 8;

    double before = 0.0;
    bool moved = false;
    engine->set(masses);
    for (long long step = 0; step < most_steps; step += look_every) {
        engine->advance({.dt = dt}, 0, look_every);
        const double kinetic = engine->energy().kinetic;
        if (kinetic < before) {
            if (moved && before < 0.5 * total_mass * still * still) break;
            let_go(*engine, dt);
            before = 0.0;
            moved = true;
        } else {
            before = kinetic;
        }
    }
    masses = engine->masses();
    std::fill(masses.v.begin(), masses.v.end(), glm::dvec3(0.0));
    return masses;
}

}  // namespace

Masses start_masses(const Scene& scene) {
    const Physics physics(scene);
    Masses masses;
    const double prestretch = scene.flag.prestretch;
    masses.x = scene.flag.start == Start::crumpled
                   ? crumpled_start(physics.grid, prestretch, physics.attach, crumple_seed)
                   : flat_start(physics.grid, prestretch);
    masses.v.assign(masses.x.size(), glm::dvec3(0.0));
    const bool can_hang = scene.gravity && scene.flag.attach != Attach::none;  // otherwise it would fall for ever
    if (scene.flag.start == Start::hanging && can_hang) {
        // A flag exactly in its plane would stay in it: the lightest of folds lets it choose a side.
        std::size_t n = 0;
        for (int j = 0; j < physics.grid.rows; ++j)
            for (int i = 0; i < physics.grid.columns; ++i, ++n)
                if (!is_attached(physics.attach, physics.grid, i, j))
                    masses.x[n].z += 0.02 * physics.grid.pitch_x *
                                     smooth_noise(crumple_seed, 103, 5.0 * i * physics.grid.pitch_x + 0.37 * j);
        masses = settled(scene, std::move(masses));
    }
    return masses;
}

Masses carried_over(const Masses& old, const Grid& old_grid, const Scene& scene) {
    const Physics physics(scene);
    const Grid& grid = physics.grid;
    Masses masses;
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            const bool held = is_attached(physics.attach, grid, i, j);
            const double along = share(i, grid.columns), down = share(j, grid.rows);
            masses.x.push_back(held ? (1.0 + scene.flag.prestretch) * grid.rest(i, j)
                                    : sample(old.x, old_grid, along, down));
            masses.v.push_back(held ? glm::dvec3(0.0) : sample(old.v, old_grid, along, down));
        }
    return masses;
}

}  // namespace drapeau
