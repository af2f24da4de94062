// Flags composed in C++ from lists of terms: drag, which the programs' kernels always compute, can be absent here.
#include "composition.hpp"

#include "cloth_check.hpp"

#include "drapeau/flag.hpp"

namespace drapeau::bench {
namespace {

template <class Real, class... Listed>
class FlagSteps final : public Subject {
public:
    FlagSteps(const Composition& c, const Listed&... listed)
        : flag_({c.columns, c.rows, c.pitch_x, c.pitch_y}, c.attach, {c.mass, c.stiffness}, listed...),
          start_(c.columns, c.rows) {
        for (int j = 0; j < c.rows; ++j)
            for (int i = 0; i < c.columns; ++i) {
                const auto vector = [&](const Field<const double>& field) {
                    const auto [x, y, z] = field.row(j).at<double>(i);
                    return glm::dvec3(x, y, z);
                };
                start_.position.set(i, j, vector(c.position));
                start_.velocity.set(i, j, vector(c.velocity));
            }
        dt = flag_.dt();
        restore();
    }
    void restore() override {
        flag_.set_state(start_);
        flag_.advance(0);  // the method starts
    }
    void run(int times) override { flag_.advance(times); }
    std::uint64_t hash() const override { return hash_of(flag_.state()); }
    double greatest_stretch() const override { return stretch_if_finite(flag_.measure()); }

private:
    mutable Flag<Real, SemiImplicitEuler, Listed...> flag_;
    State<double> start_;
};

template <class Real, class... Listed>
std::unique_ptr<Subject> flag_of(const Composition& c, const Listed&... listed) {
    return std::make_unique<FlagSteps<Real, Listed...>>(c, listed...);
}

template <class Real>
std::unique_ptr<Subject> composed(const Composition& c) {
    const DiagonalSprings diagonals{c.diagonal_stiffness};
    const SpringDamping damping{c.damping};
    const Gravity gravity{{c.gravity[0], c.gravity[1], c.gravity[2]}};
    const AirDrag drag{c.drag};
    const Wind wind{.velocity = {c.wind[0], c.wind[1], c.wind[2]}};

    if (!c.has_gravity) return flag_of<Real>(c, diagonals, damping);
    if (!c.has_drag) return flag_of<Real>(c, diagonals, damping, gravity);
    if (!c.has_wind) return flag_of<Real>(c, diagonals, damping, gravity, drag);
    if (!c.is_damped) return flag_of<Real>(c, diagonals, gravity, drag, wind);
    if (!c.has_diagonals) return flag_of<Real>(c, damping, gravity, drag, wind);
    return flag_of<Real>(c, diagonals, damping, gravity, drag, wind);
}

}  // namespace

std::unique_ptr<Subject> make_composition(const Composition& c) {
    return c.in_double ? composed<double>(c) : composed<float>(c);
}

}  // namespace drapeau::bench
