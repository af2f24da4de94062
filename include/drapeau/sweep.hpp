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
// row above and from the column to its left, its force is complete and nobody needs its old state any more, so `finish`
// may move it in place, at once.
#pragma once

#include "drapeau/state.hpp"
#include "drapeau/spring.hpp"

namespace drapeau {

/// The springs of a cloth whose rows are all alike.
template <class Real>
struct SpringRows {
    SpringRow<Real> fly, hoist, diagonal;
};

/// Three row-long arrays of force (N).
template <class Real>
struct ForceRow {
    Real *x, *y, *z;

    template <class V>
    DRAPEAU_INLINE Triple<V> at(std::ptrdiff_t i) const {
        return {Lanes<V>::load(x + i), Lanes<V>::load(y + i), Lanes<V>::load(z + i)};
    }
    template <class V>
    DRAPEAU_INLINE void set(std::ptrdiff_t i, const Triple<V>& f) const {
        Lanes<V>::store(x + i, f.x), Lanes<V>::store(y + i, f.y), Lanes<V>::store(z + i, f.z);
    }
};

/// The row-long buffer of one pass: what springs from the row above left waiting for the row at hand.
template <class Real>
class SweepBuffers {
public:
    /// For rows of `width` elements (Cloth::width).
    explicit SweepBuffers(int width) : width_(width), pitch_(width + widest<Real>), all_(3 * pitch_) {
        waiting = {all_.data(), all_.data() + pitch_, all_.data() + 2 * pitch_};
    }

    int width() const { return width_; }

    ForceRow<Real> waiting;

private:
    int width_;
    std::ptrdiff_t pitch_;  // not a power of two, which would crowd one part of the cache
    Array<Real> all_;
};

/// What a pair operation that looks at no velocity (Pair::uses_velocity) is given instead: nothing is loaded.
struct NoVelocity {
    friend constexpr NoVelocity operator-(NoVelocity, NoVelocity) { return {}; }
};

/// One pass of the sweep. Give it the rows in order: begin(), then row(...) for each.
/// Pair: the operation on a pair of masses (SpringForce); diagonals: whether diagonal springs exist.
template <class V, class Pair, bool diagonals>
class Sweep {
public:
    using Real = typename Lanes<V>::Real;

    Sweep(const SpringRows<Real>& springs, SweepBuffers<Real>& buffers)
        : springs_(springs), waiting_(buffers.waiting), width_(buffers.width()) {}

    /// Starts at a row with nothing above it.
    DRAPEAU_INLINE void begin() {
        for (int i = 0; i < width_; i += Lanes<V>::width) waiting_.set(i, Triple<V>{});
    }

    /// Completes the force on row `here` and calls finish(i, force) on each register of it. `next` is the row below,
    /// null for the last one.
    template <class Finish>
    DRAPEAU_INLINE void row(const Row<Real>& here, const Row<Real>* next, Finish&& finish) {
        if (next)
            pull<true>(here, *next, finish);
        else
            pull<false>(here, here, finish);
    }

private:
    DRAPEAU_INLINE static auto velocity(const Row<Real>& row, int i) {
        if constexpr (Pair::uses_velocity)
            return row.template velocity<V>(i);
        else
            return NoVelocity{};
    }

    template <bool has_next, class Finish>
    DRAPEAU_INLINE void pull(const Row<Real>& here, const Row<Real>& next, Finish&& finish) {
        Triple<V> right_before{}, falling_before{};
        for (int i = 0; i < width_; i += Lanes<V>::width) {
            const auto x = here.template position<V>(i), x_right = here.template position<V>(i + 1);
            const auto v = velocity(here, i), v_right = velocity(here, i + 1);

            const auto fly = Pair::template pull<V>(springs_.fly, i, x_right - x, v_right - v);
            auto own = waiting_.template at<V>(i) + fly;
            auto right = Triple<V>{} - fly;

            if constexpr (has_next) {
                const auto x_below = next.template position<V>(i);
                const auto v_below = velocity(next, i);
                const auto hoist = Pair::template pull<V>(springs_.hoist, i, x_below - x, v_below - v);
                own = own + hoist;
                auto below = Triple<V>{} - hoist;
                if constexpr (diagonals) {
                    const auto rising =
                        Pair::template pull<V>(springs_.diagonal, i, x_below - x_right, v_below - v_right);
                    right = right + rising;
                    below = below - rising;
                    const auto x_corner = next.template position<V>(i + 1);
                    const auto v_corner = velocity(next, i + 1);
                    const auto falling = Pair::template pull<V>(springs_.diagonal, i, x_corner - x, v_corner - v);
                    own = own + falling;
                    below = below - shifted(falling_before, falling);
                    falling_before = falling;
                }
                waiting_.set(i, below);
            }
            finish(i, own + shifted(right_before, right));
            right_before = right;
        }
    }

    SpringRows<Real> springs_;
    ForceRow<Real> waiting_;
    int width_;
};

}  // namespace drapeau
