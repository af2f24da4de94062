// Flags composed in C++ from lists of terms, with the options of the kernels: gravity, drag and wind, which the
// programs' kernels always fold in, can be absent here.
#include "cloth_check.hpp"

#include "drapeau/flag.hpp"

namespace drapeau::bench {
namespace {

template <class Real, class... Listed>
class FlagSteps final : public Subject {
public:
    FlagSteps(const Physics& physics, const Masses& start, const Listed&... terms)
        : flag_(physics.grid, physics.attach, physics.material.mass, terms...), start_(physics.grid) {
        dt = auto_step(flag_.largest_stable_step(SemiImplicitEuler{}));
        set_masses(start_, start, physics.attach);
        restore();
    }
    void restore() override { copy_cloth(start_, flag_.cloth()); }
    void run(int times) override { flag_.advance(SemiImplicitEuler{}, dt, times); }
    std::uint64_t hash() const override { return hash_of(flag_.cloth(), start_.grid()); }
    double greatest_stretch() const override { return stretch_if_finite(flag_.energy()); }

private:
    Flag<Real, Listed...> flag_;
    Cloth<Real> start_;
};

template <class Real, class... Listed>
std::unique_ptr<Subject> flag_of(const Physics& physics, const Masses& start, const Listed&... terms) {
    return std::make_unique<FlagSteps<Real, Listed...>>(physics, start, terms...);
}

template <class Real>
std::unique_ptr<Subject> composition(const Case& c, const Masses& start) {
    const Physics physics(flag_scene(c.columns, c.rows, c.method, c.terms));
    const StructuralSprings structural{physics.material.stiffness};
    const DiagonalSprings diagonal{physics.material.diagonal_stiffness.value_or(0.0)};
    const SpringDamping damping{physics.material.damping.value_or(0.0)};
    const auto& gravity = physics.gravity;
    const auto& drag = physics.drag;
    const auto& wind = physics.wind;

    const Terms& terms = c.terms;
    if (!terms.gravity) return flag_of<Real>(physics, start, structural, diagonal, damping);
    if (!terms.drag) return flag_of<Real>(physics, start, structural, diagonal, damping, gravity);
    if (!terms.wind) return flag_of<Real>(physics, start, structural, diagonal, damping, gravity, drag);
    if (!terms.damping) return flag_of<Real>(physics, start, structural, diagonal, gravity, drag, wind);
    if (!terms.diagonal) return flag_of<Real>(physics, start, structural, damping, gravity, drag, wind);
    return flag_of<Real>(physics, start, structural, diagonal, damping, gravity, drag, wind);
}

}  // namespace

std::unique_ptr<Subject> make_composition(const Case& c, const Masses& start) {
    return c.precision == Precision::double_precision ? composition<double>(c, start) : composition<float>(c, start);
}

}  // namespace drapeau::bench
