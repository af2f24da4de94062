// Sweep: every spring once, its reaction stored for the neighbour (report, section 4.2), as one pass over the rows.
//
// Going through the rows in order, row j evaluates the springs along it and those down to row j+1:
//
//     i ---- i+1      along the fly        (i,j)   - (i+1,j)
//     | \  / |        down the hoist       (i,j)   - (i,j+1)
//     |  \/  |        diagonal, falling    (i,j)   - (i+1,j+1)
//     |  /\  |        diagonal, rising     (i+1,j) - (i,j+1)
//     j+1
//
// Column i works out the four springs of its cell. What they pull on column i+1 is carried along to the next column;
// what they pull back on row j+1 waits in a row-long buffer until that row's turn. Once column i has its share from the
// row above and from the column to its left, its value is complete and nobody needs its old state any more, so `finish`
// may move it in place, at once.
#pragma once

#include "drapeau/hessian.hpp"
#include "drapeau/spring.hpp"
#include "drapeau/state.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// Components of the largest value that waits (a force in two parts, a symmetric 3 x 3 block).
inline constexpr int waiting_components = 6;

/// The row-long buffer of one pass.
template <class Real>
class WaitingBuffer {
public:
    /// For rows of `width` elements.
    explicit WaitingBuffer(int width)
        : pitch_(width + widest<Real>), all_(static_cast<std::size_t>(waiting_components * pitch_)) {}

    WaitingRow<Real> view() { return {all_.data(), pitch_}; }

private:
    std::ptrdiff_t pitch_;  // not a power of two, which would crowd one part of the cache
    Array<Real> all_;
};

template <class Real, class V>
DRAPEAU_INLINE void load_waiting(const WaitingRow<Real>& row, int i, Vec3<V>& value, int c = 0) {
    using L = Lanes<V>;
    value = {L::load(row.component(c) + i), L::load(row.component(c + 1) + i), L::load(row.component(c + 2) + i)};
}
template <class Real, class V>
DRAPEAU_INLINE void store_waiting(const WaitingRow<Real>& row, int i, const Vec3<V>& value, int c = 0) {
    using L = Lanes<V>;
    L::store(row.component(c) + i, value.x), L::store(row.component(c + 1) + i, value.y),
        L::store(row.component(c + 2) + i, value.z);
}
template <class Real, class V>
DRAPEAU_INLINE void load_waiting(const WaitingRow<Real>& row, int i, Parts<V>& value) {
    load_waiting(row, i, value.elastic), load_waiting(row, i, value.damping, 3);
}
template <class Real, class V>
DRAPEAU_INLINE void store_waiting(const WaitingRow<Real>& row, int i, const Parts<V>& value) {
    store_waiting(row, i, value.elastic), store_waiting(row, i, value.damping, 3);
}
template <class Real, class V>
DRAPEAU_INLINE void load_waiting(const WaitingRow<Real>& row, int i, Symmetric<V>& value) {
    load_waiting(row, i, value.diagonal), load_waiting(row, i, value.off, 3);
}
template <class Real, class V>
DRAPEAU_INLINE void store_waiting(const WaitingRow<Real>& row, int i, const Symmetric<V>& value) {
    store_waiting(row, i, value.diagonal), store_waiting(row, i, value.off, 3);
}

/// One pass of the sweep. Give it the rows in order: begin(), then row(...) for each.
/// Operation: what is made of a spring (spring.hpp, hessian.hpp); diagonals: whether diagonal springs exist.
template <class V, class Operation, bool diagonals>
class Sweep {
public:
    using Real = typename Lanes<V>::Real;
    using Row = typename Operation::Row;
    using End = typename Operation::End;
    using Value = typename Operation::Value;

    DRAPEAU_INLINE Sweep(const WaitingRow<Real>& waiting, int width) : waiting_(waiting), width_(width) {}

    Operation operation{};

    /// Starts at a row with nothing above it.
    DRAPEAU_INLINE void begin() {
        for (int i = 0; i < width_; i += Lanes<V>::width) store_waiting(waiting_, i, Value{});
    }

    /// Completes the values of row `here` and calls finish(i, value) on each register of it. `next` is the row below,
    /// null for the last one.
    template <class Finish>
    DRAPEAU_INLINE void row(const RowConstants<Real>& springs, const Row& here, const Row* next, Finish&& finish) {
        if (next)
            pull<true>(springs, here, *next, finish);
        else
            pull<false>(springs, here, here, finish);
    }

private:
    template <bool has_next, class Finish>
    DRAPEAU_INLINE void pull(const RowConstants<Real>& springs, const Row& here, const Row& next, Finish&& finish) {
        Value right_before{}, falling_before{};
        for (int i = 0; i < width_; i += Lanes<V>::width) {
            const End a = End::load(here, i), right_end = End::load(here, i + 1);
            const Value fly = operation.pull(springs.fly, i, a, right_end);
            Value own;
            load_waiting(waiting_, i, own);
            own = own + fly;
            Value right = Operation::react(Value{}, fly);

            if constexpr (has_next) {
                const End below_end = End::load(next, i);
                const Value hoist = operation.pull(springs.hoist, i, a, below_end);
                own = own + hoist;
                Value below = Operation::react(Value{}, hoist);
                if constexpr (diagonals) {
                    const Value rising = operation.pull(springs.diagonal, i, right_end, below_end);
                    right = right + rising;
                    below = Operation::react(below, rising);
                    const End corner_end = End::load(next, i + 1);
                    const Value falling = operation.pull(springs.diagonal, i, a, corner_end);
                    own = own + falling;
                    below = Operation::react(below, shifted(falling_before, falling));
                    falling_before = falling;
                }
                store_waiting(waiting_, i, below);
            }
            finish(i, own + shifted(right_before, right));
            right_before = right;
        }
    }

    WaitingRow<Real> waiting_;
    int width_;
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
