// Bending rows: passes over the rows that find what bending does to a state. Nothing moves in them, so they look at two
// rows above and below.
#pragma once

#include "drapeau/pass_row.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// Rows that bending looks at on either side.
inline constexpr int bending_reach = 2;

/// Rows of resistances that a pass keeps: of triples down the hoist three in turn, of those along the fly one.
inline constexpr int resistance_rows = 4;

/// Three masses in a line, a triple, store k/2 |d|^2, d being their second difference (m). Of the triple's resistance
/// R = k d (N) each outer mass feels -R, the middle one 2 R; so a mass feels -(R_before - 2 R + R_after) of a line.
template <class V, bool braked, bool accounted>
class BendingPass {
public:
    using L = Lanes<V>;
    using Real = typename L::Real;

    DRAPEAU_INLINE explicit BendingPass(const Pass<Real>& pass) : pass_(pass) {}

    /// Calls visit(i, a) with what bending accelerates each register of the rows with, and row_end(j). Velocities count
    /// if `braked`; if accounted, the energy stored goes into the rows' sums.
    template <class Visit, class RowEnd>
    DRAPEAU_INLINE void run(Visit&& visit, RowEnd&& row_end) {
        find_down(pass_.first - 1);
        double energy_below = find_down(pass_.first);
        for (int j = pass_.first; j < pass_.last; ++j) {
            const double energy_here = energy_below;
            energy_below = find_down(j + 1);
            const double energy_along = find_along(j);
            if constexpr (accounted) pass_.sums[j].bending = energy_here + energy_along;
            const Field<Real> fly = pass_.resistances.row(resistance_rows - 1);
            const Field<Real> above = down(j - 1), here = down(j), below = down(j + 1);
            const Real* const inverse_mass = pass_.constants[j].inverse_mass;
            for (int i = 0; i < pass_.width; i += L::width) {
                const auto force =
                    second_difference(fly.template at<V>(i - 1), fly.template at<V>(i), fly.template at<V>(i + 1)) +
                    second_difference(above.template at<V>(i), here.template at<V>(i), below.template at<V>(i));
                visit(i, (V{} - L::load(inverse_mass + i)) * force);
            }
            row_end(j);
        }
    }

private:
    DRAPEAU_INLINE static Vec3<V> second_difference(const Vec3<V>& a, const Vec3<V>& b, const Vec3<V>& c) {
        return (a - b) - (b - c);
    }
    DRAPEAU_INLINE Field<Real> down(int j) const {
        return pass_.resistances.row((j + resistance_rows - 1) % (resistance_rows - 1));
    }

    /// The resistances of the triples down the hoist whose middle is row j. Returns the energy they store (J), if
    /// accounted.
    DRAPEAU_INLINE double find_down(int j) {
        const Field<Real> to = down(j);
        const bool exists = j > 0 && j + 1 < pass_.rows;
        if (!exists) {
            for (int i = 0; i < pass_.width; i += L::width) to.set(i, Vec3<V>{});
            return 0.0;
        }
        const PassRow<Real, 2> above(pass_, j - 1), here(pass_, j), below(pass_, j + 1);
        const Real* const share = pass_.constants[j].bend_hoist;
        V energy{};
        for (int i = 0; i < pass_.width; i += L::width)
            to.set(i, resistance(L::load(share + i), pass_.bending.k_hoist, pass_.bending.c_hoist, energy,
                                 [&](int field) DRAPEAU_INLINE_LAMBDA {
                                     return second_difference(above.field[field].template at<V>(i),
                                                              here.field[field].template at<V>(i),
                                                              below.field[field].template at<V>(i));
                                 }));
        return accounted ? 0.5 * sum_of(energy) : 0.0;
    }
    /// Those of row j along the fly, likewise.
    DRAPEAU_INLINE double find_along(int j) {
        const PassRow<Real, 2> row(pass_, j);
        const Real* const share = pass_.constants[j].bend_fly;
        V energy{};
        const Field<Real> to = pass_.resistances.row(resistance_rows - 1);
        for (int i = 0; i < pass_.width; i += L::width)
            to.set(i, resistance(L::load(share + i), pass_.bending.k_fly, pass_.bending.c_fly, energy,
                                 [&](int field) DRAPEAU_INLINE_LAMBDA {
                                     const Field<Real>& f = row.field[field];
                                     return second_difference(f.template at<V>(i - 1), f.template at<V>(i),
                                                              f.template at<V>(i + 1));
                                 }));
        return accounted ? 0.5 * sum_of(energy) : 0.0;
    }
    template <class Difference>
    DRAPEAU_INLINE static Vec3<V> resistance(V share, Real k, Real c, V& energy, Difference&& difference_of) {
        const auto bent = difference_of(0);
        if constexpr (accounted) energy = energy + (k * share) * dot(bent, bent);
        if constexpr (braked) return share * (k * bent + c * difference_of(1));
        return (k * share) * bent;
    }

    const Pass<Real>& pass_;
};

/// Adds what bending accelerates each mass with to what terms push it with (pass.acceleration), into pass.out; the
/// state is in fields 0 and 1. `braked`: whether it brakes; accounted: what it stores accelerates with alone into
/// pass.bent, and the energy stored into the rows' sums.
template <class V, bool braked, bool accounted>
void bending_rows(const Pass<typename Lanes<V>::Real>& pass) {
    using Real = typename Lanes<V>::Real;
    if constexpr (accounted) {
        Field<Real> bent = pass.bent.row(pass.first);
        BendingPass<V, false, true>(pass).run([&](int i, const Vec3<V>& a) DRAPEAU_INLINE_LAMBDA { bent.set(i, a); },
                                              [&](int j) DRAPEAU_INLINE_LAMBDA { bent = pass.bent.row(j + 1); });
    }
    Field<Real> out = pass.out.row(pass.first);
    Field<const Real> pushed{};
    const auto begin = [&](int j) DRAPEAU_INLINE_LAMBDA {
        if (j == pass.last) return;
        if (pass.accelerate) pass.accelerate(pass.terms, j, pass.time);
        out = pass.out.row(j), pushed = pass.acceleration.row(j);
    };
    begin(pass.first);
    BendingPass<V, braked, false>(pass).run([&](int i, const Vec3<V>& a)
                                                DRAPEAU_INLINE_LAMBDA { out.set(i, pushed.template at<V>(i) + a); },
                                            [&](int j) DRAPEAU_INLINE_LAMBDA { begin(j + 1); });
}

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
