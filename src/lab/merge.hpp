// drapeau-lab merge: joins the parts of one sweep and says what the whole sweep would have said.
#pragma once

#include "parts.hpp"

#include <string>
#include <vector>

namespace drapeau::lab {

struct MergeOptions {
    std::vector<std::string> parts;
    std::string json, write, plot;  // files to write; "" writes none
};

/// The exit status. Throws InputError for parts that are none, or not of one sweep.
int merge(const MergeOptions& options);

// What each command makes of its own parts, outputs having been checked.
int merge_trade(const Joined& joined, const MergeOptions& options);
int merge_price(const Joined& joined, const MergeOptions& options);
int merge_converge(const Joined& joined, const MergeOptions& options);
int merge_stability(const Joined& joined, const MergeOptions& options);

}  // namespace drapeau::lab
