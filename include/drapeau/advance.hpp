// Advance: the sweep with a method as its `finish`: each row is moved in place as soon as its force is complete.
#pragma once

#include "drapeau/air_rows.hpp"
#include "drapeau/bending_rows.hpp"
#include "drapeau/extra/added_air.hpp"
#include "drapeau/method.hpp"
#include "drapeau/pass_row.hpp"
#include "drapeau/sweep.hpp"

#include <limits>
#include <utility>

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// The acceleration but for drag and friction of a register of masses; zero where held, whatever the force.
template <class V>
DRAPEAU_INLINE Vec3<V> acceleration_of(const Vec3<V>& force, V inverse_mass, const Vec3<V>& pushed) {
    using L = Lanes<V>;
    const auto a = inverse_mass * force + pushed;
    return {L::where_positive(inverse_mass, a.x), L::where_positive(inverse_mass, a.y),
            L::where_positive(inverse_mass, a.z)};
}

/// The same of a register of a row, with the air that moves along: it pushes, and it resists any acceleration along the
/// normal, a0 - rate v, that of drag and friction included.
template <int seen_velocity, class V, int fields>
DRAPEAU_INLINE Vec3<V> acceleration_of(const Vec3<V>& force, const PassRow<typename Lanes<V>::Real, fields>& row,
                                       const RowConstants<typename Lanes<V>::Real>& constants, int i) {
    using L = Lanes<V>;
    auto a = acceleration_of(force, L::load(constants.inverse_mass + i), row.pushed.template at<V>(i));
    if (row.added_push.x) {
        const auto s = row.added_direction.template at<V>(i);
        const auto v = row.field[seen_velocity].template at<V>(i);
        a = a + row.added_push.template at<V>(i);
        a = a - (dot(s, a) - L::load(constants.rate + i) * dot(s, v)) * s;
    }
    return a;
}

/// g, of a register of a row: the air that moves along resists an acceleration a like a mass m g g^T. Asked only where
/// there is some.
template <class V>
DRAPEAU_INLINE Vec3<V> added_inertia(const Field<const typename Lanes<V>::Real>& direction, std::ptrdiff_t i) {
    using Real = typename Lanes<V>::Real;
    const auto s = direction.template at<V>(i);
    constexpr Real least = 4 * std::numeric_limits<Real>::epsilon();  // of what the cloth is of all that moves
    return inverse_sqrt<V>(Lanes<V>::greater(Lanes<V>::broadcast(least), Real(1) - dot(s, s))) * s;
}

/// Sweeps the rows of a pass, `fresh` beginning each. Calls finish(the row, its constants, i, value) on each register
/// and row_end(j, operation) after each row, those of the halo above included.
template <class V, class Operation, bool diagonals, int fields, int seen_position, int seen_velocity, class Finish,
          class RowEnd>
DRAPEAU_INLINE void for_rows(const Pass<typename Lanes<V>::Real>& pass, Finish&& finish, RowEnd&& row_end,
                             const Operation& fresh = {}) {
    using Real = typename Lanes<V>::Real;
    Sweep<V, Operation, diagonals> sweep(pass.waiting, pass.width);
    sweep.begin();
    sweep.operation = fresh;
    const bool at_top = pass.above[0].x == nullptr, at_bottom = pass.below[0].x == nullptr;
    const int first = at_top ? pass.first : pass.first - Operation::reach,
              seen_last = at_bottom ? pass.last : pass.last + 1;
    PassRow<Real, fields> here(pass, first), next = here;
    for (int j = first; j < pass.last; ++j) {
        if (pass.accelerate) pass.accelerate(pass.terms, j, pass.time);
        const RowConstants<Real>& constants = pass.constants[j];
        const bool has_next = j + 1 < seen_last;
        if (has_next) next = PassRow<Real, fields>(pass, j + 1);
        const SeenRow<Real> seen{here.field[seen_position], here.field[seen_velocity]},
            seen_next{next.field[seen_position], next.field[seen_velocity]};
        sweep.row(constants, seen, has_next ? &seen_next : nullptr,
                  [&](int i, const typename Operation::Value& value)
                      DRAPEAU_INLINE_LAMBDA { finish(here, constants, i, value); });
        row_end(j, sweep.operation);
        sweep.operation = fresh;
        here = next;
    }
}

