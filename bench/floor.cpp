#include "floor.hpp"

#include "counting.hpp"

#include "drapeau/methods/list.hpp"

#include <algorithm>
#include <utility>

namespace drapeau::bench {
namespace {

/// ns to move `bytes` a mass when the set in use has `set_bytes`: what fits a level moves as fast as that level does.
double ns_to_move(double bytes, std::size_t set_bytes, double Level::*bandwidth, const Peaks& peaks) {
    double ns = 0.0, held = 0.0;  // share of the set that nearer levels hold
    const std::size_t last = peaks.level_of(set_bytes);
    for (std::size_t n = 0; n <= last; ++n) {
        const auto& level = peaks.levels[n];
        const double share = n == last ? 1.0 : static_cast<double>(level.bytes) / static_cast<double>(set_bytes);
        ns += (share - held) * bytes / level.*bandwidth;
        held = share;
    }
    return ns;
}

}  // namespace

Counts count_operations(const Case& c) {
    if (c.work == Work::snapshot || c.work == Work::copy || c.work == Work::mode) return {};
    const Counted what = c.work == Work::measure     ? Counted::measurement
                         : c.work == Work::forces    ? Counted::evaluation
                         : c.work == Work::accounted ? Counted::accounted_step
                                                     : Counted::step;
    return count(what, {.method = c.method,
                        .in_double = c.precision == Precision::double_precision,
                        .diagonals = c.listing.diagonal,
                        .damped = c.listing.damping,
                        .rated = c.listing.drag || c.work != Work::terms});
}

Floor floor_of(const Case& c, const Counts& counts, const Peaks& peaks) {
    const auto masses = static_cast<std::size_t>(c.masses());
    const std::size_t real = c.bytes_a_real();

    // What must be read and written at least. Passes of steps update what they see in place; the rest reads some and
    // writes other.
    std::size_t moved = 12 * real, set_bytes = masses * moved;
    double Level::*rate = &Level::copy;
    if (takes_steps(c.work)) {
        const auto [passes, fields] = with_method(c.method, [&]<class M>(const M&) {
            return std::pair(M::passes, c.listing.damping ? M::template fields<true> : M::template fields<false>);
        });
        moved *= passes;
        set_bytes = masses * 3 * fields * real;
        rate = &Level::update;
    } else if (c.work == Work::measure) {
        moved = 6 * real, set_bytes = masses * moved, rate = &Level::load;
    } else if (c.work == Work::forces || c.work == Work::mode) {
        moved = 9 * real, set_bytes = masses * moved;
    } else if (c.work == Work::snapshot) {
        moved = 3 * (real + sizeof(float)), set_bytes = masses * moved;
    }
    const double moving = ns_to_move(static_cast<double>(moved), set_bytes, rate, peaks);

    const double operations = std::max(counts.multiplications, counts.additions) + counts.others;
    const double arithmetic = operations / peaks.multiply_adds_of(c.precision);
    Floor floor{arithmetic, "arithmetic"};
    if (moving > arithmetic) floor = {moving, peaks.levels[peaks.level_of(set_bytes)].name};
    floor.ns /= c.threads;
    return floor;
}

}  // namespace drapeau::bench
