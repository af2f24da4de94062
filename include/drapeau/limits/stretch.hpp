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

#include "drapeau/limits/extra/taut_line.hpp"
#include "drapeau/state.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

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
    /// A few sweeps are enough, some tens where a large cloth is far too long in all directions. Beyond this many the
    /// report says that the limit was not met.
    static constexpr int max_sweeps = 1000;
    /// Where so many sweeps take less than a thousandth from the sum of what is too long, the attachments do not permit
    /// more.
    static constexpr int sweeps_to_judge = 16;

    /// What a pass works in: made once for a grid.
    template <class Real>
    struct Room {
        Room() = default;
        explicit Room(const Grid& grid)
            : line(std::max(grid.columns, grid.rows)),
              squares(static_cast<std::size_t>(grid.columns + grid.rows)),
              nodes(nodes_of(grid.columns, 2), nodes_of(grid.rows, 2), 0),
              before(nodes.columns(), nodes.rows(), 1),
              inverse_mass(nodes.component(0).size()) {}

        TautLine line;
        Array<Real> squares;               // m2, of the longest spring of each line
        FieldBuffer<Real> nodes, before;   // m, places of coarse masses, and where they were
        std::vector<double> inverse_mass;  // 1/kg, of coarse masses
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
            if (report.sweeps >= 4 && report.sweeps % 2 == 0) coarse_to_fine(grid, diagonals, constants, x, room);
            excess = sweep(grid, diagonals, constants, x, room, report.sweeps > 0 ? over_relaxation : 0.0);
            ++report.sweeps;
        }
    }

    bool operator==(const StretchLimit&) const = default;

