// Stretch limit: no spring longer than (1 + stretch) times its rest length, as far as the attachments permit: the
// report's own future work (section 5), as a pass after the move.
//
// A spring that is too long is shortened by moving its two ends along it, in proportion to their inverse masses, so
// that linear momentum is kept (Provot 1995). One sweep over the springs shortens each in turn; sweeps go on, to and
// fro, until none is too long. Velocities follow what was moved (v += dx/dt): clamped positions alone would leave a
// hidden velocity that grows for ever. For the same reason the sweeps begin as soon as a spring is too long at all, not
// when it is by more than what may be left: an excess gathered over many steps and taken back in one would be thrown
// back.
#pragma once

#include "drapeau/state.hpp"

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
    /// A spring N links from the attachment needs up to about 2.5 N^2 sweeps when all are too long; far fewer when the
    /// step before left them short enough. Beyond this many the report says that the limit was not met.
    static constexpr int max_sweeps = 4000;
    /// Where so many sweeps take less than a thousandth from the sum of what is too long, the attachments do not permit
    /// more. (The sum, for the greatest stretch stays for long where shortening comes from a free end far away.)
    static constexpr int sweeps_to_judge = 64;

    /// Moves positions `x`. `constants`: of each row.
    template <class Real>
    PassReport apply(const Grid& grid, bool diagonals, const RowConstants<Real>* constants,
                     const Field<Real>& x) const {
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
            const bool down = report.sweeps % 2 == 0;
            excess = 0.0;
            for (int n = 0; n < grid.rows; ++n)
                excess += shorten_row(grid, diagonals, constants, x, down ? n : grid.rows - 1 - n);
            ++report.sweeps;
        }
    }

    bool operator==(const StretchLimit&) const = default;

private:
    /// Calls visit(i, j, di, dj, rest length) for the springs that row j starts.
    template <class Visit>
    static void for_springs(const Grid& grid, bool diagonals, int j, Visit&& visit) {
        const bool below = j + 1 < grid.rows;
        const double diagonal = grid.pitch_diagonal();
        for (int i = 0; i < grid.columns; ++i) {
            const bool right = i + 1 < grid.columns;
            if (right) visit(i, j, 1, 0, grid.pitch_x);
            if (below) visit(i, j, 0, 1, grid.pitch_y);
            if (right && below && diagonals) {
                visit(i, j, 1, 1, diagonal);
                visit(i + 1, j, -1, 1, diagonal);
            }
        }
    }

    template <class Real>
    static Vec3<Real> difference(const Field<Real>& x, std::ptrdiff_t from, std::ptrdiff_t to) {
        return x.template at<Real>(to) - x.template at<Real>(from);
    }

    /// Greatest square of l/L over `count` springs that start side by side.
    template <class Real>
    static double max_square(const Field<Real>& from, std::ptrdiff_t first, const Field<Real>& to, std::ptrdiff_t end,
                             int count, double rest) {
        using V = Vector<Real, 16>;
        const auto scale = static_cast<Real>(1.0 / (rest * rest));
        V most{};
        int i = 0;
        bool finite = true;
        for (; i + Lanes<V>::width <= count; i += Lanes<V>::width) {
            const auto d = to.template at<V>(end + i) - from.template at<V>(first + i);
            const V square = dot(d, d);
            most = Lanes<V>::greater(most, square);
            finite = finite && sum_of(square - square) == 0.0;
        }
        double all = max_of(most);
        for (; i < count; ++i) {
            const auto d = to.template at<Real>(end + i) - from.template at<Real>(first + i);
            const double square = dot(d, d);
            finite = finite && std::isfinite(square);
            all = std::fmax(all, square);
        }
        return finite ? all * static_cast<double>(scale) : INFINITY;
    }

    template <class Real>
    static double max_stretch(const Grid& grid, bool diagonals, const Field<Real>& x) {
        double most = 0.0;
        for (int j = 0; j < grid.rows; ++j) {
            const auto here = x.row(j), next = x.row(j + 1);
            most = std::fmax(most, max_square(here, 0, here, 1, grid.columns - 1, grid.pitch_x));
            if (j + 1 == grid.rows) continue;
            most = std::fmax(most, max_square(here, 0, next, 0, grid.columns, grid.pitch_y));
            if (!diagonals) continue;
            most = std::fmax(most, max_square(here, 0, next, 1, grid.columns - 1, grid.pitch_diagonal()));
            most = std::fmax(most, max_square(here, 1, next, 0, grid.columns - 1, grid.pitch_diagonal()));
        }
        return std::sqrt(most) - 1.0;
    }

    /// Returns by how much the springs that row j starts were too long, in all (m).
    template <class Real>
    double shorten_row(const Grid& grid, bool diagonals, const RowConstants<Real>* constants, const Field<Real>& x,
                       int j) const {
        double sum = 0.0;
        for_springs(grid, diagonals, j, [&](int i, int row, int di, int dj, double rest) {
            const auto from = row * x.stride + i, to = from + dj * x.stride + di;
            const auto longest = static_cast<Real>((1.0 + stretch) * rest);
            const auto d = difference(x, from, to);
            const Real square = dot(d, d);
            const Real w = constants[row].inverse_mass[i], w_to = constants[row + dj].inverse_mass[i + di];
            if (!(square > longest * longest) || w + w_to == Real(0)) return;
            const Real l = std::sqrt(square), excess = (Real(1) - longest / l) / (w + w_to);
            sum += static_cast<double>(l - longest);
            x.set(from, x.template at<Real>(from) + (w * excess) * d);
            x.set(to, x.template at<Real>(to) - (w_to * excess) * d);
        });
        return sum;
    }
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
