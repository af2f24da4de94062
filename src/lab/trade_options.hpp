// Trade options: what the command line of trade says, as the numbers and lists it means.
#pragma once

#include "measure/trade_sweep.hpp"
#include "trade.hpp"

namespace drapeau::lab {

/// Throws InputError that names the option, its value and what is allowed.
TradeRequest request_in(const TradeOptions& options);
/// The same of a scene that is read already.
TradeRequest request_in(const TradeOptions& options, const Scene& scene);

}  // namespace drapeau::lab