/// One pass of a step. `rated`: whether there is drag or friction.
template <class V, class Method, int number, bool damped, bool diagonals, bool rated>
void advance_rows(const Pass<typename Lanes<V>::Real>& pass) {
    using L = Lanes<V>;
    using Real = typename L::Real;
    constexpr int fields = Method::template fields<damped>;
    const Real dt = pass.dt;
    for_rows<V, SpringForce<V, damped>, diagonals, fields, Method::template seen_position<damped>,
             Method::template seen_velocity<damped>>(
        pass,
        [&](const auto& row, const RowConstants<Real>& constants, int i, const Vec3<V>& force) DRAPEAU_INLINE_LAMBDA {
            const auto a = acceleration_of<Method::template seen_velocity<damped>>(force, row, constants, i);
            if constexpr (rated)
                Method::template move<number, damped>(Masses<V>{row.field, i}, a, L::load(constants.rate + i), dt);
            else
                Method::template move<number, damped>(Masses<V>{row.field, i}, a, NoRate{}, dt);
        },
        [](int, const auto&) DRAPEAU_INLINE_LAMBDA {});
}

/// Evaluates the forces in parts and sums their work for each row: `share` of dt F . v with the v of move(masses,
/// constants, a), which moves a register or only says how it moves.
template <class V, bool damped, bool diagonals, int fields, int seen_position, int seen_velocity, class Move>
DRAPEAU_INLINE void for_rows_accounted(const Pass<typename Lanes<V>::Real>& pass, double share, Move&& move) {
    using L = Lanes<V>;
    using Real = typename L::Real;
    V external{}, damping{};
    Vec3<V> drift{};
    Field<Real> bent = pass.bent.x ? pass.bent.row(pass.first) : pass.bent;  // a halo's values are not counted
    for_rows<V, SpringForceParts<V, damped>, diagonals, fields, seen_position, seen_velocity>(
        pass,
        [&](const auto& row, const auto& constants, int i, const Parts<V>& force) DRAPEAU_INLINE_LAMBDA {
            const V w = L::load(constants.inverse_mass + i), m = L::load(constants.mass + i);
            const auto springs = force.elastic + force.damping;
            const auto a = acceleration_of<seen_velocity>(springs, row, constants, i);
            const auto motion = move(Masses<V>{row.field, i}, constants, a);
            auto but_bent = motion.acceleration;
            if (pass.bent.x) but_bent = but_bent - bent.template at<V>(i);
            // What is held and moved all the same (Stepper::haul) is pulled against its springs.
            const V pulled = dot(force.elastic, motion.velocity);
            external = external + (m * dot(but_bent, motion.velocity) - (m * w) * dot(springs, motion.velocity)) -
                       (pulled - L::where_positive(w, pulled));
            damping = damping + dot((m * w) * force.damping, motion.velocity);
            drift = drift + m * motion.velocity;
        },
        [&](int j, const auto&) DRAPEAU_INLINE_LAMBDA {
            if (j >= pass.first) {
                const double step = static_cast<double>(pass.dt) * share;
                pass.sums[j].external_work += step * sum_of(external);
                pass.sums[j].damping_work += step * sum_of(damping);
                pass.sums[j].drift[0] += step * sum_of(drift.x);
                pass.sums[j].drift[1] += step * sum_of(drift.y);
                pass.sums[j].drift[2] += step * sum_of(drift.z);
            }
            if (j >= pass.first && pass.bent.x) bent = pass.bent.row(j + 1);
            external = damping = V{};
            drift = Vec3<V>{};
        });
}

/// One pass of a step, its forces taken apart and their work summed with the method's own v and weight, so that the
/// work of all forces is what the kinetic energy gains.
template <class V, class Method, int number, bool damped, bool diagonals>
void advance_rows_accounted(const Pass<typename Lanes<V>::Real>& pass) {
    for_rows_accounted<V, damped, diagonals, Method::template fields<damped>, Method::template seen_position<damped>,
                       Method::template seen_velocity<damped>>(
        pass, Method::weight[number],
        [&](const Masses<V>& masses, const auto& constants, const Vec3<V>& a) DRAPEAU_INLINE_LAMBDA {
            return Method::template move<number, damped>(masses, a, Lanes<V>::load(constants.rate + masses.i), pass.dt);
        });
}

