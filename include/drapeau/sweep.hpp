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
// Column i works out the four springs of its cell. What they pull on column i+1 of the same row waits in `right`, what
// they pull back on row j+1 waits in `below` (column i) and `below_right` (column i+1) until that row's turn. Then row
// j's force is complete and nobody needs its old state any more, so `finish` may move it in place, at once.
#pragma once

#include "drapeau/cloth.hpp"
#include "drapeau/spring.hpp"

#include <utility>

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

/// What springs from the row above left behind for a row.
template <class Real>
struct Waiting {
    ForceRow<Real> below, below_right;
};

/// The row-long buffers of one pass. Element -1 of each is readable and zero.
template <class Real>
class SweepBuffers {
public:
    /// For rows of `width` elements (Cloth::width).
    explicit SweepBuffers(int width) : width_(width), pitch_(width + gap), all_(18 * pitch_ + gap) {
        int n = 0;
        const auto next = [&] {
            Real* base = all_.data() + gap + 3 * (n++) * pitch_;
            return ForceRow<Real>{base, base + pitch_, base + 2 * pitch_};
        };
        own = next(), right = next();
        for (auto& w : waiting) w = {next(), next()};
    }
    SweepBuffers(SweepBuffers&&) = default;
    SweepBuffers& operator=(SweepBuffers&&) = default;

    int width() const { return width_; }

    ForceRow<Real> own, right;
    Waiting<Real> waiting[2];
    int now = 0;  // which of the two the row at hand reads; it fills the other

private:
    static constexpr int gap = widest<Real>;  // zeros before every row
    int width_;
    std::ptrdiff_t pitch_;
    Array<Real> all_;
};

/// One pass of the sweep. Give it the rows in order: begin(), then row(...) for each.
/// Pair: the operation on a pair of masses (SpringForce); diagonals: whether diagonal springs exist.
template <class V, class Pair, bool diagonals>
class Sweep {
public:
    using Real = typename Lanes<V>::Real;

    Sweep(const SpringRows<Real>& springs, SweepBuffers<Real>& buffers)
        : springs_(springs),
          own_(buffers.own),
          right_(buffers.right),
          in_(buffers.waiting[buffers.now]),
          out_(buffers.waiting[1 - buffers.now]),
          now_(buffers.now),
          width_(buffers.width()) {}

    /// Starts at a row with nothing above it.
    DRAPEAU_INLINE void begin() {
        const Triple<V> none{};
        for (int i = 0; i < width_; i += Lanes<V>::width) {
            in_.below.set(i, none);
            if constexpr (diagonals) in_.below_right.set(i, none);
        }
    }

    /// Starts below a row that another thread moves: its springs down to `here` are evaluated on both sides.
    DRAPEAU_INLINE void begin_below(const Row<Real>& above, const Row<Real>& here) {
        begin();
        pull<true>(above, here);
        turn();
    }

    /// Completes the force on row `here` and calls finish(i, force) on each register of it. `next` is the row below,
    /// null for the last one.
    template <class Finish>
    DRAPEAU_INLINE void row(const Row<Real>& here, const Row<Real>* next, Finish&& finish) {
        if (next)
            pull<true>(here, *next);
        else
            pull<false>(here, here);
        for (int i = 0; i < width_; i += Lanes<V>::width)
            finish(i, own_.template at<V>(i) + right_.template at<V>(i - 1));
        turn();
    }

private:
    DRAPEAU_INLINE void turn() {
        std::swap(in_, out_);
        now_ = 1 - now_;
    }

    template <bool has_next>
    DRAPEAU_INLINE void pull(const Row<Real>& here, const Row<Real>& next) {
        for (int i = 0; i < width_; i += Lanes<V>::width) {
            const auto x = here.template position<V>(i), v = here.template velocity<V>(i);
            const auto x_right = here.template position<V>(i + 1), v_right = here.template velocity<V>(i + 1);

            const auto fly = Pair::template pull<V>(springs_.fly, i, x_right - x, v_right - v);
            auto own = in_.below.template at<V>(i) + fly;
            auto right = Triple<V>{} - fly;
            if constexpr (diagonals) own = own + in_.below_right.template at<V>(i - 1);

            if constexpr (has_next) {
                const auto x_below = next.template position<V>(i), v_below = next.template velocity<V>(i);
                const auto hoist = Pair::template pull<V>(springs_.hoist, i, x_below - x, v_below - v);
                own = own + hoist;
                auto below = Triple<V>{} - hoist;
                if constexpr (diagonals) {
                    const auto rising =
                        Pair::template pull<V>(springs_.diagonal, i, x_below - x_right, v_below - v_right);
                    right = right + rising;
                    below = below - rising;
                    const auto x_corner = next.template position<V>(i + 1), v_corner = next.template velocity<V>(i + 1);
                    const auto falling = Pair::template pull<V>(springs_.diagonal, i, x_corner - x, v_corner - v);
                    own = own + falling;
                    out_.below_right.set(i, Triple<V>{} - falling);
                }
                out_.below.set(i, below);
            }
            right_.set(i, right);
            own_.set(i, own);
        }
    }

    SpringRows<Real> springs_;
    ForceRow<Real> own_, right_;
    Waiting<Real> in_, out_;
    int& now_;
    int width_;
};

}  // namespace drapeau
