// Trade records: what a sweep of trade keeps in part files: its identity, what points are judged by, and each point.
#pragma once

#include "measure/trade_sweep.hpp"
#include "parts.hpp"
#include "trade.hpp"

namespace drapeau::lab {

SweepIdentity identity_of(const TradeOptions& options, const TradeRequest& request);
/// The options that identity says. Throws InputError.
TradeOptions options_in(const SweepIdentity& sweep);

// Reading throws Json::exception or std::out_of_range for what no sweep wrote.
Json result_json(const Measured& measured);
Json cost_json(const Measured& measured);
/// With the least of its costs.
Measured measured_in(const PointRecord& record, const TradePoint& point);

/// The keys of all points, as they are dealt to shards.
std::vector<std::string> keys_of(const TradeSweep& sweep);
/// All points of a sweep, that this part has.
std::vector<Measured> points_in(const Part& part, const TradeSweep& sweep);

}  // namespace drapeau::lab
