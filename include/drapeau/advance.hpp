// Advance: the sweep with a method as its `finish`: each row is moved in place as soon as its force is complete.
#pragma once

#include "drapeau/model.hpp"
#include "drapeau/sweep.hpp"

namespace drapeau {

/// Moves one row: a = force / m + uniform, then the method. Attached masses and padding (inverse mass 0) stay.
template <class V, class Pair, bool diagonals, class Method, class UniformForces>
DRAPEAU_INLINE void advance_row(Sweep<V, Pair, diagonals>& sweep, const Row<typename Lanes<V>::Real>& here,
                                const Row<typename Lanes<V>::Real>* next, const typename Lanes<V>::Real* inverse_mass,
                                const UniformForces& uniform, typename Lanes<V>::Real dt, Method) {
    using L = Lanes<V>;
    sweep.row(here, next, [&](int i, const Triple<V>& force) DRAPEAU_INLINE_LAMBDA {
        const V w = L::load(inverse_mass + i);
        auto x = here.template position<V>(i), v = here.template velocity<V>(i);
        auto a = uniform.add_to(w * force, v);
        a = {L::where_positive(w, a.x), L::where_positive(w, a.y), L::where_positive(w, a.z)};
        Method::move(x, v, a, dt);
        here.set_position(i, x);
        here.set_velocity(i, v);
    });
}

/// Advances the rows first <= j < last by one step. `above` and `below` are copies of the neighbouring rows as they
/// were before the step (null at the cloth's border); `above` goes through the sweep too, for what it leaves to row
/// `first`, in the same loop and so by the same instructions as where another thread moves it, and is spent afterwards.
template <class V, class Pair, bool diagonals, class Method, class UniformForces, class Real>
void advance_rows(const Rows<Real>& rows, int first, int last, const Row<Real>* above, const Row<Real>* below,
                  const FabricView<Real>& fabric, const UniformForces& uniform, Real dt, SweepBuffers<Real>& buffers) {
    Sweep<V, Pair, diagonals> sweep(fabric.springs, buffers);
    sweep.begin();
    for (int j = above ? first - 1 : first; j < last; ++j) {
        const Row<Real> here = j < first ? *above : rows[j], inner = rows[j + 1];
        advance_row(sweep, here, j + 1 < last ? &inner : below, fabric.inverse_mass_of(j), uniform, dt, Method{});
    }
}

/// Advances a whole cloth by one step.
template <class V, class Pair, bool diagonals, class Method, class UniformForces, class Real>
void advance_cloth(const Rows<Real>& rows, const FabricView<Real>& fabric, const UniformForces& uniform, Real dt,
                   SweepBuffers<Real>& buffers) {
    const Row<Real>* const none = nullptr;
    advance_rows<V, Pair, diagonals, Method>(rows, 0, rows.rows, none, none, fabric, uniform, dt, buffers);
}

/// Stores the springs' force on every mass (N) instead of moving it; `forces` has the shape of one component each.
template <class V, class Pair, bool diagonals, class Real>
void spring_forces(const Rows<Real>& rows, const FabricView<Real>& fabric, const ForceRow<Real>& forces,
                   SweepBuffers<Real>& buffers) {
    Sweep<V, Pair, diagonals> sweep(fabric.springs, buffers);
    sweep.begin();
    for (int j = 0; j < rows.rows; ++j) {
        const Row<Real> next = rows[j + 1];
        const std::ptrdiff_t start = j * rows.stride;
        sweep.row(rows[j], j + 1 < rows.rows ? &next : nullptr,
                  [&](int i, const Triple<V>& force) DRAPEAU_INLINE_LAMBDA { forces.set(start + i, force); });
    }
}

}  // namespace drapeau
