// Trade report: what a sweep found, as tables for a person and as JSON for programs.
#pragma once

#include "measure/trade_sweep.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace drapeau::lab {

/// All that is said of a sweep.
struct TradeFindings {
    std::vector<Measured> points;
    std::vector<std::size_t> front;  // places in points, the cheapest first
    std::vector<OrderFit> orders;
    Recommendation recommended;
};

/// "leapfrog, steps of 139 µs, float".
std::string name_of(const TradePoint& point, const std::vector<Variant>& variants);

/// What was compared, and what is known of it: a few lines.
std::string reference_text(const TradeSweep& sweep);
std::string points_table(const TradeSweep& sweep, const TradeFindings& findings);
/// The efficient front, the cheapest first, with the line where real time is.
std::string front_table(const TradeSweep& sweep, const TradeFindings& findings);
std::string orders_text(const TradeSweep& sweep, const TradeFindings& findings);

nlohmann::ordered_json as_json(const TradeSweep& sweep, const TradeFindings& findings);

}  // namespace drapeau::lab
