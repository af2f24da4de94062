// Contact: surfaces that masses do not pass: what the ground and the pole have in common. A contact is a pass after the
// move and after every limit, over each mass by itself: a plain aggregate of its parameters with these members:
//
//   name, table, is_contact
//   friction                    mu, of the cloth on it
//   inside<Real>(grid)          a function of a register of places, greater than 0 where one is inside
//   surface(grid, x)            where it is touched by a mass at x (m) that is inside
//
// A mass that went inside is set on the surface, one that was there before (a flag that begins around the pole, ground
// that is raised) comes out at 0.5 m/s; what its velocity had towards it is lost (an impulse p, without
// bounce), and friction takes up to mu p from what it has along it (Coulomb), and the same share from the way that the
// step went along it. Where that is all of it the mass stays where it was, to the bit: what lies still does not creep.
// Forces are never negative, so nothing sticks to a surface that is pulled away, and no stiffness is added, so no step
// becomes too large.
#pragma once

#include "drapeau/state.hpp"

#include <cmath>

namespace drapeau {
inline namespace DRAPEAU_ISA {

template <class T>
concept Contact = requires {
    T::is_contact;
};

/// Where a mass touches.
struct Surface {
    Vec3<double> normal;  // outwards, of length 1
    double depth;         // m, how far inside the mass is

    /// Less what is left to the steps to come of a mass that was `inside` by so much before the step of dt (s).
    void leave(double inside, double dt) {
        constexpr double comes_out = 0.5;  // m/s
        depth -= std::fmax(0.0, inside - comes_out * dt);
    }
};

/// What a contact makes of the position (m) and velocity (m/s) that a step gave a mass, which was at `before`.
inline void resist(const Surface& surface, double friction, const Vec3<double>& before, Vec3<double>& x,
                   Vec3<double>& v) {
    if (!(surface.depth > 0.0)) return;
    x = x + surface.depth * surface.normal;
    const double inwards = -dot(v, surface.normal);
    if (!(inwards > 0.0)) return;
    v = v + inwards * surface.normal;
    const double slip = std::sqrt(dot(v, v)), braked = friction * inwards;
    if (braked == 0.0) return;
    const double left = braked < slip ? 1.0 - braked / slip : 0.0;
    v = left * v;
    const auto moved = x - before, towards = dot(moved, surface.normal) * surface.normal;
    x = before + towards + left * (moved - towards);
}

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
