// Divergence: how a run that diverged is explained: the step, the place, the cause and a remedy that works.
#pragma once

#include "run/simulation.hpp"
#include "run/watch.hpp"

namespace drapeau {

/// The run has been put back to a good state, `good`, and broke before time `broken_at` (s), by `cause` if it was
/// within the stability limit and all values are finite. Replays it to name the step and the place, tries smaller steps
/// for one that holds, and leaves engine and watch on the good state. Gives up naming them once `abandon` is set.
Divergence explain_divergence(Engine& engine, Watch& watch, Method method, const Progress& good, double broken_at,
                              Divergence::Cause cause, const std::atomic<bool>* abandon);

}  // namespace drapeau
