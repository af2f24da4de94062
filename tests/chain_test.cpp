// Chains: one row or one column of masses, for which statics has simple exact answers.
#include "catch.hpp"
#include "physics_sheet.hpp"

using namespace drapeau;
using namespace drapeau::testing;

namespace {

constexpr int springs = 20;

/// Twenty masses hanging one below the other, with drag to come to rest.
Setting hanging_chain(double drag) {
    return {.grid = spread(1, springs + 1, 0.0, 1.0),
            .attach = Attach::top,
            .material = {0.01, 200.0, {}, {}},
            .gravity = {0.0, -9.81, 0.0},
            .drag = drag};
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("A hanging chain is stretched by m g N(N+1)/2k", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    const Setting s = hanging_chain(0.2);  // near critical for the slowest mode, 2 m omega_1 = 0.22
    Sheet<Real, Method> chain(s);
    const double dt = 0.8 * largest_step(Method{}, s.rates());
    chain.advance(dt, static_cast<long long>(6.0 / dt));  // exp(-10/s * 6 s) = 1e-26 of the fall is left

    const double m = s.material.mass, g = 9.81, k = s.material.stiffness;
    const double elongation = m * g * springs * (springs + 1) / (2.0 * k);
    CHECK(elongation == Approx(0.103005).epsilon(1e-12));
    // In double 1e-10 as asked. In float every spring's length is a difference of numbers up to 1.1 m (eps each), and
    // a mass stalls where a step's increment rounds away, below half an ulp of x each step: a force of
    // (eps/2 * 1.1 m) / dt * d, at most 2 eps k metres over k with these numbers: 3 eps a spring.
    const double rounding = std::is_same_v<Real, double> ? 1e-10 : 3.0 * springs * epsilon<Real> * 2.0;
    CHECK(std::abs(-chain.positions()[springs].y - 1.0 - elongation) < rounding);
    for (int j = 1; j <= springs; ++j) {
        const double l = chain.positions()[j - 1].y - chain.positions()[j].y;
        // Spring j from the top carries the masses below it.
        CHECK(std::abs(k * (l - s.grid.pitch_y) - (springs - j + 1) * m * g) < k * rounding);
    }
}

TEMPLATE_LIST_TEST_CASE("A column and a row of masses are the same chain, turned", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    const auto turned = [](const glm::dvec3& p) { return glm::dvec3{-p.y, p.x, p.z}; };  // down becomes along the fly
    for (const int masses : {2, 3, 16, 17, 40}) {
        Setting column{.grid = spread(1, masses, 0.0, 1.0),
                       .attach = Attach::top,
                       .material = {0.01, 200.0, 100.0, 0.02},
                       .gravity = {0.0, -9.81, 0.0},
                       .drag = 0.02};
        column.wind.mean = {2.0, 1.0, 0.5};
        Setting row = column;
        row.grid = spread(masses, 1, 1.0, 0.0);
        row.attach = Attach::hoist;
        row.gravity = turned(column.gravity);
        row.wind.mean = turned(column.wind.mean);

        const auto x = scattered(column.grid, 0.1 / masses);
        auto x_turned = x;
        for (auto& p : x_turned) p = turned(p);
        Sheet<Real, Method> down(column, x, noise(masses, 0.0)), along(row, x_turned, noise(masses, 0.0));
        const double dt = 0.5 * std::min(largest_step(Method{}, column.rates()), 1e-3);
        down.advance(dt, 200), along.advance(dt, 200);
        auto expected = down.positions();
        for (auto& p : expected) p = turned(p);
        // Only the order of the three squares in l^2 differs: a force error of 2 eps k l a step, kept for n^2/2 steps
        // of free motion, dt^2 k/m < 1: n^2 eps l with l up to 1 m between two masses, and never less than 2 n eps.
        CHECK(distance(along.positions(), expected) < 200.0 * 200.0 / masses * epsilon<Real>);
        CHECK(distance(down.positions(), x) > 1e-4);  // it moved
    }
}

TEST_CASE("Two free masses on a spring swing with sqrt(2k/m)", "[physics]") {
    // Semi-implicit Euler swings with cos(w dt) = 1 - (omega dt)^2/2 instead, exactly; along x the spring is linear.
    const double m = 0.02, k = 50.0, dt = 1e-3, pull = 0.01;
    const Setting s{.grid = spread(2, 1, 0.5, 0.0), .material = {m, k, {}, {}}};
    Sheet<double, SemiImplicitEuler> pair(s, {{-pull, 0, 0}, {0.5 + pull, 0, 0}}, noise(2, 0.0));
    const double theta = std::acos(1.0 - k / m * dt * dt);  // omega^2 = 2k/m
    for (int n = 1; n <= 300; ++n) {
        pair.advance(dt, 1);
        // Released at rest, the first step's kick makes it start half a step late: cos((n - 1/2) theta) / cos(theta/2)
        // would be a step too early at n = 0; the recurrence's solution has x_0 = p and x_1 = (1 - a) p.
        const double expected = pull * std::cos((n + 0.5) * theta) / std::cos(0.5 * theta);
        const auto x = pair.positions();
        CHECK(std::abs((x[1].x - x[0].x - 0.5) / 2.0 - expected) < 300 * 4 * epsilon<double>);
    }
}
