// Run results: what a run was, what it cost and how it stands, as the table and the files give it.
#pragma once

#include "results.hpp"
#include "run/simulation.hpp"

#include <optional>
#include <string>
#include <vector>

namespace drapeau::lab {

struct Cost {
    double processor = 0.0;  // s
    double wall = 0.0;       // s
};

/// `reason`: what the step was chosen by.
std::vector<Result> results_of(const Simulation& simulation, int threads, const Cost& cost,
                               const std::optional<Divergence>& divergence, const ErrorEstimate& error,
                               const std::string& reason);

}  // namespace drapeau::lab
