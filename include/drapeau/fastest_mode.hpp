// Fastest mode: how near the step is to the limit of stability, here and now.
//
// The closed bound (stability.hpp) holds in every configuration; the limit of the present one is up to a third larger.
// It is found by power iteration on u -> M^-1 (K + w/dt C) u, K being the Hessian of the springs as they are and of
// bending, C that of dampers, drag and friction, w the method's weight of damping: stable while dt^2 times its largest
// eigenvalue is below 4. The mode is kept from one look to the next, so that one product a frame follows a moving flag.
//
// A part of the mode is taken off its product (the spectrum is shifted), which damps the slow end of the spectrum and
// lets the mode follow faster. What is found is a lower bound of the eigenvalue, but in cloth pressed to less than half
// its length: a step beyond the limit found is unstable here.
#pragma once

#include "drapeau/stepper.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// Whether a method's limit follows from that operator's fastest mode.
template <class M>
inline constexpr bool has_live_limit = requires {
    M::damping_weight;
};

/// The largest step (s) that is stable for this one mode: where the method begins to make it grow.
template <class M>
StableStep exact_step(const M&, const Oscillator& mode) {
    const StableStep safe = M::stable_step(mode);
    if constexpr (M::bound_is_safe_only) {
        if (!safe.is_finite()) return safe;
        constexpr double rounding = 1e-9;
        double stable = safe.seconds(), unstable = 2.0 * stable;
        for (int n = 0; n < 40; ++n) {
            const double middle = 0.5 * (stable + unstable);
            (M::growth(mode, middle) > 1.0 + rounding ? unstable : stable) = middle;
        }
        return StableStep::of_seconds(stable);
    } else {
        return safe;
    }
}

template <class Real>
class FastestMode {
public:
    /// `looks` products of the operator with the mode, for a method with these weights, near a step of dt (s). Returns
    /// the oscillator that the mode is at time `now` (s), of mass 1, braked by the air as the mass is that it brakes
    /// most; what bends counts as springs do.
    Oscillator look(Stepper<Real>& stepper, double damping_weight, double on_mass_weight, double dt, int looks,
                    double now) {
        const Grid& grid = stepper.model().grid;
        if (u_.columns() != grid.columns || u_.rows() != grid.rows) begin(grid);
        for (int n = 0; n < looks; ++n) {
            const double c_weight = damping_weight / dt, rate_weight = on_mass_weight / dt;
            const auto sums = stepper.stiffness(1.0, c_weight, rate_weight, u_, next_);
            if (!(sums.before > 0.0) || !(sums.after > 0.0)) {
                begin(grid);
                return mode_ = {1.0, 0.0, 0.0, 0.0, stepper.air_rate(now)};
            }
            const double elastic = sums.elastic / sums.before, damping = sums.damping / sums.before;
            const double on_mass = sums.on_mass / sums.before, grown = std::sqrt(sums.after / sums.before);
            const double quotient = elastic + c_weight * damping + rate_weight * on_mass;
            // Where the cloth is pressed together a mode that buckles may come first: it is damped away.
            const double shift = quotient > 0.0 ? 0.3 * grown : -0.6 * grown;
            // The product grew by more than the mode's own quotient says, and by no more than the eigenvalue (where no
            // mode that buckles is as strong: springs pressed to less than half their length have such).
            const double more = std::max(1.0, grown / quotient);
            if (elastic >= 0.0 && quotient > 0.0) mode_ = {1.0, more * elastic, more * damping, more * on_mass};
            const auto scale = static_cast<Real>(1.0 / std::sqrt(sums.after));
            const auto own = static_cast<Real>(-shift / std::sqrt(sums.after));
            for (int c = 0; c < 3; ++c)
                for (std::size_t i = 0; i < u_.component(c).size(); ++i)
                    u_.component(c)[i] = scale * next_.component(c)[i] + own * u_.component(c)[i];
        }
        mode_.air = stepper.air_rate(now);
        return mode_;
    }

private:
    /// A checkerboard, nearly the fastest mode of a flat sheet, and a little of every other.
    void begin(const Grid& grid) {
        u_ = FieldBuffer<Real>(grid.columns, grid.rows);
        next_ = FieldBuffer<Real>(grid.columns, grid.rows);
        for (int j = 0; j < grid.rows; ++j)
            for (int i = 0; i < grid.columns; ++i) {
                const auto some = [&](std::uint64_t axis) {
                    return 0.05 * random_at(1, axis, static_cast<std::int64_t>(j) * grid.columns + i);
                };
                u_.set(i, j, {(i % 2 == 0 ? 1.0 : -1.0) + some(0), (j % 2 == 0 ? 0.3 : -0.3) + some(1), 0.1 + some(2)});
            }
    }

    FieldBuffer<Real> u_, next_;
    Oscillator mode_{1.0, 0.0, 0.0, 0.0};
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
