// drapeau-lab trade: speed against accuracy. What every method, step and precision costs for a scene, how wrong it is,
// and the cheapest that is good enough.
#pragma once

#include "part_file.hpp"

#include <string>
#include <vector>

namespace drapeau::lab {

struct TradeOptions {
    std::string scene;             // a path or the name of a shipped scene
    std::vector<std::string> set;  // "KEY=VALUE", instead of what the scene says
    // Lists, separated by commas; "" is every one there is, or what the scene says.
    std::string methods;
    std::string precisions;
    std::string dt;      // s
    std::string grids;   // 23x15,90x60
    std::string limits;  // shares, or off
    bool both_diagonals = false;
    std::string settle = "2";  // s
    std::string seconds;       // s; "" is 0.5, or less where the motion is chaotic
    std::string budget = "2";  // minutes
    std::string tolerance;     // "1mm"; "" names no setting
    std::string write;         // files to write; "" writes none
    std::string json;
    std::string plot;
    PartOptions part;
};

/// The exit status: good, not met or diverged. Throws InputError for bad input, before anything is computed or written.
int trade(const TradeOptions& options);

}  // namespace drapeau::lab
