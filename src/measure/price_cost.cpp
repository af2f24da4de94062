#include "measure/price_cost.hpp"

#include "io/error.hpp"
#include "measure/clocks.hpp"
#include "measure/price_effect.hpp"
#include "measure/run_cost.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace drapeau {

namespace {

constexpr int most_rounds = 300, least_rounds = 4, usual_rounds = 20;
constexpr double long_enough = 6e-3;  // s, that a turn lasts
constexpr double finest = 0.01;       // share: no smaller difference is looked for

/// A scene that takes turns, and the least of its even and of its odd ones.
struct Contender {
    Scene scene;
    Stretch stretch;
    int times = 0;  // the stretch is run in a turn; 0 where it does not hold
    std::array<double, 2> least{INFINITY, INFINITY};
};

/// Runs it once: whether it holds, and how long it takes.
Cost first_run(Contender& contender) {
    Cost cost;
    try {
        Simulation simulation = simulation_at(contender.scene, contender.stretch);
        const double before = thread_seconds();
        std::optional<Divergence> divergence;
        for (long long batch = 0; batch < contender.stretch.batches && !divergence; ++batch)
            divergence = simulation.advance_batch();
        const double seconds = thread_seconds() - before;
        if (!divergence) divergence = simulation.check();
        if (divergence)
            cost.remark = divergence->message;
        else
            contender.times = times_for(long_enough, seconds);
        cost.dt = simulation.dt();
    } catch (const InputError& refused) {
        cost.remark = refused.what();
    }
    return cost;
}

/// What the even turns and the odd ones differ by, as a share of the first scene's time: twice their root mean square.
double resolution_of(const std::vector<Contender>& contenders, double first) {
    double squares = 0.0, count = 0.0;
    for (const Contender& contender : contenders) {
        if (contender.times == 0) continue;
        const double off = (contender.least[0] - contender.least[1]) / first;
        squares += off * off, count += 1.0;
    }
    return std::max(finest, 2.0 * std::sqrt(squares / std::max(count, 1.0)));
}

}  // namespace

Costs costs_of(const std::vector<Scene>& scenes, const Ground& ground, double seconds,
               const std::function<void()>& tick) {
    std::vector<Contender> contenders;
    Costs costs;
    for (const Scene& scene : scenes) {
        contenders.push_back({scene, stretch_on(scene, ground)});
        costs.of.push_back(first_run(contenders.back()));
        tick();
    }
    const auto least_of = [](const Contender& contender) { return std::min(contender.least[0], contender.least[1]); };
    const double began = wall_seconds();
    for (int round = 0; round < most_rounds && contenders.front().times > 0; ++round) {
        if (round >= least_rounds && wall_seconds() - began > seconds) break;
        // On a busy machine more are made.
        if (round >= usual_rounds && resolution_of(contenders, least_of(contenders.front())) <= finest) break;
        for (Contender& contender : contenders) {
            if (contender.times == 0) continue;
            double& least = contender.least[static_cast<std::size_t>(round % 2)];
            least = std::min(least, run_cost(contender.scene, contender.stretch, contender.times));
            tick();
        }
    }
    for (std::size_t n = 0; n < contenders.size(); ++n)
        if (std::isfinite(least_of(contenders[n]))) costs.of[n].ms_per_second = least_of(contenders[n]);
    costs.resolution = resolution_of(contenders, costs.first());
    return costs;
}

double step_of(const Scene& scene, const Ground& ground) {
    Contender contender{scene, stretch_on(scene, ground)};
    return first_run(contender).dt;
}

Scene at_step(const Scene& scene, double dt) {
    Scene other = scene;
    other.time.dt = dt;
    other.time.tolerance.reset();
    return other;
}

}  // namespace drapeau