private:
    enum Direction { fly, hoist, falling, rising };

    /// Springs in a line, from mass (i, j) on.
    struct Line {
        int i, j, di, dj, springs;
    };
    static int lines(Direction direction, int columns, int rows) {
        switch (direction) {
            case fly:
                return columns > 1 ? rows : 0;
            case hoist:
                return rows > 1 ? columns : 0;
            default:
                return columns > 1 && rows > 1 ? columns + rows - 3 : 0;
        }
    }
    static Line line(Direction direction, int n, int columns, int rows) {
        switch (direction) {
            case fly:
                return {0, n, 1, 0, columns - 1};
            case hoist:
                return {n, 0, 0, 1, rows - 1};
            case falling: {
                const int i = std::max(0, n - (rows - 2)), j = std::max(0, rows - 2 - n);
                return {i, j, 1, 1, std::min(columns - 1 - i, rows - 1 - j)};
            }
            default: {
                const int i = std::min(n + 1, columns - 1), j = n + 1 - i;
                return {i, j, -1, 1, std::min(i, rows - 1 - j)};
            }
        }
    }

    /// Every mass, or coarse ones `apart` masses from each other and the last: where they are, how light, and how long
    /// what is between two of them may be.
    template <class Real, class InverseMass>
    struct Lattice {
        const Grid& grid;
        int apart, columns, rows;
        Field<Real> x;
        InverseMass inverse_mass;  // 1/kg, of (i, j)
        double diagonal = grid.pitch_diagonal();

        double longest(const Line& along, int k, double stretch) const {
            const int i = along.i + k * along.di, j = along.j + k * along.dj;
            const int across = along.di == 0 ? 0 : cells(std::min(i, i + along.di), grid.columns);
            const int down = along.dj == 0 ? 0 : cells(j, grid.rows), both = std::min(across, down);
            return (1.0 + stretch) *
                   (both * diagonal + (across - both) * grid.pitch_x + (down - both) * grid.pitch_y);
        }
        int cells(int n, int masses) const { return std::min(apart, masses - 1 - n * apart); }

        double shorten(const Line& along, double stretch, double beyond, TautLine& room) const {
            const std::ptrdiff_t from = along.j * x.stride + along.i, step = along.dj * x.stride + along.di;
            const auto at = [&](int k) {
                const auto place = x.template at<Real>(from + k * step);
                return Vec3<double>{place.x, place.y, place.z};
            };
            return room.shorten(
                along.springs, beyond, at,
                [&](int k) -> double { return inverse_mass(along.i + k * along.di, along.j + k * along.dj); },
                [&](int k) { return longest(along, k, stretch); },
                [&](int k, const Vec3<double>& dx) {
                    const auto to = at(k) + dx;
                    x.set(from + k * step,
                          Vec3<Real>{static_cast<Real>(to.x), static_cast<Real>(to.y), static_cast<Real>(to.z)});
                });
        }
    };
    template <class Real, class InverseMass>
    Lattice(const Grid&, int, int, int, Field<Real>, InverseMass) -> Lattice<Real, InverseMass>;

    /// Returns by how much springs were too long, in all (m).
    template <class Real>
    double sweep(const Grid& grid, bool diagonals, const RowConstants<Real>* constants, const Field<Real>& x,
                 Room<Real>& room, double beyond) const {
        const Lattice all{grid,      1, grid.columns,
                          grid.rows, x, [&](int i, int j) { return constants[j].inverse_mass[i]; }};
        double sum = 0.0;
        for (const Direction direction : {fly, hoist, falling, rising}) {
            if (direction >= falling && !diagonals) break;
            const int count = lines(direction, grid.columns, grid.rows);
            if (count == 0) continue;
            const double longest = all.longest(line(direction, 0, grid.columns, grid.rows), 0, stretch);
            look(grid, direction, x, room.squares);
            for (int n = 0; n < count; ++n)
                if (static_cast<double>(room.squares[n]) > longest * longest)
                    sum += all.shorten(line(direction, n, grid.columns, grid.rows), stretch, beyond, room.line);
        }
        return sum;
    }

    /// The square of the longest spring of each line.
    template <class Real>
    static void look(const Grid& grid, Direction direction, const Field<Real>& x, Array<Real>& squares) {
        using V = Vector<Real, 16>;
        const auto square = [](const auto& d) { return dot(d, d); };
        if (direction == fly) {
            for (int j = 0; j < grid.rows; ++j)
                squares[j] = static_cast<Real>(max_square(x.row(j), 0, x.row(j), 1, grid.columns - 1, 1.0));
            return;
        }
        std::fill(squares.begin(), squares.end(), Real(0));
        const int from = direction == rising ? 1 : 0, to = direction == falling ? 1 : 0;
        const int count = direction == hoist ? grid.columns : grid.columns - 1;
        for (int j = 0; j + 1 < grid.rows; ++j) {
            const auto here = x.row(j), next = x.row(j + 1);
            Real* most = squares.data() + (direction == falling ? grid.rows - 2 - j : direction == rising ? j : 0);
            int i = 0;
            for (; i + Lanes<V>::width <= count; i += Lanes<V>::width)
                Lanes<V>::store(most + i,
                                Lanes<V>::greater(Lanes<V>::load(most + i),
                                                  square(next.template at<V>(i + to) - here.template at<V>(i + from))));
            for (; i < count; ++i)
                most[i] = std::max(most[i], square(next.template at<Real>(i + to) - here.template at<Real>(i + from)));
        }
    }

    /// Masses of a row or column of `masses` that are coarse where every `apart`-th is, and the last.
    static int nodes_of(int masses, int apart) { return (masses - 1 + apart - 1) / apart + 1; }

    /// Calls visit(I, J, share) for the coarse masses that move mass (i, j) along, by what share of their own move.
    template <class Visit>
    static void for_nodes(const Grid& grid, int apart, int i, int j, const Visit& visit) {
        const auto place = [&](int n, int masses) {
            const int node = std::min(n, std::max(0, masses - 2)) / apart;
            return std::pair(
                node,
                masses > 1 ? static_cast<double>(n - node * apart) / std::min(apart, masses - 1 - node * apart) : 0.0);
        };
        const auto [I, u] = place(i, grid.columns);
        const auto [J, v] = place(j, grid.rows);
        for (const auto& [J_of, v_of] : {std::pair(J, 1.0 - v), {J + 1, v}})
            for (const auto& [I_of, u_of] : {std::pair(I, 1.0 - u), {I + 1, u}})
                if (u_of * v_of > 0.0) visit(I_of, J_of, u_of * v_of);
    }

    /// From the coarsest grid that there is to one of every other mass: shortens what is between coarse masses, each as
    /// heavy as the masses that it moves along, so that momentum is kept. A path of springs within the limit is never
    /// too long for it.
    template <class Real>
    void coarse_to_fine(const Grid& grid, bool diagonals, const RowConstants<Real>* constants, const Field<Real>& x,
                        Room<Real>& room) const {
        int coarsest = 1;
        while (2 * coarsest < std::max(grid.columns, grid.rows)) coarsest *= 2;
        const Field<Real> nodes = room.nodes.view(), before = room.before.view();
        const auto element = [&](int i, int j) { return static_cast<std::ptrdiff_t>(j) * nodes.stride + i; };
        const auto for_free = [&](const auto& visit) {
            for (int j = 0; j < grid.rows; ++j)
                for (int i = 0; i < grid.columns; ++i)
                    if (const double w = constants[j].inverse_mass[i]; w > 0.0) visit(i, j, w);
        };
        for (int apart = coarsest; apart > 1; apart /= 2) {
            const int columns = nodes_of(grid.columns, apart), rows = nodes_of(grid.rows, apart);
            auto& heavy = room.inverse_mass;
            std::fill(heavy.begin(), heavy.end(), 0.0);
            for_free([&](int i, int j, double w) {
                for_nodes(grid, apart, i, j, [&](int I, int J, double share) { heavy[element(I, J)] += share / w; });
            });
            for (int J = 0; J < rows; ++J)
                for (int I = 0; I < columns; ++I) {
                    const int i = std::min(I * apart, grid.columns - 1), j = std::min(J * apart, grid.rows - 1);
                    const auto place = x.template at<Real>(j * x.stride + i);
                    nodes.set(element(I, J), place), before.set(element(I, J), place);
                    double& w = heavy[element(I, J)];
                    w = constants[j].inverse_mass[i] > 0.0 ? 1.0 / w : 0.0;
                }
            const Lattice coarse{grid, apart, columns, rows, nodes, [&](int I, int J) { return heavy[element(I, J)]; }};
            double sum = 0.0;
            for (const Direction direction : {fly, hoist, falling, rising})
                for (int n = 0; (direction < falling || diagonals) && n < lines(direction, columns, rows); ++n)
                    sum += coarse.shorten(line(direction, n, columns, rows), stretch, over_relaxation, room.line);
            if (sum == 0.0) continue;
            for_free([&](int i, int j, double) {
                const auto n = static_cast<std::ptrdiff_t>(j) * x.stride + i;
                auto place = x.template at<Real>(n);
                for_nodes(grid, apart, i, j, [&](int I, int J, double share) {
                    place = place + static_cast<Real>(share) * difference(before, nodes, element(I, J));
                });
                x.set(n, place);
            });
        }
    }

    template <class Real>
    static Vec3<Real> difference(const Field<Real>& from, const Field<Real>& to, std::ptrdiff_t n) {
        return to.template at<Real>(n) - from.template at<Real>(n);
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
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
