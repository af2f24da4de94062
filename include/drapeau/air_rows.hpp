// Air rows: passes over the rows that find what the air does to the faces of a state. Nothing moves in them, so they
// look at rows above and below.
#pragma once

#include "drapeau/pass_row.hpp"
#include "drapeau/terms/air.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// Calls visit(i, constants, flow, pushed) with how the air passes each register of the rows of a pass, of the state in
/// fields 0 and 1. Neighbours stay as they are: nothing may move meanwhile.
template <class V, class Visit, class RowEnd>
DRAPEAU_INLINE void for_rows_in_air(const Pass<typename Lanes<V>::Real>& pass, Visit&& visit, RowEnd&& row_end) {
    using L = Lanes<V>;
    using Real = typename L::Real;
    for (int j = pass.first; j < pass.last; ++j) {
        if (pass.accelerate) pass.accelerate(pass.terms, j, pass.time);
        const PassRow<Real, 2> row(pass, j);
        const Field<Real> here = row.field[0];
        const Field<Real> above = j > 0 ? PassRow<Real, 1>(pass, j - 1).field[0] : here;
        const Field<Real> below = j + 1 < pass.rows ? PassRow<Real, 1>(pass, j + 1).field[0] : here;
        const Field<const Real> wind = pass.wind.row(j);
        const RowConstants<Real>& constants = pass.constants[j];
        const auto fading = static_cast<Real>(smallest_face) * constants.fly.length * constants.hoist.length;
        // Left of the first column stands the first once more; right of the last the difference is nothing, as is the
        // stiffness there.
        const Vec3<V> first{L::broadcast(here.x[0]), L::broadcast(here.y[0]), L::broadcast(here.z[0])};
        for (int i = 0; i < pass.width; i += L::width) {
            const auto x = here.template at<V>(i), beyond = here.template at<V>(i + 1) - x;
            const V k = L::load(constants.fly.k + i);
            const Vec3<V> right{L::where_positive(k, beyond.x), L::where_positive(k, beyond.y),
                                L::where_positive(k, beyond.z)};
            const auto left = x - (i > 0 ? here.template at<V>(i - 1) : shifted(first, x));
            const auto u = wind.template at<V>(i) - row.field[1].template at<V>(i);
            visit(i, constants,
                  air_flow(left + right, above.template at<V>(i) - below.template at<V>(i), u, fading * fading),
                  row.pushed);
        }
        row_end(j);
    }
}

/// What terms push each mass with and the air on its faces besides, into pass.out.
template <class V, bool pressure, bool skin>
void air_rows(const Pass<typename Lanes<V>::Real>& pass) {
    using L = Lanes<V>;
    using Real = typename L::Real;
    const AirStrength<Real> air = pass.air;
    Field<Real> out = pass.out.row(pass.first);
    for_rows_in_air<V>(
        pass,
        [&](int i, const RowConstants<Real>& constants, const AirFlow<V>& flow, const Field<const Real>& pushed)
            DRAPEAU_INLINE_LAMBDA {
                const V area = L::load(constants.area + i);
                auto a = pushed.template at<V>(i);
                if constexpr (pressure) a = a + ((air.pressure * area) * (flow.speed * flow.across)) * flow.face;
                if constexpr (skin) a = a + ((air.skin * area) * flow.speed_along) * flow.along;
                out.set(i, a);
            },
        [&](int j) DRAPEAU_INLINE_LAMBDA { out = pass.out.row(j + 1); });
}

/// The greatest rate at which the air brakes a mass of each row (Air::most_rate), at the speeds that there are.
template <class V>
void air_rate_rows(const Pass<typename Lanes<V>::Real>& pass) {
    using L = Lanes<V>;
    using Real = typename L::Real;
    V most{};
    for_rows_in_air<V>(
        pass,
        [&](int i, const RowConstants<Real>& constants, const AirFlow<V>& flow,
            const Field<const Real>&) DRAPEAU_INLINE_LAMBDA {
            most = L::greater(most, (Real(2) * L::load(constants.area + i)) *
                                        L::greater(pass.air.pressure * flow.speed, pass.air.skin * flow.speed_along));
        },
        [&](int j) DRAPEAU_INLINE_LAMBDA {
            pass.sums[j].max_air_rate = max_of(most);
            most = V{};
        });
}

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
