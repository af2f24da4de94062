#include "report_arrangement.hpp"

#include "drapeau/spring.hpp"

namespace drapeau {
namespace {

/// The force (N) of a spring on the mass at `x`, whose other end is at `x_other` (the report's calculRessortForce):
/// f = [k (l - L) + c (v_other - v) . e] e     (report, eqs. 5 and 6)
template <class Real, class vec3 = glm::vec<3, Real>>
inline vec3 spring_force(const vec3& x, const vec3& v, const vec3& x_other, const vec3& v_other, Real k, Real c,
                         Real rest_length) {
    const vec3 d = x_other - x;
    const Real l = glm::length(d);
    if (l < static_cast<Real>(shortest_length)) return vec3(0);
    const vec3 e = d * (1 / l);
    return (k * (l - rest_length) + c * glm::dot(v_other - v, e)) * e;
}

}  // namespace

template <class Real>
void ReportArrangement<Real>::set(int i, int j, const glm::dvec3& position, const glm::dvec3& velocity) {
    mass(i, j).position = vec3(position);
    mass(i, j).velocity = mass(i, j).attached ? vec3(0) : vec3(velocity);
}

template <class Real>
inline void ReportArrangement<Real>::compute_force(int i, int j) {
    Mass& here = mass(i, j);
    const vec3 x = here.position, v = here.velocity;
    vec3 force = mass_ * gravity_ - drag_ * v + drag_ * wind_ + here.stored_force;

    // Of its eight neighbours, those to the right and below have computed their springs to this mass already.
    const auto pull = [&](Mass& other, const Spring spring) {
        const vec3 f =
            spring_force<Real>(x, v, other.position, other.velocity, spring.stiffness, spring.damping, spring.length);
        force += f;
        other.stored_force -= f;
    };
    const bool has_left = i > 0, has_right = i + 1 < columns_, has_above = j > 0;
    if (has_left) pull(mass(i - 1, j), along_fly_);
    if (has_above) pull(mass(i, j - 1), down_hoist_);
    if (diagonals_) {
        if (has_left && has_above) pull(mass(i - 1, j - 1), diagonal_);
        if (has_right && has_above) pull(mass(i + 1, j - 1), diagonal_);
    }
    here.force = force;
    here.stored_force = vec3(0);
}

template <class Real>
inline void ReportArrangement<Real>::move(Mass& mass, Real dt, Real dt_over_m) const {
    if (mass.attached) return;
    mass.velocity += dt_over_m * mass.force;
    mass.position += dt * mass.velocity;
}

template <class Real>
void ReportArrangement<Real>::advance(double dt, int steps) {
    const Real h = static_cast<Real>(dt), dt_over_m = h / mass_;
    for (int step = 0; step < steps; ++step)
        for (int j = rows_ - 1; j >= 0; --j)
            for (int i = columns_ - 1; i >= 0; --i) {
                compute_force(i, j);
                move(mass(i, j), h, dt_over_m);
            }
}

template class ReportArrangement<float>;
template class ReportArrangement<double>;

}  // namespace drapeau
