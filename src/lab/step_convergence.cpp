#include "step_convergence.hpp"

#include "io/text.hpp"
#include "measure/work_clock.hpp"
#include "run/error_estimate.hpp"

#include "drapeau/stability.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <optional>

namespace drapeau::lab {

namespace {

using Flag = StepRung::Flag;

constexpr double as_declared = 0.1;  // that an order may be off

/// The largest step's count in a batch: the automatic one. Without a stable step, a sixteenth of what others take.
long long first_count(Method method, const Model& model) {
    return with_method(method, [&]<class M>(const M& chosen) {
        const bool is_stable = !stable_step(chosen, model).is_none();
        const double dt = is_stable ? automatic_step(chosen, model) : automatic_step(SemiImplicitEuler{}, model) / 16.0;
        return std::max(1LL, std::llround(batch_seconds / whole_steps_per_batch(dt)));
    });
}

/// What rounding, which the motion makes grow like any other push, leaves of a position (m).
double floor_of(const StepGround& ground) {
    constexpr double digits = 1e-14;
    const Grid& grid = ground.model.grid;
    const double size = std::hypot(grid.columns * grid.pitch_x, grid.rows * grid.pitch_y);
    return digits * size * ground.growth.amplification(ground.stretch.seconds());
}

/// The cosine between what halving the step changed last (to `fine`) and before (from `coarse`), over all free masses
/// and samples.
double alignment_of(const Model& model, const Flight& coarse, const Flight& middle, const Flight& fine) {
    double product = 0.0, last = 0.0, before = 0.0;
    for (std::size_t n = 0; n < fine.positions.size(); ++n)
        for (int j = 0; j < model.grid.rows; ++j)
            for (int i = 0; i < model.grid.columns; ++i) {
                if (model.held(i, j)) continue;
                const glm::dvec3 x = middle.positions[n].at(i, j);
                const glm::dvec3 a = x - coarse.positions[n].at(i, j), b = fine.positions[n].at(i, j) - x;
                product += glm::dot(a, b), last += glm::dot(b, b), before += glm::dot(a, a);
            }
    return product / std::sqrt(last * before);
}

/// What an order, or its absence, comes from.
Flag flag_of(const StepRung& rung, int declared, const StepGround& ground) {
    constexpr double unlike = 0.5;  // cosine: where errors only shrink it is nearer to 1
    constexpr double low = 0.75;    // of the order declared
    if (std::abs(rung.order - declared) <= as_declared) return Flag::asymptotic;
    if (rung.difference <= floor_of(ground)) return Flag::rounding;
    if (ground.growth.is_seen() && rung.alignment < unlike && rung.order < low * declared) return Flag::chaos;
    if (rung.order < declared && is_limit_active(ground.model, ground.reference.by_rk4)) return Flag::limit;
    return Flag::pre_asymptotic;
}

/// One order that is right among others that are not is so by chance.
void doubt_lone_orders(MethodConvergence& found, const StepGround& ground) {
    constexpr double near = 0.25;
    auto& rungs = found.rungs;
    const auto has_order = [&](std::size_t n) { return n < rungs.size() && std::isfinite(rungs[n].order); };
    const auto is_near = [&](std::size_t n) {
        return has_order(n) && std::abs(rungs[n].order - found.declared) <= near;
    };
    for (std::size_t n = 1; n < rungs.size(); ++n) {
        const bool has_others = has_order(n - 1) || has_order(n + 1);
        if (rungs[n].flag != Flag::asymptotic || !has_others || is_near(n - 1) || is_near(n + 1)) continue;
        StepRung doubted = rungs[n];
        doubted.order = 0.0;  // anything but the one declared
        rungs[n].flag = flag_of(doubted, found.declared, ground);
    }
}

bool is_settled(const std::vector<StepRung>& rungs) {
    if (rungs.empty()) return false;
    const auto is = [&](std::size_t from_end, Flag flag) {
        return rungs.size() > from_end && rungs[rungs.size() - 1 - from_end].flag == flag;
    };
    return is(0, Flag::rounding) || (is(0, Flag::asymptotic) && is(1, Flag::asymptotic));
}

}  // namespace

double StepRung::dt() const {
    return batch_seconds / static_cast<double>(steps_a_batch);
}

const StepRung* MethodConvergence::best() const {
    for (auto rung = rungs.rbegin(); rung != rungs.rend(); ++rung)
        if (std::isfinite(rung->order) && rung->flag != Flag::rounding) return &*rung;
    return nullptr;
}

double least_seconds(Method method, const StepGround& ground) {
    const double steps = static_cast<double>(first_count(method, ground.model) * ground.stretch.batches);
    return 7.0 * ground.unit * step_cost(ground.model, method) * steps;  // 1 + 2 + 4
}

MethodConvergence converge_in_step(Method method, const StepGround& ground, double seconds) {
    constexpr int most_rungs = 14;
    const double least = least_seconds(method, ground), a_step = step_cost(ground.model, method);
    WorkClock clock(ground.counts_work ? ground.unit : 0.0);
    MethodConvergence found{.method = method, .declared = order_of(method), .rungs = {}, .left_out = {}};
    if (least > seconds) {
        found.left_out = "three runs from steps of " +
                         quantity(batch_seconds / static_cast<double>(first_count(method, ground.model)), "s") +
                         " on take about " + quantity(least, "s", 2) + ", more than --budget leaves";
        return found;
    }
    const double resolved = 10.0 * ground.reference.error();
    std::optional<Flight> before, older;
    double last_difference = NAN, last_cost = 0.0;
    for (long long steps = first_count(method, ground.model); !is_settled(found.rungs); steps *= 2) {
        if (static_cast<int>(found.rungs.size()) == most_rungs) break;
        if (clock.spent() + 2.0 * last_cost > seconds) {
            found.left_out = "smaller steps take longer than --budget leaves";
            break;
        }
        const double start = clock.spent();
        bool is_late = false;
        auto flight = fly(ground.model, method, steps, ground.stretch, ground.yardstick, [&] {
            if (ground.tick) ground.tick();
            clock.count(static_cast<double>(steps) * a_step);
            is_late = clock.spent() > 1.5 * seconds;
            return !is_late;
        });
        last_cost = clock.spent() - start;
        if (is_late) {
            found.left_out = "smaller steps take longer than --budget leaves";
            break;
        }
        StepRung& rung = found.rungs.emplace_back();
        rung.steps_a_batch = steps;
        if (!flight) {
            rung.flag = Flag::diverged;
        } else {
            rung.error = apart(ground.model, *flight, ground.reference.judge_of(method)).over_time;
            rung.is_below_resolution = !(rung.error >= resolved);
            if (before) rung.difference = apart(ground.model, *flight, *before).over_time;
            if (std::isfinite(last_difference)) {
                rung.order = std::log2(last_difference / rung.difference);
                rung.alignment = alignment_of(ground.model, *older, *before, *flight);
                rung.flag = flag_of(rung, found.declared, ground);
            } else if (before && rung.difference <= floor_of(ground)) {
                rung.flag = Flag::rounding;  // exact but for rounding
            }
        }
        last_difference = rung.difference;
        older = std::move(before);
        before = std::move(flight);
    }
    doubt_lone_orders(found, ground);
    return found;
}

}  // namespace drapeau::lab
