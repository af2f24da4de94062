// Implicit Euler: v(t+dt) = v(t) + dt a(x(t+dt), v(t+dt), t+dt), x(t+dt) = x(t) + dt v(t+dt).
//
// Order 1. Springs limit no step where they are linear, at the price of damping that nobody asked for: every mode
// is damped as by springs with c + k dt, a mode of angular frequency w at the ratio w dt/2. Angular momentum is not
// kept.
//
// Newton's method on the velocity u at the step's end. With the forces f of everything,
//
//   r(u) = m (v - u) + dt f(x + dt u, u) = 0      J = m (1 + dt rate) + dt C + dt^2 K      u += J^-1 r
//
// J is never stored: conjugate gradients ask for its products with a direction, which one sweep makes (hessian.hpp),
// preconditioned by the inverses of its 3 x 3 blocks. The true Hessian converges fastest; where it is not positive (the
// cloth buckles) the one made positive takes its place.
#pragma once

#include "drapeau/advance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drapeau {
inline namespace DRAPEAU_ISA {

struct ImplicitEuler : OneKick {
    static constexpr const char* name = "implicit-euler";
    static constexpr int order = 1;
    static constexpr const char* caution =
        "springs limit no step, but it damps by itself: at 1/60 s a swing of 1 Hz keeps 72 % of its size each period";
    static constexpr bool solves = true;
    static constexpr int passes = 30;  // about
    static constexpr double stage_time[] = {1.0};
    template <bool damped>
    static constexpr int fields = 10;

    /// Only air and bending are taken at the step's beginning: beyond, they throw masses to and fro.
    static StableStep stable_step(const Oscillator& o) { return o.unsolved_step(); }

    /// What is left of a swing's amplitude after one period, of a mode of `hertz` that nothing damps, at steps of dt
    /// (s).
    static double amplitude_kept(double hertz, double dt) {
        const double y = 2.0 * M_PI * hertz * dt;
        return std::pow(1.0 + y * y, -M_PI / y);
    }

    template <class V, bool damped, bool diagonals>
    static void step(const Pass<typename Lanes<V>::Real>& pass) {
        Solver<V, damped, diagonals>(pass).solve();
    }

private:
    // Newton ends when a correction is this share of what the step changes; what is left after it is far less. Where
    // the cloth buckles it only creeps: then the larger share will do, far below the method's own error at such steps.
    static constexpr double smallest_correction = 1e-3, creeping_correction = 3e-2;
    static constexpr int most_corrections = 60, most_halvings = 8;
    // Each linear solve makes its residual so much smaller.
    static constexpr double linear_share = 0.03;
    static constexpr int most_iterations = 600;
    /// Of a step in all: on grids of more than half a million masses nobody waits for as many as on others.
    static constexpr long long most_in_all(long long masses) {
        constexpr long long usual = 5000, least = 1500, most_work = 2'500'000'000;
        return std::clamp(most_work / masses, least, usual);
    }

    template <class V, bool damped, bool diagonals>
    class Solver {
        using L = Lanes<V>;
        using Real = typename L::Real;
        // Fields: the velocity u and position at the step's end as far as they are known, and what solving keeps.
        enum Kept {
            position,
            velocity,
            end_velocity,
            end_position,
            residual,
            direction,
            correction,
            product,
            block,
            off_block
        };
        static constexpr int count = ImplicitEuler::fields<damped>;
        using Row = PassRow<Real, count>;

    public:
        explicit Solver(const Pass<Real>& pass) : pass_(pass), dt_(pass.dt) {}

        void solve() {
            each([&](const Masses<V>& mass, const auto&) {
                const auto v = mass.get(velocity);
                mass.set(end_velocity, v);
                mass.set(end_position, mass.get(position) + dt_ * v);
            });
            const long long most = most_in_all(static_cast<long long>(pass_.rows) * pass_.width);
            bool positive = false, solved = false, creeps = false;
            int corrections = 0;
            double last = INFINITY;
            double left = carried_along();
            reach_ = std::sqrt(sum([&](const Masses<V>& mass, const RowConstants<Real>& constants) {
                                   const auto x = mass.get(position);
                                   return L::load(constants.mass + mass.i) * dot(x, x);
                               }) /
                               mass_);
            while (corrections < most_corrections && iterations_ < most && !solved && !creeps) {
                ++corrections;
                if (!positive && !correct(false)) {
                    positive = true;  // for the rest of the step
                    find_residual();
                }
                if (positive) correct(true);
                const double size = correction_size();
                double share = 1.0, now = 0.0;
                move(share);
                for (int n = 0; (now = find_residual()) > left && n < most_halvings; ++n) move(-(share *= 0.5));
                solved = share * size <= smallest_correction * change_ || size <= rounding();
                creeps = size <= creeping_correction * change_ && size > 0.5 * last;
                last = size;
                left = now;
            }
            if (pass_.all_free && corrections > 0) left = carried_along();
            if (pass_.solves) pass_.solves->add({1, corrections, iterations_, solved || creeps ? 0 : 1, left});
            if (pass_.accounted) {
                for_rows_accounted<V, damped, diagonals, count, end_position, end_velocity>(
                    pass_, 1.0,
                    [&](const Masses<V>& mass, const auto& constants, const Vec3<V>& a) DRAPEAU_INLINE_LAMBDA {
                        const auto u = mass.get(end_velocity);
                        return Motion<V>{resisted(a, L::load(constants.rate + mass.i), u),
                                         Real(0.5) * (mass.get(velocity) + u)};
                    });
                meet();
            }
            each([&](const Masses<V>& mass, const auto&) {
                mass.set(velocity, mass.get(end_velocity));
                mass.set(position, mass.get(end_position));
            });
        }

    private:
        void meet() const { pass_.meet(pass_.team); }

        /// Calls visit(masses, constants) for each register of this member's rows.
        template <class Visit>
        void each(Visit&& visit) const {
            for (int j = pass_.first; j < pass_.last; ++j) {
                const Row row(pass_, j);
                for (int i = 0; i < pass_.width; i += L::width) visit(Masses<V>{row.field, i}, pass_.constants[j]);
            }
        }

        /// Sweeps the springs of this member's rows. visit(masses, row, constants, value, sums) gets what the springs
        /// come to at each register of a row and adds to three sums; what it writes it does not read (a halo's rows go
        /// before a member's first and are overwritten).
        template <class Operation, int seen_position, int seen_direction, class Visit>
        void sweep(const Operation& fresh, Visit&& visit) {
            Row own(pass_, pass_.first);
            V sums[3]{};
            for_rows<V, Operation, diagonals, count, seen_position, seen_direction>(
                pass_,
                [&](const auto&, const RowConstants<Real>& constants, int i, const typename Operation::Value& value)
                    DRAPEAU_INLINE_LAMBDA {
                        visit(Masses<V>{own.field, i}, own, constants, value, sums);
                    },
                [&](int j, const auto&) DRAPEAU_INLINE_LAMBDA {
                    if (j >= pass_.first)
                        for (int n = 0; n < 3; ++n) pass_.sums[j].products[bank_][n] = sum_of(sums[n]);
                    if (j >= pass_.first && j + 1 < pass_.last) own = Row(pass_, j + 1);
                    for (V& sum : sums) sum = V{};
                },
                fresh);
        }
        /// Over all rows of all members, in the order of rows: the same for any number of members. (A member is at most
        /// one sum ahead of another, so two banks are enough.)
        void find_totals() {
            meet();
            for (double& total : totals_) total = 0.0;
            for (int j = 0; j < pass_.rows; ++j)
                for (int n = 0; n < 3; ++n) totals_[n] += pass_.sums[j].products[bank_][n];
            bank_ = 1 - bank_;  // what is written next is not what others may still be reading
        }
        /// The sum over all masses of visit(masses, constants).
        template <class Visit>
        double sum(Visit&& visit) {
            for (int j = pass_.first; j < pass_.last; ++j) {
                const Row row(pass_, j);
                V sum{};
                for (int i = 0; i < pass_.width; i += L::width)
                    sum = sum + visit(Masses<V>{row.field, i}, pass_.constants[j]);
                pass_.sums[j].products[bank_][0] = sum_of(sum);
            }
            find_totals();
            return totals_[0];
        }

        /// r at the position and velocity known of the step's end. Returns its size as a velocity (m/s, rms).
        double find_residual() {
            meet();
            sweep<SpringForce<V, damped>, end_position, end_velocity>(
                {}, [&](const Masses<V>& mass, const Row& row, const RowConstants<Real>& constants,
                        const Vec3<V>& force, V* sums) DRAPEAU_INLINE_LAMBDA {
                    const V m = L::load(constants.mass + mass.i);
                    const auto v = mass.get(velocity), u = mass.get(end_velocity);
                    const auto a =
                        resisted(acceleration_of<end_velocity>(force, row, constants, static_cast<int>(mass.i)),
                                 L::load(constants.rate + mass.i), u);
                    const auto lacking = v - u + dt_ * a;
                    auto inert = m * lacking;
                    if (row.added_direction.x) inert = inert + of_air(row, mass.i, inert);
                    mass.set(residual, inert);
                    sums[0] = sums[0] + m * dot(lacking, lacking);
                    sums[1] = sums[1] + m * dot(u - v, u - v);
                    sums[2] = sums[2] + m;
                });
            find_totals();
            mass_ = totals_[2] > 0.0 ? totals_[2] : 1.0;
            change_ = std::sqrt(totals_[1] / mass_);
            return std::sqrt(totals_[0] / mass_);
        }

        /// The residual once more, after what it is in all has been given to all masses alike, if none is held: no
        /// spring feels that, and it keeps the momentum, which conjugate gradients that end early would not. (Air that
        /// moves along takes momentum anyway.)
        double carried_along() {
            const double left = find_residual();
            if (!pass_.all_free || pass_.added.is_felt()) return left;
            Vec3<double> all{};
            const auto total = [&](auto&& component) {
                return sum(
                    [&](const Masses<V>& mass, const RowConstants<Real>&) { return component(mass.get(residual)); });
            };
            all.x = total([](const Vec3<V>& r) { return r.x; });
            all.y = total([](const Vec3<V>& r) { return r.y; });
            all.z = total([](const Vec3<V>& r) { return r.z; });
            const double heavy = sum([&](const Masses<V>& mass, const RowConstants<Real>& constants) {
                return free_only(constants, mass.i, inertia(constants, mass.i));
            });
            if (!(heavy > 0.0)) return left;
            const auto share = [&](double sum_of_component) {
                return L::broadcast(static_cast<Real>(sum_of_component / heavy));
            };
            const Vec3<V> carried{share(all.x), share(all.y), share(all.z)};
            each([&](const Masses<V>& mass, const RowConstants<Real>& constants) {
                mass.set(correction, free(L::load(constants.inverse_mass + mass.i), carried));
            });
            move(1.0);
            return find_residual();
        }

        /// Solves J correction = residual, which is used up. False if J is not positive, which only a true one may be.
        bool correct(bool positive) {
            const Weighted<V, damped> weights{dt_, positive};
            sweep<SpringBlock<V, damped>, end_position, end_velocity>(
                {{}, weights}, [&](const Masses<V>& mass, const Row& row, const RowConstants<Real>& constants,
                                   Symmetric<V> all, V*) DRAPEAU_INLINE_LAMBDA {
                    const V w = L::load(constants.inverse_mass + mass.i);
                    const V own = inertia(constants, mass.i);
                    all.diagonal = all.diagonal + Vec3<V>{own, own, own};
                    if (row.added_direction.x) {
                        const V m = L::load(constants.mass + mass.i);
                        const auto g = added_inertia<V>(row.added_direction, mass.i);
                        all = all + Symmetric<V>{m * Vec3<V>{g.x * g.x, g.y * g.y, g.z * g.z},
                                                 m * Vec3<V>{g.y * g.z, g.z * g.x, g.x * g.y}};
                    }
                    const auto inverse = all.inverse();
                    mass.set(block, free(w, inverse.diagonal));
                    mass.set(off_block, free(w, inverse.off));
                });
            double size = sum([&](const Masses<V>& mass, const auto&) {
                const auto r = mass.get(residual), z = preconditioned(mass, r);
                mass.set(direction, z);
                mass.set(correction, Vec3<V>{});
                return dot(r, z);
            });
            const double enough = linear_share * linear_share * size;
            for (int n = 0; n < most_iterations && size > enough; ++n) {
                ++iterations_;
                sweep<SpringHessian<V, damped>, end_position, direction>(
                    {{}, weights}, [&](const Masses<V>& mass, const Row& row, const RowConstants<Real>& constants,
                                       const Vec3<V>& pull, V* sums) DRAPEAU_INLINE_LAMBDA {
                        const auto p = mass.get(direction);
                        const V m = L::load(constants.mass + mass.i);
                        auto q = inertia(constants, mass.i) * p - pull;
                        if (row.added_direction.x) q = q + of_air(row, mass.i, m * p);
                        q = free(L::load(constants.inverse_mass + mass.i), q);
                        mass.set(product, q);
                        sums[0] = sums[0] + dot(p, q);
                    });
                find_totals();
                if (!(totals_[0] > 0.0)) return false;
                const Real along = static_cast<Real>(size / totals_[0]);
                const double before = size;
                size = sum([&](const Masses<V>& mass, const auto&) {
                    mass.set(correction, mass.get(correction) + along * mass.get(direction));
                    const auto r = mass.get(residual) - along * mass.get(product);
                    mass.set(residual, r);
                    return dot(r, preconditioned(mass, r));
                });
                const Real turn = static_cast<Real>(size / before);
                each([&](const Masses<V>& mass, const auto&) {
                    mass.set(direction, preconditioned(mass, mass.get(residual)) + turn * mass.get(direction));
                });
                meet();
            }
            return true;
        }

        double correction_size() {  // m/s, rms
            const double squares = sum([&](const Masses<V>& mass, const RowConstants<Real>& constants) {
                const auto c = mass.get(correction);
                return L::load(constants.mass + mass.i) * dot(c, c);
            });
            return std::sqrt(squares / mass_);
        }
        /// The finest velocity that positions of this precision resolve (m/s).
        double rounding() const { return std::numeric_limits<Real>::epsilon() * reach_ / static_cast<double>(dt_); }

        /// u += share of the correction.
        void move(double share) {
            const Real s = static_cast<Real>(share);
            each([&](const Masses<V>& mass, const auto&) {
                const auto u = mass.get(end_velocity) + s * mass.get(correction);
                mass.set(end_velocity, u);
                mass.set(end_position, mass.get(position) + dt_ * u);
            });
        }

        /// What air that moves along adds to the inertia `m` times something.
        static Vec3<V> of_air(const Row& row, std::ptrdiff_t i, const Vec3<V>& inert) {
            const auto g = added_inertia<V>(row.added_direction, i);
            return dot(g, inert) * g;
        }
        V inertia(const RowConstants<Real>& constants, std::ptrdiff_t i) const {
            return L::load(constants.mass + i) * (Real(1) + dt_ * L::load(constants.rate + i));
        }
        static V free_only(const RowConstants<Real>& constants, std::ptrdiff_t i, V value) {
            return L::where_positive(L::load(constants.inverse_mass + i), value);
        }
        static Vec3<V> free(V inverse_mass, const Vec3<V>& a) {
            return {L::where_positive(inverse_mass, a.x), L::where_positive(inverse_mass, a.y),
                    L::where_positive(inverse_mass, a.z)};
        }
        static Vec3<V> preconditioned(const Masses<V>& mass, const Vec3<V>& r) {
            return Symmetric<V>{mass.get(block), mass.get(off_block)}.times(r);
        }

        const Pass<Real>& pass_;
        const Real dt_;
        int bank_ = 0;
        double totals_[3]{};
        double mass_ = 1.0;    // kg, of all that move
        double change_ = 0.0;  // m/s, rms, of the velocity in the step as far as it is known
        double reach_ = 0.0;   // m, rms distance from the origin
        long long iterations_ = 0;
    };
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
