// Order: halving the step divides the error by 2^order, no more and no less, on a cloth that moves far, in wind that
// changes.
#include "catch.hpp"
#include "physics_reference.hpp"
#include "physics_sheet.hpp"

using namespace drapeau;
using namespace drapeau::testing;

namespace {

constexpr double end = 0.4;  // s

/// A small cloth on two grommets, falling from flat into gusts.
Model cloth(const Springs& springs, Borders borders = Borders::alike) {
    return Model({5, 4, 0.1, 0.1}, springs, Attach::grommets,
                 Terms()
                     .add(Gravity{{0.0, -9.81, 0.0}})
                     .add(AirDrag{0.01})
                     .add(Wind{{3.0, 0.5, 1.0}, {1.0, 0.5, 1.0}, 1.5, false, 3}),
                 {}, borders);
}
const auto springs_of = all_springs(0.01, 200.0, 100.0, 0.05);

double error(const Points& x, const Points& exact) {
    Points off = x;
    for (std::size_t n = 0; n < off.size(); ++n) off[n] -= exact[n];
    return root_mean_square(off);
}

struct Moved {
    Points x, v;
};
Moved exact_motion(const Model& model, Borders borders = Borders::alike) {
    Moved exact{scattered(model.grid, 0.0), at_rest(model)};
    Reference(model, borders).runge_kutta(exact.x, exact.v, end / 6400, 6400);  // off by some 1e-13 m
    return exact;
}

/// Steps at which errors are taken: coarse enough that rounding (1e-14 m) and the reference's own error are nothing
/// beside theirs, fine enough for the next term of the error to be small.
template <class Method>
std::vector<int> steps_for(const Springs& springs) {
    if (Method::order == 4) return {400, 800, 1600};
    // Without damping forward Euler grows; it needs smaller steps to be in its range of order 1.
    if (std::is_same_v<Method, ForwardEuler>)
        return springs.damping ? std::vector{6400, 12800, 25600} : std::vector{25600, 51200, 102400};
    if (std::is_same_v<Method, Xpbd>) return {25600, 51200, 102400};  // its softness shrinks with dt^2
    // So does implicit Euler to damp fast modes no more than they are in truth.
    if (std::is_same_v<Method, ImplicitEuler> && !springs.damping) return {12800, 25600, 51200};
    if (Method::order == 1) return {3200, 6400, 12800};
    return {800, 1600, 3200};
}

/// On the two finest pairs.
void check_order(const std::vector<double>& errors, int order) {
    for (std::size_t n = errors.size() - 3; n + 1 < errors.size(); ++n) {
        const double measured = std::log2(errors[n] / errors[n + 1]);
        INFO("errors " << errors[n] << " and " << errors[n + 1]);
        CHECK(measured > order - 0.1);
        CHECK(measured < order + 0.1);
    }
}

/// Of positions and velocities, which leapfrog synchronises.
template <class Method>
void check_orders(const Model& model, const Springs& springs) {
    const Moved exact = exact_motion(model);
    std::vector<double> in_position, in_velocity;
    for (const int n : steps_for<Method>(springs)) {
        Sheet<double, Method> sheet(model);
        sheet.advance(end / n, n);
        in_position.push_back(error(sheet.positions(), exact.x));
        in_velocity.push_back(error(sheet.velocities(), exact.v));
    }
    INFO("diagonals " << model.has_diagonals() << ", damped " << model.is_damped());
    check_order(in_position, Method::order);
    check_order(in_velocity, Method::order);
}

}  // namespace

TEST_CASE("The reference of these tests is of order 4", "[physics]") {
    const Model model = cloth(springs_of[3]);
    const Reference reference(model);
    std::vector<Points> x;
    for (const int n : {200, 400, 800, 6400}) {
        x.push_back(scattered(model.grid, 0.0));
        auto v = at_rest(model);
        reference.runge_kutta(x.back(), v, end / n, n);
    }
    check_order({error(x[0], x[3]), error(x[1], x[3]), error(x[2], x[3])}, 4);
}

TEMPLATE_LIST_TEST_CASE("A method has the order it declares, not less and not more", "[physics]", DoubleCases) {
    using Method = typename TestType::Method;
    for (const auto& springs : springs_of) check_orders<Method>(cloth(springs), springs);
}

TEMPLATE_LIST_TEST_CASE("A method has its order with air on faces too, springs damped or not", "[physics]",
                        DoubleCases) {
    // In a wind that meets every face from one side all the time: the pressure's second derivative jumps where u_n
    // changes its sign.
    using Method = typename TestType::Method;
    for (const auto& springs : {springs_of[1], springs_of[3]}) {
        const Model model({5, 4, 0.1, 0.1}, springs, Attach::grommets,
                          Terms()
                              .add(Gravity{{0.0, -9.81, 0.0}})
                              .add(Air{.density = 1.2, .pressure = 1.2, .skin = 0.3})
                              .add(Wind{{3.0, 0.5, 6.0}, {0.5, 0.2, 0.5}, 1.5, true, 3}));
        check_orders<Method>(model, springs);
    }
}

TEMPLATE_LIST_TEST_CASE("A method has its order with bending too, braked or not", "[physics]", DoubleCases) {
    using Method = typename TestType::Method;
    for (const std::optional<double> damping : {std::optional<double>(), std::optional(50.0)}) {
        const Springs& springs = springs_of[damping ? 3 : 1];
        Model model = cloth(springs);
        model.terms.add(Bending{.stiffness = 0.02, .damping = damping});
        check_orders<Method>(model, springs);
    }
}

TEMPLATE_LIST_TEST_CASE("A cloth with light borders follows its own equations", "[physics]", DoubleCases) {
    using Method = typename TestType::Method;
    const Model model = cloth(springs_of[3], Borders::light);
    const Moved exact = exact_motion(model, Borders::light);
    std::vector<double> errors;
    for (const int n : steps_for<Method>(springs_of[3])) {
        Sheet<double, Method> sheet(model);
        sheet.advance(end / n, n);
        errors.push_back(error(sheet.positions(), exact.x));
    }
    check_order(errors, Method::order);
}
