// Trade chart: error against cost of the settings measured, to be looked at and chosen from.
#pragma once

#include "findings.hpp"
#include "widgets.hpp"

#include <optional>

namespace drapeau {

/// Where the run is now: its error as it is measured on the way, and its cost on the clock.
struct TradeMark {
    std::optional<std::size_t> place;  // the point that it is stepped by
    double rate = NAN;                 // m a simulated second; NAN where it is unknown
    double ms_per_second = NAN;        // likewise
    std::optional<double> accuracy;    // m a simulated second that are asked for
};

/// Draws it over the panel's width. The place of the point that was clicked.
std::optional<std::size_t> draw_trade_chart(const MeasuredTrade& trade, const TradeMark& now, Widgets& widgets);

}  // namespace drapeau