/// Energy and stretch of the state as it is; nothing moves.
template <class V, class Method, bool damped, bool diagonals>
void measure_rows(const Pass<typename Lanes<V>::Real>& pass) {
    using L = Lanes<V>;
    using Real = typename L::Real;
    constexpr int fields = Method::template fields<damped>;
    const Real dt = pass.dt;
    V kinetic{}, kinetic_now{}, power{};
    Vec3<V> moment{};
    Field<Real> bent = pass.bent.x ? pass.bent.row(pass.first) : pass.bent;  // a halo's values are not counted
    for_rows<V, SpringGauge<V, damped>, diagonals, fields, 0, Method::template seen_velocity<damped>>(
        pass,
        [&](const auto& row, const RowConstants<Real>& constants, int i, const Parts<V>& force) DRAPEAU_INLINE_LAMBDA {
            const V w = L::load(constants.inverse_mass + i), m = L::load(constants.mass + i);
            const auto v = row.field[1].template at<V>(i);
            const auto a = Method::total(acceleration_of<Method::template seen_velocity<damped>>(
                                             force.elastic + force.damping, row, constants, i),
                                         L::load(constants.rate + i), v, dt);
            if constexpr (Method::staggered)
                kinetic = kinetic + m * dot(v, v + dt * a);
            else
                kinetic = kinetic + m * dot(v, v);
            const auto centred = v + pass.half_kick * a;
            kinetic_now = kinetic_now + m * dot(centred, centred);
            auto but_stored = a - w * force.elastic;
            if (pass.bent.x) but_stored = but_stored - bent.template at<V>(i);
            power = power + m * dot(but_stored, v);
            moment = moment + m * row.field[0].template at<V>(i);
        },
        [&](int j, const auto& gauge) DRAPEAU_INLINE_LAMBDA {
            if (j >= pass.first) {
                RowSums& sums = pass.sums[j];
                sums.kinetic = 0.5 * sum_of(kinetic);
                sums.kinetic_now = 0.5 * sum_of(kinetic_now);
                sums.power = sum_of(power);
                sums.elastic = sum_of(gauge.elastic) + (pass.bent.x ? sums.bending : 0.0);
                sums.stretch = sum_of(gauge.stretch);
                sums.max_stretch = max_of(gauge.max_stretch);
                sums.max_force = max_of(gauge.max_force);
                sums.force_squares = sum_of(gauge.force_squares);
                sums.moment[0] = sum_of(moment.x), sums.moment[1] = sum_of(moment.y), sums.moment[2] = sum_of(moment.z);
            }
            if (j >= pass.first && pass.bent.x) bent = pass.bent.row(j + 1);
            kinetic = kinetic_now = power = V{};
            moment = Vec3<V>{};
        });
}

/// The acceleration but for drag and friction of every mass, stored in pass.out.
template <class V, class Method, bool damped, bool diagonals>
void evaluate_rows(const Pass<typename Lanes<V>::Real>& pass) {
    using L = Lanes<V>;
    using Real = typename L::Real;
    constexpr int fields = Method::template fields<damped>;
    Field<Real> out = pass.out.row(pass.first);  // a halo's values are overwritten by the row's own
    for_rows<V, SpringForce<V, damped>, diagonals, fields, 0, Method::template seen_velocity<damped>>(
        pass,
        [&](const auto& row, const RowConstants<Real>& constants, int i, const Vec3<V>& force) DRAPEAU_INLINE_LAMBDA {
            out.set(i, acceleration_of<Method::template seen_velocity<damped>>(force, row, constants, i));
        },
        [&](int j, const auto&) DRAPEAU_INLINE_LAMBDA {
            if (j >= pass.first) out = pass.out.row(j + 1);
        });
}

