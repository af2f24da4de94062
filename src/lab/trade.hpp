// drapeau-lab trade: speed against accuracy. What every method, step and precision costs for a scene, how wrong it is,
// and the cheapest that is good enough.
#pragma once

#include "comparison_options.hpp"

#include <string>

namespace drapeau::lab {

struct TradeOptions : ComparisonOptions {
    // Lists, separated by commas; "" is every one there is, or what the scene says.
    std::string methods;
    std::string precisions;
    std::string dt;      // s
    std::string grids;   // 23x15,90x60
    std::string limits;  // shares, or off
    bool both_diagonals = false;
    std::string write;  // files to write; "" writes none
    std::string json;
    std::string plot;
};

/// The exit status: good, not met or diverged. Throws InputError for bad input, before anything is computed or written.
int trade(const TradeOptions& options);

}  // namespace drapeau::lab
