// Floor: the time a case cannot go below on this machine, from counted operations and bytes and measured peaks.
#pragma once

#include "cases.hpp"
#include "counted_lane.hpp"
#include "peaks.hpp"

namespace drapeau::bench {

struct Floor {
    double ns = 0.0;       // a mass and step
    std::string bound_by;  // "arithmetic" or a level of memory
};

/// What a case does to a mass in a step, counted on its kernel; nothing for plain copies.
Counts count_operations(const Case& c);

/// The greater of two times: arithmetic, in multiply-adds each of which does one multiplication and one addition at
/// most, and moving the state from and to the levels of memory that hold it.
Floor floor_of(const Case& c, const Counts& counts, const Peaks& peaks);

}  // namespace drapeau::bench
