// Run cost: the processor time of a stretch of a scene as the programs run it, its energy ledger included.
#pragma once

#include "measure/flight.hpp"
#include "run/simulation.hpp"

namespace drapeau {

/// A simulation at the stretch's beginning. How the scene itself starts takes time and does not matter.
Simulation simulation_at(Scene scene, const Stretch& stretch);

/// How often a stretch of which one takes `seconds` is run, to last long enough (s) to be timed.
int times_for(double long_enough, double seconds);

/// Runs the stretch so often, warm: ms of processor time a simulated second.
double run_cost(const Scene& scene, const Stretch& stretch, int times);

}  // namespace drapeau
