// Stretch limit: no spring longer than (1 + stretch) times its rest length, as far as the attachments permit: the
// report's own future work (section 5), as a pass after the move.
//
// A spring that is too long is shortened by moving its two ends along it, in proportion to their inverse masses, so
// that linear momentum is kept (Provot 1995). One after the other that takes sweeps by the square of the springs in a
// line. Here a sweep takes a whole line at once (taut_line.hpp): every row, every column, every diagonal in which a
// spring is too long. Lines that cross pull on each other, so sweeps go on until none is too long. From the second on
// they shorten by over_relaxation more. From the fifth on every other one begins coarse to fine: masses 2^n apart are
// no farther apart than springs between them permit, and what moves those moves the ones between.
//
// Velocities follow what was moved (v += dx/dt): clamped positions alone would leave a hidden velocity that grows for
// ever. For the same reason the sweeps begin as soon as a spring is too long at all, not when it is by more than what
// may be left: an excess gathered over many steps and taken back in one would be thrown back.
#pragma once

#include "drapeau/limits/extra/coarse_masses.hpp"
#include "drapeau/state.hpp"

#include <algorithm>
#include <cmath>

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// What a pass after the move did.
struct PassReport {
    long long steps = 0;        // it was made after
    long long sweeps = 0;       // over the springs, summed over the steps
    double max_stretch = -1.0;  // share, the greatest that was left
    bool met = true;            // whether all of it was reached

    void add(const PassReport& other) {
        steps += other.steps;
        sweeps += other.sweeps;
        max_stretch = std::fmax(max_stretch, other.max_stretch);
        met = met && other.met;
    }
};

struct StretchLimit {
    static constexpr const char* name = "stretch limit";
    static constexpr const char* table = "limit";

    double stretch = 0.1;  // share; 0.05: no spring longer than 1.05 times its rest length

    /// What may be left beyond the limit, as a share of the rest length.
    static constexpr double tolerance = 1e-4;
    /// By how much more than it is too long a spring is shortened, from the second sweep on: springs of lines that
    /// cross give some of it back.
    static constexpr double over_relaxation = 0.7;
    /// So many sweeps are made before every other one begins coarse to fine: from one step to the next springs become
    /// too long by little, which fewer sweeps take back.
    static constexpr int sweeps_alone = 4;
    /// A few sweeps are enough, some tens where a large cloth is far too long in all directions. Beyond this many the
    /// report says that the limit was not met.
    static constexpr int max_sweeps = 1000;
    /// Where so many sweeps take less than a thousandth from the sum of what is too long, the attachments do not permit
    /// more.
    static constexpr int sweeps_to_judge = 16;

    /// What a pass works in, made once for a grid.
    template <class Real>
    struct Room {
        Room() = default;
        explicit Room(const Grid& grid)
            : taut(std::max(grid.columns, grid.rows)),
              squares(static_cast<std::size_t>(grid.columns + grid.rows)),
              coarse(grid) {}

        TautLine taut;
        Array<Real> squares;  // m2, of the longest spring of each line
        CoarseMasses<Real> coarse;
    };

    /// Moves positions `x`. `constants`: of each row.
    template <class Real>
    PassReport apply(const Grid& grid, bool diagonals, const RowConstants<Real>* constants, const Field<Real>& x,
                     Room<Real>& room) const {
        PassReport report{.steps = 1};
        double excess = INFINITY, before = INFINITY;  // m, what the last sweep found too long; that when last judged
        for (;;) {
            report.max_stretch = max_stretch(grid, diagonals, x);
            report.met = report.max_stretch <= stretch + tolerance;
            const bool within = report.sweeps == 0 ? report.max_stretch <= stretch : report.met;
            if (within || report.sweeps == max_sweeps || !std::isfinite(report.max_stretch)) return report;
            if (excess == 0.0) return report;  // what is too long is held at both ends
            if (report.sweeps > 0 && report.sweeps % sweeps_to_judge == 0) {
                if (before - excess < 1e-3 * excess) return report;
                before = excess;
            }
            if (report.sweeps >= sweeps_alone && report.sweeps % 2 == 0)
                room.coarse.shorten(grid, diagonals, constants, x, 1.0 + stretch, over_relaxation, room.taut);
            excess = sweep(grid, diagonals, constants, x, room, report.sweeps == 0);
            ++report.sweeps;
        }
    }

