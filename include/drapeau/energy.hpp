// Energy, stretch and sanity of a cloth: summed along each row in the cloth's precision, over the rows in double.
#pragma once

#include "drapeau/model.hpp"

#include <cmath>

namespace drapeau {

/// Calls visit(i, j, i2, j2, k, L) for every spring, once: ends (i, j) and (i2, j2), stiffness N/m, rest length m.
template <class Visit>
void for_each_spring(const Grid& grid, const Material& material, Visit&& visit) {
    const double k = material.stiffness;
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            const bool right = i + 1 < grid.columns, down = j + 1 < grid.rows;
            if (right) visit(i, j, i + 1, j, k, grid.pitch_x);
            if (down) visit(i, j, i, j + 1, k, grid.pitch_y);
            if (right && down && material.diagonal_stiffness) {
                visit(i, j, i + 1, j + 1, *material.diagonal_stiffness, grid.pitch_diagonal());
                visit(i + 1, j, i, j + 1, *material.diagonal_stiffness, grid.pitch_diagonal());
            }
        }
}

/// Springs between neighbours of a row, of a column, and across cells.
struct SpringCounts {
    long long fly, hoist, diagonal;

    SpringCounts(const Grid& grid, const Material& material)
        : fly((grid.columns - 1LL) * grid.rows),
          hoist(grid.columns * (grid.rows - 1LL)),
          diagonal(material.diagonal_stiffness ? 2 * (grid.columns - 1LL) * (grid.rows - 1LL) : 0) {}
    long long all() const { return fly + hoist + diagonal; }
};

/// Sum of k L^2 over the springs (J): the scale of the elastic energy there is room for.
inline double elastic_scale(const Grid& grid, const Material& material) {
    const SpringCounts count(grid, material);
    const auto scale = [](long long springs, double k, double length) {
        return static_cast<double>(springs) * k * length * length;
    };
    return scale(count.fly, material.stiffness, grid.pitch_x) + scale(count.hoist, material.stiffness, grid.pitch_y) +
           scale(count.diagonal, material.diagonal_stiffness.value_or(0.0), grid.pitch_diagonal());
}

/// What a cloth holds at one instant. Attached masses do not move and count for nothing in kinetic energy.
struct Energy {
    double kinetic = 0.0;           // J, sum of m v^2 / 2
    double spring = 0.0;            // J, sum of k (l - L)^2 / 2
    double greatest_stretch = 0.0;  // share, max (l - L) / L; negative where every spring is compressed
    double mean_stretch = 0.0;      // share, mean |l - L| / L
    double greatest_force = 0.0;    // N, max |k (l - L)|

    double total() const { return kinetic + spring; }
};

/// Calls visit.template operator()<V>(i) for whole registers of 0 <= i < count, then one element at a time for the
/// rest.
template <class V, class Visit>
DRAPEAU_INLINE void for_lanes(int count, Visit&& visit) {
    int i = 0;
    for (; i + Lanes<V>::width <= count; i += Lanes<V>::width) visit.template operator()<V>(i);
    for (; i < count; ++i) visit.template operator()<typename Lanes<V>::Real>(i);
}

/// Sums and greatest values of a row, in lanes; taken into double at the row's end, rows in order.
template <class V>
struct RowTally {
    V energy{}, stretch{}, greatest_stretch = Lanes<V>::broadcast(-1), greatest_force{};

    DRAPEAU_INLINE void add(const Triple<V>& d, double k, double length) {
        using Real = typename Lanes<V>::Real;
        const V square = dot(d, d) + static_cast<Real>(shortest_length * shortest_length);
        const V longer = square * inverse_sqrt<V>(square) - static_cast<Real>(length);
        const V size = longer > V{} ? longer : V{} - longer;
        const V share = longer * static_cast<Real>(1.0 / length), force = static_cast<Real>(k) * size;
        energy += static_cast<Real>(0.5 * k) * (longer * longer);
        stretch += size * static_cast<Real>(1.0 / length);
        greatest_stretch = share > greatest_stretch ? share : greatest_stretch;
        greatest_force = force > greatest_force ? force : greatest_force;
    }
    void take_into(Energy& sum) const {
        for (int n = 0; n < Lanes<V>::width; ++n) {
            sum.spring += lane(energy, n);
            sum.mean_stretch += lane(stretch, n);
            sum.greatest_stretch = std::max(sum.greatest_stretch, lane(greatest_stretch, n));
            sum.greatest_force = std::max(sum.greatest_force, lane(greatest_force, n));
        }
    }
    static double lane(const V& value, int n) {
        if constexpr (Lanes<V>::width == 1)
            return static_cast<double>(value);
        else
            return static_cast<double>(value[n]);
    }
};

/// Measures a cloth whose masses and springs are all alike.
template <class Real, class V = Vector<Real>>
Energy measure(const Cloth<Real>& cloth, const Material& material) {
    const Grid& grid = cloth.grid();
    const auto rows = cloth.view();
    Energy sum{.greatest_stretch = -1.0};
    for (int j = 0; j < grid.rows; ++j) {
        RowTally<V> wide;
        RowTally<Real> rest;
        const auto tally = [&]<class L>() -> auto& {
            if constexpr (std::same_as<L, Real>)
                return rest;
            else
                return wide;
        };
        const auto here = rows[j], next = rows[j + 1 < grid.rows ? j + 1 : j];
        // Springs from here[i + from] to end[i + to].
        const auto springs = [&](int count, const Row<Real>& end, int from, int to, double k, double length) {
            for_lanes<V>(count, [&]<class L>(int i) {
                const auto d = end.template position<L>(i + to) - here.template position<L>(i + from);
                tally.template operator()<L>().add(d, k, length);
            });
        };
        springs(grid.columns - 1, here, 0, 1, material.stiffness, grid.pitch_x);
        if (j + 1 < grid.rows) {
            springs(grid.columns, next, 0, 0, material.stiffness, grid.pitch_y);
            if (material.diagonal_stiffness) {
                springs(grid.columns - 1, next, 0, 1, *material.diagonal_stiffness, grid.pitch_diagonal());
                springs(grid.columns - 1, next, 1, 0, *material.diagonal_stiffness, grid.pitch_diagonal());
            }
        }
        wide.take_into(sum);
        rest.take_into(sum);

        double squares = 0.0;  // of the speeds, m2/s2
        V wide_squares{};
        for_lanes<V>(grid.columns, [&]<class L>(int i) {
            const auto v = here.template velocity<L>(i);
            if constexpr (std::same_as<L, Real>)
                squares += static_cast<double>(dot(v, v));
            else
                wide_squares += dot(v, v);
        });
        for (int n = 0; n < Lanes<V>::width; ++n) squares += RowTally<V>::lane(wide_squares, n);
        sum.kinetic += 0.5 * material.mass * squares;
    }
    const double springs = static_cast<double>(SpringCounts(grid, material).all());
    if (springs == 0.0) sum.greatest_stretch = 0.0;
    if (springs > 0.0) sum.mean_stretch /= springs;
    return sum;
}

/// A run has diverged when a value is not finite or its energy exceeds 100 times all it could have.
inline bool has_diverged(const Energy& now, double energy_it_could_have) {
    return !(now.total() <= 100.0 * energy_it_could_have);  // also true for NaN
}

}  // namespace drapeau
