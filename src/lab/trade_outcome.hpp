// Trade outcome: what follows from the points of a sweep, said in tables, kept in files, and as an exit status.
#pragma once

#include "outputs.hpp"
#include "trade_report.hpp"

#include <vector>

namespace drapeau::lab {

/// The front, orders and the setting to recommend, for which the sweep must have been prepared.
TradeFindings findings_of(const TradeSweep& sweep, std::vector<Measured> points, const Tick& tick);

/// Prints and writes all of it; the exit status.
int report(const TradeSweep& sweep, const TradeFindings& findings, const SweepOutputs& outputs);

}  // namespace drapeau::lab