    bool operator==(const StretchLimit&) const = default;

private:
    /// Shortens all lines in which a spring is too long, after the first sweep only those where more is left than half
    /// of what may be. Returns by how much their springs were too long, in all (m).
    template <class Real>
    double sweep(const Grid& grid, bool diagonals, const RowConstants<Real>* constants, const Field<Real>& x,
                 Room<Real>& room, bool first) const {
        const double beyond = first ? 0.0 : over_relaxation, left = first ? 0.0 : 0.5 * tolerance;
        const Lattice all{grid, 1, x, [&](int i, int j) { return constants[j].inverse_mass[i]; }};
        double sum = 0.0;
        for (const Along along : all_lines) {
            if (!diagonals && along >= Along::falling) break;
            look(grid, along, x, room.squares);
            all.for_lines(along, [&](int n, const SpringLine& line) {
                const double longest = (1.0 + stretch + left) * all.rest_length(line, 0);
                if (static_cast<double>(room.squares[n]) > longest * longest)
                    sum += all.shorten(line, 1.0 + stretch, beyond, room.taut);
            });
        }
        return sum;
    }

    /// The square of the longest spring of each line that runs along (m2).
    template <class Real>
    static void look(const Grid& grid, Along along, const Field<Real>& x, Array<Real>& squares) {
        using V = Vector<Real>;
        if (along == Along::fly) {
            for (int j = 0; j < grid.rows; ++j) {
                Greatest<Real> most;
                most.look(x.row(j), 0, x.row(j), 1, grid.columns - 1, 1.0);
                squares[j] = static_cast<Real>(most.square());
            }
            return;
        }
        std::fill(squares.begin(), squares.end(), Real(0));
        const int from = along == Along::rising ? 1 : 0, to = along == Along::falling ? 1 : 0;
        const int count = along == Along::hoist ? grid.columns : grid.columns - 1;
        for (int j = 0; j + 1 < grid.rows; ++j) {
            const auto here = x.row(j), next = x.row(j + 1);
            Real* most = squares.data();
            if (along != Along::hoist) most += along == Along::falling ? grid.rows - 2 - j : j;
            const auto look_at = [&]<class W>(int i, const W&) {
                const auto d = next.template at<W>(i + to) - here.template at<W>(i + from);
                Lanes<W>::store(most + i, Lanes<W>::greater(Lanes<W>::load(most + i), dot(d, d)));
            };
            int i = 0;
            for (; i + Lanes<V>::width <= count; i += Lanes<V>::width) look_at(i, V{});
            for (; i < count; ++i) look_at(i, Real{});
        }
    }

    /// The greatest square of l/L; infinite if a position is not finite.
    template <class Real>
    class Greatest {
        using V = Vector<Real>;

    public:
        /// `count` springs of rest length `rest` (m) that start side by side.
        void look(const Field<Real>& from, std::ptrdiff_t first, const Field<Real>& to, std::ptrdiff_t end, int count,
                  double rest) {
            const auto scale = static_cast<Real>(1.0 / (rest * rest));
            const auto square = [&]<class W>(int i, const W&) {
                const auto d = to.template at<W>(end + i) - from.template at<W>(first + i);
                return scale * dot(d, d);
            };
            int i = 0;
            for (; i + Lanes<V>::width <= count; i += Lanes<V>::width) {
                const V s = square(i, V{});
                most_ = Lanes<V>::greater(most_, s);
                odd_ += s - s;
            }
            for (; i < count; ++i) {
                const Real s = square(i, Real{});
                last_most_ = Lanes<Real>::greater(last_most_, s);
                last_odd_ += s - s;
            }
        }
        double square() const {
            const bool finite = sum_of(odd_) == 0.0 && last_odd_ == 0;
            return finite ? std::max(max_of(most_), static_cast<double>(last_most_)) : INFINITY;
        }

    private:
        V most_{}, odd_{};  // odd: 0, or NaN from where a square is not finite
        Real last_most_{}, last_odd_{};
    };

    template <class Real>
    static double max_stretch(const Grid& grid, bool diagonals, const Field<Real>& x) {
        Greatest<Real> most;
        const double diagonal = grid.pitch_diagonal();
        for (int j = 0; j < grid.rows; ++j) {
            const auto here = x.row(j), next = x.row(j + 1);
            most.look(here, 0, here, 1, grid.columns - 1, grid.pitch_x);
            if (j + 1 == grid.rows) continue;
            most.look(here, 0, next, 0, grid.columns, grid.pitch_y);
            if (!diagonals) continue;
            most.look(here, 0, next, 1, grid.columns - 1, diagonal);
            most.look(here, 1, next, 0, grid.columns - 1, diagonal);
        }
        return std::sqrt(most.square()) - 1.0;
    }
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
