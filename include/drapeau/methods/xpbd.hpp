// XPBD, extended position-based dynamics (Macklin et al. 2016; one iteration a small substep: Macklin et al. 2019).
//
// A step first moves the masses as if there were no springs, then corrects them spring by spring, each in the place
// where the ones before have left it: a spring longer by C than at rest, growing by D in the step, pulls with
//
//   T = [k C + (c/dt) D] / [1 + (dt^2 k + dt c) (1/m_i + 1/m_j)]        moving its ends by dt^2 T / m towards each
//   other
//
// At last v = (what the step moved)/dt. Springs limit no step; they are too soft by about the factor 1 + dt^2 k/m: only
// steps far smaller than sqrt(m/k) have the springs' own stiffness. Order 1.
//
// Springs are taken in groups that share no mass: along the fly every other one, then the others; then between rows j
// and j+1 for even j (downwards, falling, rising), then for odd j. So the result is the same for any number of threads.
#pragma once

#include "drapeau/advance.hpp"

#include <cmath>

namespace drapeau {
inline namespace DRAPEAU_ISA {

struct Xpbd : OneKick {
    static constexpr const char* name = "xpbd";
    static constexpr int order = 1;
    static constexpr const char* caution = "springs limit no step, but give way 1 + dt²k/m times as far";
    static constexpr bool solves = true;
    // Each spring pulls in the midst of a step: what strong dampers took is not known at its end.
    static constexpr bool counts_work = false;
    static constexpr int passes = 2;                           // about
    static constexpr double coarsest_step = 1.0 / 60.0 / 6.0;  // s; at fewer steps a frame springs mean nothing
    template <bool damped>
    static constexpr int fields = 4;

    /// As implicit Euler's: air and bending are taken at the step's beginning.
    static StableStep stable_step(const Oscillator& o) { return o.unsolved_step(); }
    /// Beyond, the stiffest springs are more than one and a half times too soft, and hold more energy than there is.
    static StableStep smooth_step(const Oscillator& o) { return step_where(o.stiffness, 0.0, 4.0 * o.mass); }

    /// How many times as far as its springs say the cloth gives way at steps of dt (s): 1 + dt^2 k/m.
    static double softness(double stiffness, double mass, double dt) { return 1.0 + dt * dt * stiffness / mass; }

    template <class V, bool damped, bool diagonals>
    static void step(const Pass<typename Lanes<V>::Real>& pass) {
        Solver<V, damped, diagonals>(pass).solve();
    }

private:
    template <class V, bool damped, bool diagonals>
    class Solver {
        using L = Lanes<V>;
        using Real = typename L::Real;
        // What the step moves is kept apart from the position, of which it may be less than the last digit.
        enum Kept { position, velocity, moved, velocity_before };

    public:
        explicit Solver(const Pass<Real>& pass) : pass_(pass), dt_(pass.dt) {}

        void solve() const {
            for (int j = pass_.first; j < pass_.last; ++j) {
                predict(j);
                along_the_row(j, 0);
                along_the_row(j, 1);
            }
            for (int parity = 0; parity < 2; ++parity) {
                meet();
                for (int j = pass_.first + (pass_.first + parity) % 2; j < pass_.last && j + 1 < pass_.rows; j += 2)
                    to_the_row_below(j);
            }
            meet();
            for (int j = pass_.first; j < pass_.last; ++j) {
                const Fields here(pass_, j);
                for (int i = 0; i < pass_.width; i += L::width) {
                    const auto d = here.at(moved, i);
                    if (pass_.accounted) here.field[velocity_before].set(i, here.at(velocity, i));
                    here.field[position].set(i, here.at(position, i) + d);
                    here.field[velocity].set(i, (Real(1) / dt_) * d);
                }
            }
            if (!pass_.accounted) return;
            meet();
            for_rows_accounted<V, damped, diagonals, fields<damped>, position, velocity>(
                pass_, 1.0,
                [&](const Masses<V>& mass, const RowConstants<Real>& constants, const Vec3<V>& a)
                    DRAPEAU_INLINE_LAMBDA {
                        const auto before = mass.get(velocity_before);
                        const auto after = mass.get(velocity);
                        return Motion<V>{resisted(a, L::load(constants.rate + mass.i), after),
                                         Real(0.5) * (before + after)};
                    });
        }

    private:
        /// A row of masses, anybody's.
        struct Fields {
            Field<Real> field[fields<damped>];
            Field<const Real> air;  // the direction of air that moves along; null where none does

            Fields(const Pass<Real>& pass, int j) : air(pass.added.direction) {
                if (air.x) air = air.row(j);
                for (int f = 0; f < fields<damped>; ++f) field[f] = pass.fields[f].row(j);
            }
            Vec3<V> at(int f, int i) const { return field[f].template at<V>(i); }
            /// Moves masses of 1/w by w f: less along a normal that air moves along with.
            void move(int i, V w, const Vec3<V>& f) const {
                auto to = at(moved, i) + w * f;
                if (air.x) to = to - (w * dot(air.template at<V>(i), f)) * air.template at<V>(i);
                field[moved].set(i, to);
            }
            /// 1/m along d, whose length is 1/r.
            V lightness_along(const Vec3<V>& d, V r, int i, V w) const {
                if (!air.x) return w;
                const V s = r * dot(air.template at<V>(i), d);
                return w * (Real(1) - s * s);
            }
        };

        void meet() const { pass_.meet(pass_.team); }

        /// 1/m as the step sees it. Drag and friction are taken at the step's end, m (v' - v) = dt (f - m rate v'):
        /// that is a mass heavier by 1 + dt rate.
        V lightness(const RowConstants<Real>& constants, int i) const {
            return L::load(constants.inverse_mass + i) / (Real(1) + dt_ * L::load(constants.rate + i));
        }
        /// The velocity at the step's end if there were no springs.
        Vec3<V> without_springs(const Vec3<V>& v, V rate, const Vec3<V>& pushed) const {
            return (Real(1) / (Real(1) + dt_ * rate)) * (v + dt_ * pushed);
        }
        void predict(int j) const {
            if (pass_.accelerate) pass_.accelerate(pass_.terms, j, pass_.time);
            const Fields here(pass_, j);
            const RowConstants<Real>& constants = pass_.constants[j];
            const PassRow<Real, fields<damped>> row(pass_, j);
            for (int i = 0; i < pass_.width; i += L::width) {
                const auto a = acceleration_of<velocity>(Vec3<V>{}, row, constants, i);
                here.field[moved].set(i, dt_ * without_springs(here.at(velocity, i), L::load(constants.rate + i), a));
            }
        }

        /// dt^2 T e of the spring from mass i of `here` to mass n of `there`.
        Vec3<V> pull(const SpringRow<Real>& spring, int i, const Fields& here, int a, V w_a, const Fields& there, int b,
                     V w_b) const {
            const auto grown = there.at(moved, b) - here.at(moved, a);
            const auto d = (there.at(position, b) - here.at(position, a)) + grown;
            const V r = inverse_length(d);
            const V k = (dt_ * dt_) * L::load(spring.k + i);
            V tension = k - r * ((dt_ * dt_) * L::load(spring.k_length + i)), resists = k;  // tension over l
            if constexpr (damped) {
                const V c = dt_ * L::load(spring.c + i);
                tension = tension + (r * r) * (c * dot(grown, d));
                resists = resists + c;
            }
            const V lightness = here.lightness_along(d, r, a, w_a) + there.lightness_along(d, r, b, w_b);
            return (tension / (Real(1) + resists * lightness)) * d;
        }

        /// The springs from even columns (parity 0) or odd ones to the right.
        void along_the_row(int j, int parity) const {
            const Fields here(pass_, j);
            const RowConstants<Real>& constants = pass_.constants[j];
            Vec3<V> before{};
            for (int i = 0; i < pass_.width; i += L::width) {
                const V w = lightness(constants, i), w_right = lightness(constants, i + 1);
                const auto f = every_other((i + parity) % 2) * pull(constants.fly, i, here, i, w, here, i + 1, w_right);
                here.move(i, w, f - shifted(before, f));
                before = f;
            }
        }
        /// 1, 0, 1, 0... or 0, 1, 0, 1...
        static V every_other(int first) {
            if constexpr (L::width == 1) {
                return first == 0 ? V(1) : V(0);
            } else {
                V lanes{};
                for (int n = first; n < L::width; n += 2) lanes[n] = Real(1);
                return lanes;
            }
        }

        /// The springs between row j and the one below.
        void to_the_row_below(int j) const {
            const Fields here(pass_, j), below(pass_, j + 1);
            const RowConstants<Real>& constants = pass_.constants[j];
            const RowConstants<Real>& constants_below = pass_.constants[j + 1];
            const auto group = [&](const SpringRow<Real>& springs, int a_shift, int b_shift) {
                for (int i = 0; i < pass_.width; i += L::width) {
                    const int a = i + a_shift, b = i + b_shift;
                    const V w_a = lightness(constants, a), w_b = lightness(constants_below, b);
                    const auto f = pull(springs, i, here, a, w_a, below, b, w_b);
                    here.move(a, w_a, f);
                    below.move(b, w_b, Vec3<V>{} - f);
                }
            };
            group(constants.hoist, 0, 0);
            if constexpr (diagonals) {
                group(constants.diagonal, 0, 1);
                group(constants.diagonal, 1, 0);
            }
        }

        const Pass<Real>& pass_;
        const Real dt_;
    };
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
