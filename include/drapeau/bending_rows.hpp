// Bending rows: a pass over the rows that finds what bending does to a state. Nothing moves in it, so it looks at two
// rows above and below.
#pragma once

#include "drapeau/pass_row.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// Rows that bending looks at on either side.
inline constexpr int bending_reach = 2;

/// Adds what bending accelerates each mass with to what terms push it with (pass.acceleration), into pass.out; the
/// state is in fields 0 and 1. `braked`: whether velocities count; accounted: what it stores accelerates with into
/// pass.bent besides, and the energy stored into the rows' sums.
template <class V, bool braked, bool accounted>
void bending_rows(const Pass<typename Lanes<V>::Real>& pass) {
    using L = Lanes<V>;
    using Real = typename L::Real;
    const BendingStrength<Real> bending = pass.bending;
    constexpr int rows_seen = 2 * bending_reach + 1, own = bending_reach;
    for (int j = pass.first; j < pass.last; ++j) {
        if (pass.accelerate) pass.accelerate(pass.terms, j, pass.time);
        Field<Real> x[rows_seen], v[rows_seen];
        for (int n = 0; n < rows_seen; ++n) {
            const int there = j + n - own, last = pass.rows - 1;
            const PassRow<Real, 2> row(pass, there < 0 ? 0 : there > last ? last : there);
            x[n] = row.field[0], v[n] = row.field[1];
        }
        const Field<const Real> pushed = PassRow<Real, 2>(pass, j).pushed;
        const Field<Real> out = pass.out.row(j), bent = accounted ? pass.bent.row(j) : out;
        const RowConstants<Real>& constants = pass.constants[j];
        // Whether the rows above, here and below are the middle of three.
        const auto exists = [&](int row) { return static_cast<Real>(row > 0 && row + 1 < pass.rows); };
        const Real above = exists(j - 1), here = exists(j), below = exists(j + 1);
        V energy{};
        for (int i = 0; i < pass.width; i += L::width) {
            const V to_left = L::load(constants.bend_fly + i - 1), centre = L::load(constants.bend_fly + i),
                    to_right = L::load(constants.bend_fly + i + 1), hoist = L::load(constants.bend_hoist + i);
            const auto curvature = [](const Vec3<V>& a, const Vec3<V>& b, const Vec3<V>& c)
                                       DRAPEAU_INLINE_LAMBDA { return (a - b) - (b - c); };
            // The force of k |curvature|^2 / 2 of the three lines that a mass is in: M_left - 2 M + M_right, M = k
            // times the curvature at each.
            const auto resist = [&](const Field<Real>* field, Real k_fly, Real k_hoist) DRAPEAU_INLINE_LAMBDA {
                const auto at = [&](int row, int column)
                                    DRAPEAU_INLINE_LAMBDA { return field[row].template at<V>(i + column); };
                const auto along = curvature(at(own, -1), at(own, 0), at(own, 1));
                const auto down = curvature(at(own - 1, 0), at(own, 0), at(own + 1, 0));
                if constexpr (accounted)
                    if (field == x)
                        energy = energy + (k_fly * centre) * dot(along, along) +
                                 ((k_hoist * here) * hoist) * dot(down, down);
                const auto fly = to_left * curvature(at(own, -2), at(own, -1), at(own, 0)) -
                                 (Real(2) * centre) * along + to_right * curvature(at(own, 0), at(own, 1), at(own, 2));
                const auto rows = above * curvature(at(own - 2, 0), at(own - 1, 0), at(own, 0)) -
                                  (Real(2) * here) * down +
                                  below * curvature(at(own, 0), at(own + 1, 0), at(own + 2, 0));
                return k_fly * fly + (k_hoist * hoist) * rows;
            };
            const V w = V{} - L::load(constants.inverse_mass + i);
            auto a = w * resist(x, bending.k_fly, bending.k_hoist);
            if constexpr (accounted) bent.set(i, a);
            if constexpr (braked) a = a + w * resist(v, bending.c_fly, bending.c_hoist);
            out.set(i, pushed.template at<V>(i) + a);
        }
        if constexpr (accounted) pass.sums[j].bending = 0.5 * sum_of(energy);
    }
}

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
