// Divergence: how a run is watched, and how one that came apart is explained.
#pragma once

#include "engine.hpp"

#include <optional>

namespace drapeau {

/// All the energy a run could have: what it began with, the work of gravity and wind so far in magnitude, and k L^2
/// over its springs. A run that exceeds 100 times that, or holds a value that is not finite, has diverged.
class EnergyBudget {
public:
    EnergyBudget(const Physics& physics, const Energy& initial)
        : elastic_(elastic_scale(physics.grid, physics.material)), initial_(initial.total()) {}

    double could_have() const { return elastic_ + initial_ + work_; }
    /// With the work done since the engine's keep(), from time `start` to time `now` (s).
    EnergyBudget with_work_since_kept(const Engine& engine, const Physics& physics, double start, double now) const;

private:
    double elastic_, initial_, work_ = 0.0;
};

/// Replays the steps first <= n < last from the engine's kept state, when the budget was `budget`, finds the one that
/// broke it, names place and limit, and leaves the engine on the kept state.
Divergence explain_divergence(Engine& engine, const Physics& physics, const EnergyBudget& budget, const Clock& clock,
                              long long first, long long last);

/// "0.35 ms", "1.2 s": a time for a sentence.
std::string in_words(double seconds);

}  // namespace drapeau
