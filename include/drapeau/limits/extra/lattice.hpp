// Lattice: the masses of a grid, all or coarse ones some cells apart, and the lines of springs between them.
#pragma once

#include "drapeau/limits/extra/taut_line.hpp"
#include "drapeau/state.hpp"

#include <algorithm>

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// Where springs run: along the fly, down the hoist, or across cells, falling or rising along the fly.
enum class Along { fly, hoist, falling, rising };
inline constexpr Along all_lines[] = {Along::fly, Along::hoist, Along::falling, Along::rising};

/// Springs in a line: from mass (i, j), each to (di, dj) from the one before.
struct SpringLine {
    int i, j, di, dj, springs;
};

inline int count_lines(Along along, int columns, int rows) {
    if (along == Along::fly) return columns > 1 ? rows : 0;
    if (along == Along::hoist) return rows > 1 ? columns : 0;
    return columns > 1 && rows > 1 ? columns + rows - 3 : 0;
}
/// Line n of those. The spring from (i, j) to (i + 1, j + 1) is in falling line i - j + rows - 2, the one from
/// (i + 1, j) to (i, j + 1) in rising line i + j.
inline SpringLine spring_line(Along along, int n, int columns, int rows) {
    if (along == Along::fly) return {0, n, 1, 0, columns - 1};
    if (along == Along::hoist) return {n, 0, 0, 1, rows - 1};
    if (along == Along::falling) {
        const int i = std::max(0, n - (rows - 2)), j = std::max(0, rows - 2 - n);
        return {i, j, 1, 1, std::min(columns - 1 - i, rows - 1 - j)};
    }
    const int i = std::min(n + 1, columns - 1), j = n + 1 - i;
    return {i, j, -1, 1, std::min(i, rows - 1 - j)};
}

/// Masses of a row or column of `masses` where one in `apart` is taken, and the last.
constexpr int nodes_of(int masses, int apart) {
    return (masses + apart - 2) / apart + 1;
}

/// Positions `x` of every `apart`-th mass each way, and of the last. `inverse_mass` (1/kg) is asked with the node's own
/// column and row.
template <class Real, class InverseMass>
struct Lattice {
    const Grid& grid;
    int apart;
    Field<Real> x;
    InverseMass inverse_mass;
    int columns = nodes_of(grid.columns, apart), rows = nodes_of(grid.rows, apart);
    double diagonal = grid.pitch_diagonal();

    /// Calls visit(n, line) for all lines that run along.
    template <class Visit>
    void for_lines(Along along, const Visit& visit) const {
        for (int n = 0; n < count_lines(along, columns, rows); ++n) visit(n, spring_line(along, n, columns, rows));
    }

    /// The rest length (m) of the shortest way along springs from node k of a line to the next.
    double rest_length(const SpringLine& line, int k) const {
        const int across = line.di == 0 ? 0 : cells(line.i + k * line.di + std::min(line.di, 0), grid.columns);
        const int down = line.dj == 0 ? 0 : cells(line.j + k * line.dj, grid.rows), both = std::min(across, down);
        return both * diagonal + (across - both) * grid.pitch_x + (down - both) * grid.pitch_y;
    }

    /// TautLine::shorten for one line, where nothing may be longer than `longest` times its rest length.
    double shorten(const SpringLine& line, double longest, double beyond, TautLine& taut) const {
        const std::ptrdiff_t first = line.j * x.stride + line.i, step = line.dj * x.stride + line.di;
        const auto at = [&](int k) {
            const auto place = x.template at<Real>(first + k * step);
            return Vec3<double>{place.x, place.y, place.z};
        };
        return taut.shorten(
            line.springs, beyond, at,
            [&](int k) -> double { return inverse_mass(line.i + k * line.di, line.j + k * line.dj); },
            [&](int k) { return longest * rest_length(line, k); },
            [&](int k, const Vec3<double>& dx) {
                const auto to = at(k) + dx;
                x.set(first + k * step,
                      Vec3<Real>{static_cast<Real>(to.x), static_cast<Real>(to.y), static_cast<Real>(to.z)});
            });
    }

private:
    int cells(int node, int masses) const { return std::min(apart, masses - 1 - node * apart); }
};
template <class Real, class InverseMass>
Lattice(const Grid&, int, Field<Real>, InverseMass) -> Lattice<Real, InverseMass>;

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
