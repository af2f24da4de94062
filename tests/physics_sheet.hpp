// Sheet: a cloth with its terms chosen at run time, moved by the core's sweep: what the physics tests run.
// Everything these tests ask of the core's kernels goes through this file.
#pragma once

#include "drapeau/advance.hpp"
#include "drapeau/energy.hpp"
#include "drapeau/forces.hpp"
#include "drapeau/methods/forward_euler.hpp"
#include "drapeau/methods/semi_implicit_euler.hpp"
#include "drapeau/stability.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace drapeau::testing {

using Points = std::vector<glm::dvec3>;  // one value per mass, row by row

/// A cloth and all that acts on it.
struct Setting {
    Grid grid{};
    Attach attach = Attach::none;
    Material material{};
    glm::dvec3 gravity{0.0};
    double drag = 0.0, friction = 0.0;
    Wind wind{};

    int masses() const { return static_cast<int>(grid.masses()); }
    bool held(int n) const { return is_attached(attach, grid, n % grid.columns, n / grid.columns); }
    Rates rates() const { return Rates::of(grid, material, drag, friction); }
};

/// Grids that matter to a sweep in registers: the smallest, widths just below, at and above whole registers.
inline const std::pair<int, int> awkward_sizes[] = {{2, 2}, {3, 2}, {5, 4}, {16, 3}, {17, 5}, {33, 7}};

/// With and without diagonals, with and without damping.
inline std::vector<Material> all_materials(double mass, double k, double kd, double c) {
    return {{mass, k, {}, {}}, {mass, k, kd, {}}, {mass, k, {}, c}, {mass, k, kd, c}};
}

/// The rest positions, each coordinate moved by up to `size` (m).
inline Points scattered(const Grid& grid, double size, std::uint64_t seed = 7) {
    Points x;
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            const auto n = static_cast<std::int64_t>(x.size());
            x.push_back(grid.rest(i, j) +
                        size * glm::dvec3{random_at(seed, 0, n), random_at(seed, 1, n), random_at(seed, 2, n)});
        }
    return x;
}
inline Points noise(int masses, double size, std::uint64_t seed = 11) {
    Points v;
    for (int n = 0; n < masses; ++n)
        v.push_back(size * glm::dvec3{random_at(seed, 3, n), random_at(seed, 4, n), random_at(seed, 5, n)});
    return v;
}

inline double dot(const glm::dvec3& a, const glm::dvec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline glm::dvec3 cross(const glm::dvec3& a, const glm::dvec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const glm::dvec3& a) {
    return std::sqrt(dot(a, a));
}
/// Greatest distance between two sets of points; NaN if any is.
inline double distance(const Points& a, const Points& b) {
    double most = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n) {
        const double far = length(a[n] - b[n]);
        if (!(far <= most)) most = far;
        if (std::isnan(far)) return far;
    }
    return most;
}
inline double root_mean_square(const Points& a) {
    double sum = 0.0;
    for (const auto& p : a) sum += dot(p, p);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

template <class Real>
constexpr double epsilon = std::numeric_limits<Real>::epsilon();

/// The core at work: Method and precision fixed, terms as the setting says, V masses at a time.
template <class Real, class Method, class V = Vector<Real>>
class Sheet {
public:
    explicit Sheet(const Setting& s) : setting(s), cloth(s.grid), fabric(s.grid, s.attach, s.material) {
        for (int n = 0; n < 2; ++n) buffers.emplace_back(cloth.width());
        set(scattered(s.grid, 0.0), Points(static_cast<std::size_t>(s.masses()), glm::dvec3(0.0)));
    }
    Sheet(const Setting& s, const Points& x, const Points& v) : Sheet(s) { set(x, v); }

    void set(const Points& x, const Points& v) {
        for (int n = 0; n < setting.masses(); ++n) {
            const int i = n % setting.grid.columns, j = n / setting.grid.columns;
            cloth.set_position(i, j, x[n]);
            cloth.set_velocity(i, j, setting.held(n) ? glm::dvec3(0.0) : v[n]);
        }
    }

    Points positions() const {
        return collect([&](int i, int j) { return cloth.position(i, j); });
    }
    Points velocities() const {
        return collect([&](int i, int j) { return cloth.velocity(i, j); });
    }
    Energy energy() const { return measure(cloth, setting.material); }
    double time() const { return time_; }

    /// `count` steps of dt (s).
    void advance(double dt, long long count) {
        const double start = time_;
        for (long long n = 0; n < count; ++n) {
            const auto uniform = uniform_at(start + static_cast<double>(n) * dt);
            composed([&](auto pair, auto diagonals) {
                advance_cloth<V, decltype(pair), decltype(diagonals)::value, Method>(
                    cloth.view(), fabric.view(), uniform, static_cast<Real>(dt), buffers[0]);
            });
        }
        time_ = start + static_cast<double>(count) * dt;
    }

    /// What the springs pull on every mass (N).
    Points forces() {
        Cloth<Real> force(setting.grid);
        composed([&](auto pair, auto diagonals) {
            spring_forces<V, decltype(pair), decltype(diagonals)::value>(
                cloth.view(), fabric.view(),
                ForceRow<Real>{force.component(0).data(), force.component(1).data(), force.component(2).data()},
                buffers[0]);
        });
        return collect([&](int i, int j) { return force.position(i, j); });
    }

    Uniform<Real, true, true> uniform_at(double t) const {
        return fold<Real>(setting.material.mass, t, Gravity{setting.gravity}, AirDrag{setting.drag},
                          Friction{setting.friction}, UniformWind{setting.wind});
    }

    /// Calls run(Pair, diagonals) with the types of this setting's composition.
    template <class Run>
    void composed(Run&& run) const {
        const bool diagonals = setting.material.diagonal_stiffness.has_value();
        if (setting.material.damping)
            diagonals ? run(SpringForce<true>{}, std::true_type{}) : run(SpringForce<true>{}, std::false_type{});
        else
            diagonals ? run(SpringForce<false>{}, std::true_type{}) : run(SpringForce<false>{}, std::false_type{});
    }

    Setting setting;
    Cloth<Real> cloth;
    Fabric<Real> fabric;
    std::vector<SweepBuffers<Real>> buffers;

private:
    template <class At>
    Points collect(At&& at) const {
        Points all;
        for (int j = 0; j < setting.grid.rows; ++j)
            for (int i = 0; i < setting.grid.columns; ++i) all.push_back(at(i, j));
        return all;
    }
    double time_ = 0.0;
};

// Compiled once, in sweep_test.cpp.
extern template class Sheet<float, ForwardEuler>;
extern template class Sheet<float, SemiImplicitEuler>;
extern template class Sheet<double, ForwardEuler>;
extern template class Sheet<double, SemiImplicitEuler>;

/// Whether two cloths hold the same bits, padding included.
template <class Real>
bool same_bits(const Cloth<Real>& a, const Cloth<Real>& b) {
    for (int c = 0; c < 6; ++c)
        if (std::memcmp(a.component(c).data(), b.component(c).data(), a.count() * sizeof(Real)) != 0) return false;
    return true;
}

/// One precision and one method: what a law is looped over.
template <class R, class M>
struct Case {
    using Real = R;
    using Method = M;
};
using AllCases = std::tuple<Case<float, ForwardEuler>, Case<float, SemiImplicitEuler>, Case<double, ForwardEuler>,
                            Case<double, SemiImplicitEuler>>;
using DoubleCases = std::tuple<Case<double, ForwardEuler>, Case<double, SemiImplicitEuler>>;
using Precisions = std::tuple<float, double>;

}  // namespace drapeau::testing
