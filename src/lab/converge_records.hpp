// Converge records: what a sweep of converge keeps in part files: its identity, and each method, grid, and grid with
// light borders.
#pragma once

#include "converge.hpp"
#include "converge_sweep.hpp"
#include "parts.hpp"

namespace drapeau::lab {

SweepIdentity identity_of(const ConvergeOptions& options, const ConvergeRequest& request);
/// The options that identity says. Throws InputError.
ConvergeOptions options_of_converge(const SweepIdentity& sweep);
std::vector<std::string> keys_of(const std::vector<ConvergePoint>& points);

/// Measures a point, as it is kept. What the budget leaves out, or nobody wants to know, is null within.
Json result_of(ConvergeSweep& sweep, const ConvergePoint& point, const std::function<void()>& tick);
/// What all points show, that this part has.
ConvergeFindings findings_in(const Part& part, const ConvergeSweep& sweep);

}  // namespace drapeau::lab
