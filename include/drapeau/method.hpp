// Method: what methods of integration are made of. A method is one file in methods/, a type with these members:
//
//   name, order, coarsest_step   its name in files, its order, the largest step (s) that anyone would want
//   caution                      what it does to the motion by nature, in a few words; of methods that do
//   creates_energy, dissipates_energy   by nature, where nothing damps
//   counts_work                  whether at a step's end it is known what work every force did in it
//   automatic                    the share of the usual automatic step that suits it (1)
//   solves                       whether it takes whole steps of its own (step), or is moved by the sweep (move)
//   passes, stage_time, weight   force evaluations a step; of each, when in the step and its share in quadratures
//   fields<damped>               position (0), velocity (1) and what the method keeps (2...)
//   seen_position<damped>, seen_velocity<damped>   the fields that forces are evaluated at
//   staggered                    the velocity stored is half a step behind the position
//   Looks                        the method whose measure and evaluate do for this one too
//   total(a, rate, v, dt)        the acceleration with drag and friction, from the one without
//   move<pass, damped>(masses, a, rate, dt)   moves a register of masses; returns their Motion
//   step<V, damped, diagonals>(pass)   a whole step of a member's rows, at pass.time
//   starts_with_forces           whether the next two need the acceleration (they and follow are for one mass)
//   start<damped>                at every start, position and velocity being of the same time: sets what is kept
//   synchronised<damped>         the velocity at the position's time; asked only with starts_with_forces
//   follow<damped>               moves a mass by dx and its velocity by dv, and what is kept of both
//   smooth_step(oscillator)      if it has one: up to here an automatic step is smooth, though larger ones are stable
//   stable_step(oscillator)      the largest stable step, see stability.hpp
//   bound_is_safe_only           whether a single mode may be stable at larger steps than that
//   growth(oscillator, dt)       what a mode's amplitude is multiplied with in a step; with damping_weight and
//   damping_weight, on_mass_weight   on_mass_weight of the operator whose largest eigenvalue limits the step: of
//                                methods that have such a limit (fastest_mode.hpp)
//
// The acceleration `a` that a method is given has everything but drag and friction in it; `rate` (1/s) is theirs.
#pragma once

#include "drapeau/field.hpp"
#include "drapeau/isa.hpp"

#include <cmath>

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// A register of masses, or one, in reach of a method: element i of each of its fields.
template <class V>
struct Masses {
    using Real = typename Lanes<V>::Real;
    const Field<Real>* fields;
    std::ptrdiff_t i;

    DRAPEAU_INLINE Vec3<V> get(int field) const { return fields[field].template at<V>(i); }
    DRAPEAU_INLINE void set(int field, const Vec3<V>& value) const { fields[field].set(i, value); }
};

/// What a move reports of a mass: the acceleration it had, and the velocity that the work of its forces is counted with
/// (chosen so that the work of all forces is what the kinetic energy gains).
template <class V>
struct Motion {
    Vec3<V> acceleration, velocity;
};

/// The rate where neither drag nor friction is listed: nothing is loaded and nothing computed.
struct NoRate {};

/// a - rate v.
template <class V, class Rate>
DRAPEAU_INLINE Vec3<V> resisted(const Vec3<V>& a, const Rate& rate, const Vec3<V>& v) {
    if constexpr (std::is_same_v<Rate, NoRate>)
        return a;
    else
        return a - rate * v;
}

/// The largest stable step of a method: none, so many seconds, or unlimited.
class StableStep {
public:
    constexpr StableStep() = default;  // none
    static constexpr StableStep none() { return StableStep(0.0); }
    static constexpr StableStep unlimited() { return StableStep(INFINITY); }
    static constexpr StableStep of_seconds(double seconds) {
        return seconds > 0.0 ? StableStep(seconds) : StableStep(0.0);
    }

    constexpr bool is_none() const { return seconds_ == 0.0; }
    constexpr bool is_unlimited() const { return seconds_ == INFINITY; }
    constexpr bool is_finite() const { return !is_none() && !is_unlimited(); }
    constexpr double seconds() const { return seconds_; }  // 0 for none, infinite for unlimited
    constexpr bool allows(double dt) const { return dt <= seconds_; }

