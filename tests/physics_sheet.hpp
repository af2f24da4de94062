// Sheet: a model moved by one method in one precision, as its programs move it: what the physics tests run. The model
// is the only description of a setting; which kernels it needs is chosen from it at run time.
#pragma once

#include "drapeau/drapeau.hpp"

#include <algorithm>
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

inline int masses_of(const Model& model) {
    return static_cast<int>(model.grid.masses());
}
inline bool is_held(const Model& model, int n) {
    return model.held(n % model.grid.columns, n / model.grid.columns);
}

/// Grids that matter to a sweep in registers: the smallest, widths just below, at and above whole registers.
inline const std::pair<int, int> awkward_sizes[] = {{2, 2}, {3, 2}, {5, 4}, {16, 3}, {17, 5}, {33, 7}};

/// With and without diagonals, with and without damping.
inline std::vector<Springs> all_springs(double mass, double k, double kd, double c) {
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
inline Points at_rest(const Model& model) {
    return Points(static_cast<std::size_t>(masses_of(model)), glm::dvec3(0.0));
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

template <class Real>
Points points_of(const FieldBuffer<Real>& field) {
    Points all;
    for (int j = 0; j < field.rows(); ++j)
        for (int i = 0; i < field.columns(); ++i) all.push_back(field.at(i, j));
    return all;
}
template <class Real>
void set_points(FieldBuffer<Real>& field, const Points& points) {
    for (int n = 0; n < static_cast<int>(points.size()); ++n)
        field.set(n % field.columns(), n / field.columns(), points[static_cast<std::size_t>(n)]);
}
inline State<double> state_of(const Grid& grid, const Points& x, const Points& v) {
    State<double> state(grid.columns, grid.rows);
    set_points(state.position, x), set_points(state.velocity, v);
    return state;
}

/// A method's kernels in registers of V for what the model lists.
template <class V, class Method>
Kernels<typename Lanes<V>::Real> kernels_for(const Model& model) {
    if (model.is_damped_for<Method>())
        return model.has_diagonals() ? kernels_of<V, Method, true, true, true>()
                                     : kernels_of<V, Method, true, false, true>();
    return model.has_diagonals() ? kernels_of<V, Method, false, true, true>()
                                 : kernels_of<V, Method, false, false, true>();
}

/// A model at work: method and precision fixed, V masses at a time.
template <class Real, class Method, class V = Vector<Real>>
class Sheet {
public:
    explicit Sheet(const Model& model) : stepper(model, kernels_for<V, Method>(model)) {}
    Sheet(const Model& model, const Points& x, const Points& v) : Sheet(model) { set(x, v); }

    static constexpr bool solves = Method::solves;

    const Model& model() const { return stepper.model(); }

    /// Position and velocity at the same time.
    void set(const Points& x, const Points& v) { stepper.set(state_of(model().grid, x, v)); }
    Points positions() const { return points_of(stepper.position()); }
    Points velocities() { return points_of(stepper.state(time()).velocity); }
    Points stored_velocities() const { return points_of(stepper.velocity()); }

    double time() const { return clock.at(steps); }
    Measurement measure() { return stepper.measure(time()); }

    /// `count` steps of dt (s), of which the one with the number `accounted` tells its work.
    Report advance(double dt, long long count, long long accounted = no_step) {
        if (dt != clock.dt) {
            stepper.synchronise(time());
            clock = {time(), steps, dt};
        }
        const long long from = steps;
        steps += count;
        return stepper.advance(clock, from, steps, accounted);
    }
    /// One step of dt and what it tells of its work.
    Report accounted_step(double dt) { return advance(dt, 1, steps); }

    typename Stepper<Real>::Checkpoint checkpoint() const {
        typename Stepper<Real>::Checkpoint now;
        stepper.save(now);
        return now;
    }

    Stepper<Real> stepper;
    Clock clock;
    long long steps = 0;
};

/// Whether two fields hold the same bits, padding included.
template <class Real>
bool same_bits(const FieldBuffer<Real>& a, const FieldBuffer<Real>& b) {
    for (int c = 0; c < 3; ++c)
        if (std::memcmp(a.component(c).data(), b.component(c).data(), a.component(c).size() * sizeof(Real)) != 0)
            return false;
    return true;
}
/// Whether two sheets hold the same bits in every field, what a method and held terms keep included.
template <class Tested>
bool same_bits(const Tested& a, const Tested& b) {
    const auto one = a.checkpoint(), other = b.checkpoint();
    if (one.fields.size() != other.fields.size() || one.held.size() != other.held.size() ||
        one.started_dt != other.started_dt)
        return false;
    for (std::size_t f = 0; f < one.held.size(); ++f)
        if (!same_bits(one.held[f], other.held[f])) return false;
    for (std::size_t f = 0; f < one.fields.size(); ++f)
        if (!same_bits(one.fields[f], other.fields[f])) return false;
    return true;
}

/// Kernels called by hand on any block of rows: fields, constants and buffers as a Stepper would hand them.
template <class Real>
class Rows {
public:
    Rows(const Model& model, std::vector<FieldBuffer<Real>> of)
        : fields(std::move(of)),
          sums(static_cast<std::size_t>(model.grid.rows)),
          out(model.grid.columns, model.grid.rows),
          model_(model),
          constants_(model),
          waiting_(constants_.width()),
          acceleration_(model.grid.columns, 1) {}

    Rows(const Rows&) = delete;  // its passes point into it

    /// The rows first <= j < last at time t (s). Terms that push masses are asked for every row.
    Pass<Real> pass(int first, int last, double dt, double t) {
        Pass<Real> p{};
        for (std::size_t f = 0; f < fields.size(); ++f) p.fields[f] = fields[f].view();
        p.first = first, p.last = last, p.rows = model_.grid.rows;
        p.width = constants_.width();
        p.constants = constants_.constants();
        p.acceleration = std::as_const(acceleration_).view();
        p.acceleration.stride = 0;  // one row for all
        p.accelerate = &fill;
        p.terms = this;
        p.time = t;
        p.dt = static_cast<Real>(dt);
        p.waiting = waiting_.view();
        p.sums = sums.data();
        p.out = out.view();
        return p;
    }
    Rows copy() const { return {model_, fields}; }
    Pass<Real> whole(double dt = 0.0, double t = 0.0) { return pass(0, model_.grid.rows, dt, t); }

    std::vector<FieldBuffer<Real>> fields;
    std::vector<RowSums> sums;
    FieldBuffer<Real> out;

private:
    static void fill(void* self, int row, double t) {
        Rows& rows = *static_cast<Rows*>(self);
        for (int c = 0; c < 3; ++c)
            std::fill(rows.acceleration_.component(c).begin(), rows.acceleration_.component(c).end(), Real(0));
        rows.model_.terms.for_each([&](const auto& term) {
            const PushedRow<Real> pushed{rows.model_.grid, row, rows.constants_.width(),
                                         rows.constants_.drag_rate(rows.model_, row)};
            const auto a = rows.acceleration_.view();
            if constexpr (requires { term.accelerate(pushed, t, a); }) term.accelerate(pushed, t, a);
        });
    }

    Model model_;
    ModelRows<Real> constants_;
    WaitingBuffer<Real> waiting_;
    FieldBuffer<Real> acceleration_;
};

/// One precision and one method: what a law is looped over.
template <class R, class M>
struct Case {
    using Real = R;
    using Method = M;
};
template <class Real, class List>
struct CasesOf;
template <class Real, class... M>
struct CasesOf<Real, std::tuple<M...>> {
    using type = std::tuple<Case<Real, M>...>;
};
using FloatCases = CasesOf<float, Methods>::type;
using DoubleCases = CasesOf<double, Methods>::type;
using AllCases = decltype(std::tuple_cat(FloatCases{}, DoubleCases{}));
// Methods whose closed forms are written out in the tests. One that joins the list meets all other laws by itself.
using WrittenOut = std::tuple<ForwardEuler, SemiImplicitEuler, Leapfrog, Rk4>;
using WrittenOutDouble = CasesOf<double, WrittenOut>::type;
using WrittenOutCases = decltype(std::tuple_cat(CasesOf<float, WrittenOut>::type{}, WrittenOutDouble{}));
// The same of one mass on one spring, of all methods.
using ClosedForm = std::tuple<ForwardEuler, SemiImplicitEuler, Leapfrog, Rk4, ImplicitEuler, Xpbd>;
using ClosedFormDouble = CasesOf<double, ClosedForm>::type;
using ClosedFormCases = decltype(std::tuple_cat(CasesOf<float, ClosedForm>::type{}, ClosedFormDouble{}));
// Methods that the sweep moves, which do not take whole steps of their own.
template <class... M>
auto swept(std::tuple<M...>)
    -> decltype(std::tuple_cat(std::conditional_t<M::solves, std::tuple<>, std::tuple<M>>{}...));
using Swept = decltype(swept(Methods{}));
using SweptDouble = CasesOf<double, Swept>::type;
using SweptCases = decltype(std::tuple_cat(CasesOf<float, Swept>::type{}, SweptDouble{}));
using Precisions = std::tuple<float, double>;

// Kernels are compiled once, in physics_sheet.cpp.
#define DRAPEAU_TESTED_KERNELS(prefix, Method)                                       \
    prefix template Kernels<float> kernels_for<Vector<float>, Method>(const Model&); \
    prefix template Kernels<double> kernels_for<Vector<double>, Method>(const Model&);
#define DRAPEAU_ALL_TESTED_KERNELS(prefix)            \
    DRAPEAU_TESTED_KERNELS(prefix, ForwardEuler)      \
    DRAPEAU_TESTED_KERNELS(prefix, SemiImplicitEuler) \
    DRAPEAU_TESTED_KERNELS(prefix, Leapfrog)          \
    DRAPEAU_TESTED_KERNELS(prefix, Rk4)               \
    DRAPEAU_TESTED_KERNELS(prefix, ImplicitEuler)     \
    DRAPEAU_TESTED_KERNELS(prefix, Xpbd)
DRAPEAU_ALL_TESTED_KERNELS(extern)

}  // namespace drapeau::testing

namespace drapeau {
inline namespace DRAPEAU_ISA {
extern template class Stepper<float>;
extern template class Stepper<double>;
}  // namespace DRAPEAU_ISA
}  // namespace drapeau
