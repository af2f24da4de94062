// Stability: the largest step of a method that is safe in every frozen configuration of a model, from closed bounds.
//
// Each method knows its limit for one oscillator; a model knows the fastest its masses and springs can be. The limit
// holds for springs that stay where they are: a sheet in violent motion turns its springs within a step and can create
// energy well below it (energy.hpp watches for that).
#pragma once

#include "drapeau/extra/added_air.hpp"
#include "drapeau/methods/list.hpp"
#include "drapeau/model.hpp"

#include <algorithm>
#include <cmath>

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// What the air that moves along allows, whatever the method.
inline StableStep added_air_step(const Model& model, double hold = longest_hold) {
    const double rate = added_air_rate(model);
    return rate > 0.0 ? StableStep::of_seconds(hold / rate) : StableStep::unlimited();
}

template <class M>
StableStep stable_step(const M&, const Model& model) {
    StableStep step = added_air_step(model);
    for (const auto& oscillator : model.bounds()) step = smaller(step, M::stable_step(oscillator));
    return step;
}
inline StableStep stable_step(Method method, const Model& model) {
    return with_method(method, [&](const auto& m) { return stable_step(m, model); });
}

/// The drag + friction (N s/m) that gives forward Euler the step dt (s).
inline double damping_needed(const Model& model, double dt) {
    double needed = 0.0;
    for (const auto& oscillator : model.bounds())
        needed = std::max(needed, ForwardEuler::damping_needed(oscillator, dt));
    return needed;
}

/// The share of the closed bound that an automatic step takes: from 0.3 where nothing damps to 0.75, rising with the
/// weakest damping rate, that of drag and friction, and of springs along themselves.
inline double automatic_share(const Model& model) {
    constexpr double least = 0.3, most = 0.75, half_way = 0.5;  // 1/s
    const double rate = (model.damping_on_mass(1.0) + model.springs.damping.value_or(0.0)) / model.springs.mass;
    return least + (most - least) * rate / (rate + half_way);
}

/// The automatic step (s) of a method that has a stable one; `lowered` is a share of the usual.
template <class M>
double automatic_step(const M& method, const Model& model, double lowered = 1.0) {
    const double share = lowered * M::automatic * automatic_share(model);
    double step = std::min({share * stable_step(method, model).seconds(), lowered * M::coarsest_step,
                            lowered * added_air_step(model, usual_hold).seconds()});
    if constexpr (requires(Oscillator o) { M::smooth_step(o); })
        for (const auto& oscillator : model.bounds())
            step = std::min(step, lowered * M::smooth_step(oscillator).seconds());
    return step;
}

/// Programs advance in batches of simulated time.
inline constexpr double batch_seconds = 1.0 / 60.0;

/// The largest dt not above the one given such that a whole number of equal steps fill a batch of 1/60 s.
inline double whole_steps_per_batch(double dt) {
    constexpr double rounding = 1e-9;  // a step that divides the batch up to rounding divides it
    return batch_seconds / std::max(1.0, std::ceil(batch_seconds / dt * (1.0 - rounding)));
}

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