/// u -> M^-1 [(k_weight K + c_weight C) u] + rate_weight * rate u, u being field 1, stored in pass.out: K and C are the
/// Hessian of the springs as they are and of their dampers. Where the cloth bends, pass.bent and pass.acceleration are
/// its parts of -M^-1 K u and -M^-1 C u. The rows' sums get u.Ku, u.Cu and rate u.Mu (as elastic, damping_work and
/// external_work) and, as products, u.Mu and |out|^2 with M.
template <class V, bool damped, bool diagonals>
void stiffness_rows(const Pass<typename Lanes<V>::Real>& pass) {
    using L = Lanes<V>;
    using Real = typename L::Real;
    const Real k_weight = static_cast<Real>(pass.k_weight), c_weight = static_cast<Real>(pass.c_weight),
               rate_weight = static_cast<Real>(pass.rate_weight);
    // A halo's values are overwritten by the row's own.
    Field<Real> out = pass.out.row(pass.first), bent = pass.bent.x ? pass.bent.row(pass.first) : pass.bent;
    V elastic{}, damping{}, external{}, before{}, after{};
    for_rows<V, SpringHessianParts<V, damped>, diagonals, 2, 0, 1>(
        pass,
        [&](const auto& row, const RowConstants<Real>& constants, int i, const Parts<V>& pull) DRAPEAU_INLINE_LAMBDA {
            const V w = L::load(constants.inverse_mass + i), m = L::load(constants.mass + i),
                    rate = L::load(constants.rate + i);
            const auto u = row.field[1].template at<V>(i);
            const auto resisting = V{} - (w * k_weight), braking = V{} - (w * c_weight);
            auto result = acceleration_of(resisting * pull.elastic + braking * pull.damping,
                                          L::where_positive(w, L::broadcast(1)), (rate_weight * rate) * u);
            if (pass.bent.x) {
                const auto stored = bent.template at<V>(i), braked = row.pushed.template at<V>(i);
                result = result - k_weight * stored - c_weight * braked;
                elastic = elastic - m * dot(u, stored);
                damping = damping - m * dot(u, braked);
            }
            out.set(i, result);
            elastic = elastic - dot(u, pull.elastic);
            if constexpr (damped) damping = damping - dot(u, pull.damping);
            external = external + (m * rate) * dot(u, u);
            before = before + m * dot(u, u);
            after = after + m * dot(result, result);
        },
        [&](int j, const auto&) DRAPEAU_INLINE_LAMBDA {
            if (j >= pass.first) {
                RowSums& sums = pass.sums[j];
                sums.elastic = sum_of(elastic), sums.damping_work = sum_of(damping);
                sums.external_work = sum_of(external);
                sums.products[0][0] = sum_of(before), sums.products[0][1] = sum_of(after);
                out = pass.out.row(j + 1);
                if (pass.bent.x) bent = pass.bent.row(j + 1);
            }
            elastic = damping = external = before = after = V{};
        });
}

/// A method's kernels in registers of V.
template <class V, class Method, bool damped, bool diagonals, bool rated = true>
constexpr Kernels<typename Lanes<V>::Real> kernels_of() {
    using Real = typename Lanes<V>::Real;
    Kernels<Real> k{};
    k.passes = Method::passes;
    k.fields = Method::template fields<damped>;
    k.seen_position = Method::template seen_position<damped>;
    k.seen_velocity = Method::template seen_velocity<damped>;
    k.staggered = Method::staggered;
    k.starts_with_forces = Method::starts_with_forces;
    if constexpr (Method::solves) {
        k.stage_time[0] = Method::stage_time[0];
        k.step = &Method::template step<V, damped, diagonals>;
    } else {
        [&]<int... n>(std::integer_sequence<int, n...>) {
            ((k.stage_time[n] = Method::stage_time[n]), ...);
            ((k.advance[n] = &advance_rows<V, Method, n, damped, diagonals, rated>), ...);
            ((k.advance_accounted[n] = &advance_rows_accounted<V, Method, n, damped, diagonals>), ...);
        }
        (std::make_integer_sequence<int, Method::passes>());
    }
    k.looked_velocity = Method::Looks::template seen_velocity<damped>;
    k.air[1][0] = &air_rows<V, true, false>;
    k.air[0][1] = &air_rows<V, false, true>;
    k.air[1][1] = &air_rows<V, true, true>;
    k.air_rate = &air_rate_rows<V>;
    k.added_air[0] = &added_air_flow<V>;
    k.added_air[1] = &added_air_momentum<V>;
    k.added_air[2] = &added_air_push<V>;
    k.bending[0][0] = &bending_rows<V, false, false>;
    k.bending[0][1] = &bending_rows<V, false, true>;
    k.bending[1][0] = &bending_rows<V, true, false>;
    k.bending[1][1] = &bending_rows<V, true, true>;
    k.stiffness = &stiffness_rows<V, damped, diagonals>;
    k.measure = &measure_rows<V, typename Method::Looks, damped, diagonals>;
    k.evaluate = &evaluate_rows<V, typename Method::Looks, damped, diagonals>;
    k.start = &Method::template start<damped, Real>;
    k.synchronised = &Method::template synchronised<damped, Real>;
    k.follow = &Method::template follow<damped, Real>;
    return k;
}

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
