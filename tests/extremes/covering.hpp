// Covering: rows of levels in which any two levels of any two factors stand together at least once. Most faults need
// one or two settings to meet, and a few hundred rows have all of these where all combinations would be 10^15.
#pragma once

#include <cstdint>
#include <vector>

namespace drapeau::extremes {

/// One level of each factor.
using Row = std::vector<int>;

/// `levels`: how many each factor has. Greedy: every row begins with a pair that is missing yet and takes, factor by
/// factor, the level that brings most missing pairs. Another seed gives other rows.
std::vector<Row> covering(const std::vector<int>& levels, std::uint64_t seed);

}  // namespace drapeau::extremes
