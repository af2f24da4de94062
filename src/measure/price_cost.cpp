#include "measure/price_cost.hpp"

#include "io/error.hpp"
#include "io/text.hpp"
#include "measure/clocks.hpp"
#include "measure/median_interval.hpp"
#include "measure/price_effect.hpp"
#include "measure/run_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace drapeau {

namespace {

constexpr int most_rounds = 300, least_rounds = min_draws, usual_rounds = 20;
constexpr double long_enough = 6e-3;  // s, that a turn lasts
constexpr double finest = 0.01;       // share: no smaller difference is looked for

struct FirstRun {
    Cost cost;
    double seconds = NAN;  // of processor time, where it holds
};

FirstRun first_run(const Scene& scene, const Stretch& stretch) {
    FirstRun run;
    try {
        Simulation simulation = simulation_at(scene, stretch);
        const double before = thread_seconds();
        std::optional<Divergence> divergence;
        for (long long batch = 0; batch < stretch.batches && !divergence; ++batch)
            divergence = simulation.advance_batch();
        const double seconds = thread_seconds() - before;
        if (!divergence) divergence = simulation.check();
        if (divergence)
            run.cost.remark = divergence->message;
        else
            run.seconds = seconds;
        run.cost.dt = simulation.dt();
    } catch (const InputError& refused) {
        run.cost.remark = refused.what();
    }
    return run;
}

/// A scene that takes turns.
struct Contender {
    Scene scene;
    Stretch stretch;
    int times = 0;  // the stretch is run in a turn; 0 where it does not hold
};

/// The least that is known of what a scene takes less than the first, but for those that do not hold.
double known_to(const Costs& costs) {
    double most = 0.0;
    for (std::size_t n = 1; n < costs.of.size(); ++n)
        if (const Share share = costs.saved(0, n); std::isfinite(share.value)) most = std::max(most, share.known_to);
    return most;
}

}  // namespace

std::string percent(const Share& share) {
    if (!std::isfinite(share.value)) return "-";
    const double most = std::abs(share.value) + share.known_to;
    if (!share.is_resolved()) return "< " + rounded(100.0 * most, most < 0.1 ? 2 : 3) + " %";
    const int decimals = share.known_to < 0.1 ? 1 : 0;
    return fmt::format("{:.{}f} ± {:.{}f} %", 100.0 * share.value, decimals, 100.0 * share.known_to, decimals);
}

Share Costs::saved(std::size_t from, std::size_t to) const {
    std::vector<double> shares;
    for (std::size_t round = 0; round < turns.front().size(); ++round)
        if (round < turns[from].size() && round < turns[to].size())
            shares.push_back((turns[from][round] - turns[to][round]) / turns.front()[round]);
    if (static_cast<int>(shares.size()) < min_draws) return {};
    const MedianInterval interval = median_interval(std::move(shares));
    return {interval.median, std::max({finest, interval.high - interval.median, interval.median - interval.low})};
}

Costs costs_of(const std::vector<Scene>& scenes, const Footing& ground, double seconds,
               const std::function<void()>& tick) {
    std::vector<Contender> contenders;
    Costs costs;
    for (const Scene& scene : scenes) {
        Contender& contender = contenders.emplace_back(Contender{scene, stretch_on(scene, ground), 0});
        const FirstRun run = first_run(scene, contender.stretch);
        if (std::isfinite(run.seconds)) contender.times = times_for(long_enough, run.seconds);
        costs.of.push_back(run.cost);
        tick();
    }
    costs.turns.resize(scenes.size());
    const double began = wall_seconds();
    for (int round = 0; round < most_rounds && contenders.front().times > 0; ++round) {
        if (round >= least_rounds && wall_seconds() - began > seconds) break;
        // On a busy machine more are made.
        if (round >= usual_rounds && known_to(costs) <= finest) break;
        for (std::size_t turn = 0; turn < contenders.size(); ++turn) {
            // There and back again: what changes steadily meanwhile favours none.
            const std::size_t n = round % 2 == 0 ? turn : contenders.size() - 1 - turn;
            const auto& [scene, stretch, times] = contenders[n];
            if (times == 0) continue;
            costs.turns[n].push_back(run_cost(scene, stretch, times));
            tick();
        }
    }
    for (std::size_t n = 0; n < contenders.size(); ++n)
        for (const double turn : costs.turns[n]) costs.of[n].ms_per_second = std::fmin(costs.of[n].ms_per_second, turn);
    return costs;
}

Cost as_run(const Scene& scene, const Footing& ground) {
    return first_run(scene, stretch_on(scene, ground)).cost;
}

Scene at_step(const Scene& scene, double dt) {
    Scene other = scene;
    other.time.dt = dt;
    other.time.tolerance.reset();
    return other;
}

}  // namespace drapeau
