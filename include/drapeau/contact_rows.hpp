// Contact rows: a contact (limits/contact.hpp) over the rows of a block, after a step. A register is looked at as a
// whole; hardly any has a mass inside.
#pragma once

#include "drapeau/field.hpp"
#include "drapeau/limits/contact.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// Moves masses of the rows of `pass` that went inside in the step of dt (s), by `follow`; `before`: where they were
/// (m).
template <class Real, class C, class Follow>
void touch_rows(const C& contact, const Grid& grid, double dt, const Pass<Real>& pass, const Field<const Real>& before,
                const Follow& follow) {
    using V = Vector<Real, 16>;
    const auto inside = contact.template inside<Real>(grid);
    const auto place = [](const Field<const Real>& field, std::ptrdiff_t n) {
        return Vec3<double>{static_cast<double>(field.x[n]), static_cast<double>(field.y[n]),
                            static_cast<double>(field.z[n])};
    };
    const auto rounded = [](const Vec3<double>& a) {
        return Vec3<Real>{static_cast<Real>(a.x), static_cast<Real>(a.y), static_cast<Real>(a.z)};
    };
    const auto touch = [&](std::ptrdiff_t n) {
        const auto x = place(pass.fields[0], n), v = place(pass.fields[1], n), from = place(before, n);
        auto x_next = x, v_next = v;
        Surface surface = contact.surface(grid, x);
        surface.leave(contact.surface(grid, from).depth, dt);
        resist(surface, contact.friction, from, x_next, v_next);
        follow(pass.fields, n, rounded(x_next - x), rounded(v_next - v));
    };
    for (int j = pass.first; j < pass.last; ++j) {
        const Real* const free = pass.constants[j].inverse_mass;
        for (int i = 0; i < pass.width; i += Lanes<V>::width) {
            const std::ptrdiff_t n = j * pass.fields[0].stride + i;
            const V depth =
                Lanes<V>::where_positive(Lanes<V>::load(free + i), inside(pass.fields[0].template at<V>(n)));
            if (!(max_of(depth) > 0.0)) continue;
            for (int m = 0; m < Lanes<V>::width; ++m)
                if (lane(depth, m) > 0.0) touch(n + m);
        }
    }
}

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
