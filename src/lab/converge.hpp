// drapeau-lab converge: whether a finer grid, or a smaller step, converges: the orders measured, and where there is
// none what prevents it.
#pragma once

#include "comparison_options.hpp"

#include <string>

namespace drapeau::lab {

struct ConvergeOptions : ComparisonOptions {
    ConvergeOptions() { settle = "0"; }

    std::string methods;  // separated by commas; "" is every one there is
    std::string grids;    // 23x15,45x29,89x57; "" is the scene's own and finer ones
    std::string levels;   // how many of those; "" is 4
    std::string json;     // a file to write; "" writes none
    std::string plot;     // a picture, .svg or .png; "" draws none
};

/// The exit status: good or diverged. Throws InputError for bad input, before anything is computed or written.
int converge(const ConvergeOptions& options);

}  // namespace drapeau::lab
