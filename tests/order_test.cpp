// Order: halving the step halves the error, no more and no less, on a cloth that moves far, in wind that changes.
#include "catch.hpp"
#include "physics_reference.hpp"
#include "physics_sheet.hpp"

using namespace drapeau;
using namespace drapeau::testing;

namespace {

constexpr double end = 0.4;  // s

/// A small cloth on two grommets, falling from flat into gusts.
Setting cloth(const Material& material) {
    Setting s{.grid = {5, 4, 0.1, 0.1}, .attach = Attach::grommets, .material = material};
    s.gravity = {0.0, -9.81, 0.0};
    s.drag = 0.01;
    s.wind = {{3.0, 0.5, 1.0}, {1.0, 0.5, 1.0}, 1.5, 3};
    return s;
}

double error(const Points& x, const Points& exact) {
    Points off = x;
    for (std::size_t n = 0; n < off.size(); ++n) off[n] -= exact[n];
    return root_mean_square(off);
}

}  // namespace

TEST_CASE("The reference of these tests is of order 4", "[physics]") {
    const Setting s = cloth({0.01, 200.0, 100.0, 0.04});
    const Reference reference(s);
    std::vector<Points> x;
    for (const int n : {200, 400, 800, 6400}) {
        x.push_back(scattered(s.grid, 0.0));
        auto v = noise(s.masses(), 0.0);
        reference.runge_kutta(x.back(), v, end / n, n);
    }
    for (int n = 0; n < 2; ++n) {
        const double order = std::log2(error(x[n], x[3]) / error(x[n + 1], x[3]));
        CHECK(order > 3.8);
        CHECK(order < 4.2);
    }
}

TEMPLATE_LIST_TEST_CASE("A method has the order it declares, not less and not more", "[physics]", DoubleCases) {
    using Method = typename TestType::Method;
    for (const auto& material : all_materials(0.01, 200.0, 100.0, 0.04)) {
        const Setting s = cloth(material);
        auto exact = scattered(s.grid, 0.0);
        auto v = noise(s.masses(), 0.0);
        Reference(s).runge_kutta(exact, v, end / 1600, 1600);  // off by some 1e-11 m, the errors below by 1e-5 m

        std::vector<double> errors;
        // Without damping forward Euler grows; it needs smaller steps to be in its range of order 1.
        const int coarsest = std::is_same_v<Method, ForwardEuler> ? (material.damping ? 3200 : 25600) : 800;
        for (const int n : {coarsest, 2 * coarsest, 4 * coarsest}) {
            Sheet<double, Method> sheet(s);
            sheet.advance(end / n, n);
            errors.push_back(error(sheet.positions(), exact));
        }
        for (int n = 0; n < 2; ++n) {
            const double order = std::log2(errors[n] / errors[n + 1]);
            CHECK(order > Method::order - 0.1);
            CHECK(order < Method::order + 0.1);
        }
    }
}
