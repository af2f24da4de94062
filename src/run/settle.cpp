#include "run/settle.hpp"

#include "run/carry_over.hpp"
#include "run/engine.hpp"
#include "scene/material.hpp"

#include "drapeau/stability.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace drapeau {
namespace {

constexpr double watched_seconds = 0.1;  // how long a flag must be still for

/// What may be spent, in masses moved by a step, or what takes as long.
struct Budget {
    double left = 2.5e8;  // between one and three seconds of one core

    void spend(const Grid& grid, long long steps, const PassReport& limit) {
        constexpr double row = 11.0, step = 75.0, sweep = 3.0;  // what each takes, in masses
        left -= static_cast<double>(steps) * (grid.rows * (grid.columns + row) + step);
        left -= static_cast<double>(limit.sweeps) * sweep * static_cast<double>(grid.masses());
    }
};

/// The scene on a grid of half as many cells, of the same weight and of springs as soft as the two they stand for.
Scene coarser(const Scene& scene) {
    constexpr int min_masses = 8;  // along a side that is halved
    Scene coarse = scene;
    FlagSettings& flag = coarse.flag;
    if (flag.columns >= min_masses) flag.columns = (flag.columns + 1) / 2;
    if (flag.rows >= min_masses) flag.rows = (flag.rows + 1) / 2;
    if (coarse.fabric) return do_cells_fit(coarse) ? coarse : scene;
    const auto share = [](int few, int many) { return static_cast<double>(few) / many; };
    const double columns = share(flag.columns, scene.flag.columns), rows = share(flag.rows, scene.flag.rows);
    const double across = share(std::max(1, flag.columns - 1), std::max(1, scene.flag.columns - 1));
    const double down = share(std::max(1, flag.rows - 1), std::max(1, scene.flag.rows - 1));
    const double fly = across / rows, hoist = down / columns;  // springs in a line over lines of springs
    const double softer = flag.rows == 1 ? fly : flag.columns == 1 ? hoist : std::sqrt(fly * hoist);
    SpringSettings& springs = *coarse.springs;
    springs.mass /= columns * rows;
    springs.stiffness *= softer;
    if (springs.diagonal_stiffness) *springs.diagonal_stiffness *= softer;
    return coarse;
}

/// The grids from the finest to the coarsest, of nothing but springs, bending, weight and limits. Their springs may be
/// damped.
std::vector<Scene> grids_of(const Scene& scene) {
    Scene quiet = scene;
    quiet.wind().reset();
    quiet.damping() = 0.0;
    quiet.drag().reset();
    quiet.terms.get<Air>().reset();
    if (auto& bending = quiet.terms.get<Bending>()) bending->damping.reset();
    if (quiet.springs) quiet.springs->friction.reset();
    quiet.time.method = method_id<SemiImplicitEuler>;
    std::vector<Scene> grids{quiet};
    for (Scene next = coarser(quiet); next.flag != grids.back().flag; next = coarser(next)) grids.push_back(next);
    return grids;
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

/// What is asked of one grid.
struct Goal {
    double still = still_speed;  // m/s
    double budget_left = 0.0;    // where it stops without
};

/// Springs damped such that the fastest swings, which would make the kinetic energy fall all the time, die out and slow
/// ones do not notice: by 0.3 of critical damping in a chain.
Model with_damped_springs(const Scene& scene) {
    Model model = model_of(scene);
    model.springs.damping = 0.3 * std::sqrt(model.springs.stiffness * model.springs.mass);
    return model;
}

Settled settle_on(const Scene& scene, const State<double>& start, const Goal& goal, Budget& budget,
                  const std::atomic<bool>* abandon) {
    constexpr double fallen = 0.95;      // of the highest kinetic energy: it falls
    constexpr long long look_every = 8;  // steps
    const Model model = with_damped_springs(scene);
    const auto engine = make_engine(model, scene.time.method, Precision::double_precision);
    const double dt = std::min(0.9 * stable_step(SemiImplicitEuler{}, model).seconds(), batch_seconds);
    const double mass = model.total_mass();
    const auto speed_of = [mass](double kinetic) { return std::sqrt(2.0 * kinetic / mass); };

    double highest = 0.0, quiet = 0.0;  // since it was last let go: J, s
    engine->set(start);
    let_go(*engine, dt);
    while (budget.left > goal.budget_left && quiet < watched_seconds) {
        if (abandon && abandon->load(std::memory_order_relaxed)) throw SettlingAbandoned();
        Report report;
        engine->advance({.dt = dt}, 0, look_every, no_step, report, nullptr);
        budget.spend(model.grid, look_every, report.limit);
        const double kinetic = engine->kinetic();
        if (!std::isfinite(kinetic)) return {start, false, INFINITY};
        highest = std::max(highest, kinetic);
        quiet = speed_of(highest) < goal.still ? quiet + static_cast<double>(look_every) * dt : 0.0;
        if (quiet > 0.0 || kinetic > fallen * highest) continue;
        let_go(*engine, dt);
        highest = 0.0;
    }
    Settled settled{engine->state(0.0), quiet >= watched_seconds, speed_of(highest)};
    settled.state.velocity = FieldBuffer<double>(model.grid.columns, model.grid.rows);
    return settled;
}

}  // namespace

Settled settle(const Scene& scene, const State<double>& start, const std::atomic<bool>* abandon) {
    constexpr double coarse_share = 0.3;  // of the budget that is left, at most, for each coarser grid
    Budget budget;
    const std::vector<Scene> grids = grids_of(scene);
    State<double> state = grids.size() > 1 ? carried_over(start, grids.back()) : start;
    for (std::size_t n = grids.size() - 1; n > 0; --n) {
        const Goal roughly{.still = 3.0 * still_speed, .budget_left = (1.0 - coarse_share) * budget.left};
        state = carried_over(settle_on(grids[n], state, roughly, budget, abandon).state, grids[n - 1]);
    }
    return settle_on(grids.front(), state, {}, budget, abandon);
}

}  // namespace drapeau
