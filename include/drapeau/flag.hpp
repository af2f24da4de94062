// Flag: a cloth, its fabric and the terms that act on it, for who embeds the core.
//
//   Flag<float, StructuralSprings, Gravity> chain(spread(1, 10, 0, 1), Attach::top, 0.01, StructuralSprings{200},
//   Gravity{}); chain.advance(SemiImplicitEuler{}, 1e-4, 1000);
//
// A term that is not in the list has no member, no branch and no loop; zero strength is not absence.
#pragma once

#include "drapeau/advance.hpp"
#include "drapeau/energy.hpp"
#include "drapeau/forces.hpp"
#include "drapeau/methods/forward_euler.hpp"
#include "drapeau/methods/semi_implicit_euler.hpp"
#include "drapeau/stability.hpp"
#include "drapeau/start.hpp"

#include <concepts>
#include <tuple>

namespace drapeau {

struct StructuralSprings {
    double k = 200.0;  // N/m; larger needs a smaller step
};
struct DiagonalSprings {
    double k = 100.0;  // N/m; half the structural k makes the sheet isotropic
};
struct SpringDamping {
    double c = 0.0;  // N s/m along every spring; larger needs a smaller step
};

template <class Real, class... Terms>
class Flag {
    template <class Term>
    static constexpr bool has = (std::same_as<Term, Terms> || ...);
    static_assert(has<StructuralSprings>, "a flag is held together by structural springs");

public:
    using Pair = SpringForce<has<SpringDamping>>;
    static constexpr bool diagonals = has<DiagonalSprings>;

    /// Flat, at rest, its top corner at the hoist at the origin. Mass in kg, of every mass alike.
    Flag(const Grid& grid, Attach attach, double mass, const Terms&... terms)
        : material_(material_of(mass, terms...)),
          rates_(Rates::of(grid, material_, term_or(AirDrag{}, terms...).d, term_or(Friction{}, terms...).c_f)),
          terms_(terms...),
          cloth_(grid),
          fabric_(grid, attach, material_),
          buffers_(cloth_.width()) {
        for (int j = 0; j < grid.rows; ++j)
            for (int i = 0; i < grid.columns; ++i) cloth_.set_position(i, j, grid.rest(i, j));
    }

    /// Takes `steps` steps of dt seconds. Nothing is allocated and nothing is thrown.
    template <class Method>
    void advance(Method, double dt, long long steps) {
        for (long long n = 0; n < steps; ++n) {
            const double t = start_ + static_cast<double>(n) * dt;
            const auto uniform =
                std::apply([&](const Terms&... terms) { return fold<Real>(material_.mass, t, terms...); }, terms_);
            advance_cloth<Vector<Real>, Pair, diagonals, Method>(cloth_.view(), fabric_.view(), uniform,
                                                                 static_cast<Real>(dt), buffers_);
        }
        start_ += static_cast<double>(steps) * dt;
    }

    double time() const { return start_; }  // s
    Cloth<Real>& cloth() { return cloth_; }
    const Cloth<Real>& cloth() const { return cloth_; }
    const Material& material() const { return material_; }
    Energy energy() const { return measure(cloth_, material_); }

    /// The largest step (s) that the closed bound allows (stability.hpp); 0 if there is none.
    template <class Method>
    double largest_stable_step(Method method) const {
        return largest_step(method, rates_);
    }

private:
    template <class Term>
    static Term term_or(const Term& otherwise, const Terms&... terms) {
        Term found = otherwise;
        const auto take = [&]<class T>(const T& term) {
            if constexpr (std::same_as<T, Term>) found = term;
        };
        (take(terms), ...);
        return found;
    }
    static Material material_of(double mass, const Terms&... terms) {
        Material material{mass, term_or(StructuralSprings{}, terms...).k, {}, {}};
        if constexpr (has<DiagonalSprings>) material.diagonal_stiffness = term_or(DiagonalSprings{}, terms...).k;
        if constexpr (has<SpringDamping>) material.damping = term_or(SpringDamping{}, terms...).c;
        return material;
    }

    Material material_;
    Rates rates_;
    std::tuple<Terms...> terms_;
    Cloth<Real> cloth_;
    Fabric<Real> fabric_;
    SweepBuffers<Real> buffers_;
    double start_ = 0.0;
};

}  // namespace drapeau
