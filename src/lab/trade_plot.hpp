// Trade plot: the work-precision diagram of a sweep: what each setting costs over how wrong it is.
#pragma once

#include "trade_report.hpp"

#include <string>

namespace drapeau::lab {

/// The script for gnuplot. Both axes are logarithmic; settings that diverged stand at the right edge, at the cost that
/// their steps would have.
std::string work_precision_script(const TradeSweep& sweep, const TradeFindings& findings);

}  // namespace drapeau::lab