    friend constexpr StableStep smaller(StableStep a, StableStep b) { return a.seconds_ < b.seconds_ ? a : b; }
    bool operator==(const StableStep&) const = default;

private:
    explicit constexpr StableStep(double seconds) : seconds_(seconds) {}
    double seconds_ = 0.0;
};

/// m x'' = -k x - (c + on_mass) x': one mode that bounds those of a whole model (stability.hpp).
struct Oscillator {
    double mass;             // kg
    double stiffness = 0.0;  // N/m
    double damping = 0.0;    // N s/m, of springs
    double on_mass = 0.0;    // N s/m, drag and friction
    double air = 0.0;  // N s/m, of the air on faces at most: it may be still, and brakes by velocities as springs do
    double bending = 0.0, bending_damping = 0.0;  // N/m and N s/m: like springs', but no method solves for them

    double restoring() const { return stiffness + bending; }            // N/m
    double braking() const { return damping + air + bending_damping; }  // N s/m, all but on_mass
    /// The largest step that stands what is taken at the step's beginning by methods that solve for springs.
    StableStep unsolved_step() const;
};

/// The positive root of stiffness dt^2 + damping dt = 4 mass, without cancellation.
inline StableStep step_where(double stiffness, double damping, double four_masses) {
    if (stiffness == 0.0 && damping == 0.0) return StableStep::unlimited();
    return StableStep::of_seconds(2.0 * four_masses /
                                  (damping + std::sqrt(damping * damping + 4.0 * stiffness * four_masses)));
}

/// The limit of z^2 - (2 - a - b) z + 1 - b. Springs that pull, solved for, put 1 + a_s before z^2 and only enlarge it;
/// in compressed ones a_s < 0 lets modes grow slowly below it (docs/model.md, "Bending").
inline StableStep Oscillator::unsolved_step() const {
    return step_where(bending, 2.0 * (air + bending_damping), 4.0 * mass);
}

/// The larger size of the roots of z^2 - sum z + product.
inline double larger_root(double sum, double product) {
    const double d = 0.25 * sum * sum - product;
    return d < 0.0 ? std::sqrt(product) : std::fabs(0.5 * sum) + std::sqrt(d);
}

/// Whether a method stores a velocity for forces to see only in its composition with damped springs: then that is the
/// one for every force that depends on velocities.
template <class M>
inline constexpr bool predicts_velocity = M::template seen_velocity<true> != M::template seen_velocity<false>;

/// What most methods do for one mass: nothing to start, a velocity that is synchronised as it is stored.
struct OneKick {
    static constexpr int passes = 1;
    static constexpr double stage_time[] = {0.0};
    static constexpr double weight[] = {1.0};
    static constexpr double coarsest_step = 1.0 / 60.0;  // s
    static constexpr bool bound_is_safe_only = false;
    static constexpr double automatic = 1.0;
    static constexpr bool starts_with_forces = false;
    static constexpr bool creates_energy = false, dissipates_energy = false, counts_work = true;
    static constexpr bool solves = false, staggered = false;
    using Looks = OneKick;
    template <bool damped>
    static constexpr int fields = 2;
    template <bool damped>
    static constexpr int seen_position = 0;
    template <bool damped>
    static constexpr int seen_velocity = 1;

    template <class V, class Rate, class Real>
    DRAPEAU_INLINE static Vec3<V> total(const Vec3<V>& a, const Rate& rate, const Vec3<V>& v, Real) {
        return resisted(a, rate, v);
    }
    template <bool damped, class Real>
    static void start(const Field<Real>*, std::ptrdiff_t, const Vec3<Real>&, Real, Real) {}
    template <bool damped, class Real>
    static Vec3<Real> synchronised(const Field<Real>* fields, std::ptrdiff_t n, const Vec3<Real>&, Real, Real) {
        return fields[1].template at<Real>(n);
    }
    template <bool damped, class Real>
    static void follow(const Field<Real>* fields, std::ptrdiff_t n, const Vec3<Real>& dx, const Vec3<Real>& dv) {
        const Masses<Real> mass{fields, n};
        mass.set(0, mass.get(0) + dx);
        mass.set(1, mass.get(1) + dv);
    }
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
