// Chains: one row or one column of masses, for which statics has simple exact answers.
#include "catch.hpp"
#include "physics_sheet.hpp"

using namespace drapeau;
using namespace drapeau::testing;

namespace {

constexpr double g = 9.81;  // m/s2
const Gravity down{{0.0, -g, 0.0}};

/// Steps short enough for every method: forward Euler's own limit, the others' at 0.8 of theirs.
template <class Method>
double settling_step(const Model& model) {
    return 0.8 * std::min(stable_step(Method{}, model).seconds(), stable_step(SemiImplicitEuler{}, model).seconds());
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("A hanging chain is stretched by m g N(N+1)/2k", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    if (std::is_same_v<Method, Xpbd>) return;  // too soft by nature: solvers_test.cpp
    constexpr int springs = 20;
    const double drag = 0.2;  // N s/m, near critical for the slowest mode, 2 m omega_1 = 0.22
    const Model model(spread(1, springs + 1, 0.0, 1.0), {0.01, 200.0, {}, {}}, Attach::top,
                      Terms().add(down).add(AirDrag{drag}));
    Sheet<Real, Method> chain(model);
    const double dt = settling_step<Method>(model);
    chain.advance(dt, static_cast<long long>(6.0 / dt));  // exp(-10/s * 6 s) = 1e-26 of the fall is left

    const double m = model.springs.mass, k = model.springs.stiffness;
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
        CHECK(std::abs(k * (l - model.grid.pitch_y) - (springs - j + 1) * m * g) < k * rounding);
    }
    CHECK(chain.measure().max_force == Approx(springs * m * g).margin(k * rounding));
}

TEMPLATE_LIST_TEST_CASE("A hanging band of cloth is stretched by rho g L^2/2EA, whatever its grid", "[physics]",
                        DoubleCases) {
    // With half a mass at the free end, as cloth has there, m g N^2/2k is that for every N; all masses alike are off by
    // (1 + 1/N).
    using Method = typename TestType::Method;
    if (std::is_same_v<Method, Xpbd>) return;                 // too soft by nature: solvers_test.cpp
    const double rho = 0.11, L = 0.9, EA = 500.0;             // kg/m, m, N
    const double slowest = 1.5708 / L * std::sqrt(EA / rho);  // 1/s: a standing quarter wave
    for (const int springs : {2, 3, 8, 32}) {
        const double h = L / springs, m = rho * h, drag = 2.0 * m * slowest;  // critical
        for (const Borders borders : {Borders::light, Borders::alike}) {
            const Model model(spread(1, springs + 1, 0.0, L), {m, EA / h, {}, {}}, Attach::top,
                              Terms().add(down).add(AirDrag{drag}), {}, borders);
            Sheet<double, Method> band(model);
            const double dt = settling_step<Method>(model);
            // A coarse chain swings more slowly, by 1.24 instead of 1.57 at worst, so it creeps back with 0.38 of the
            // damping rate: exp(-38) = 3e-17 is left.
            band.advance(dt, static_cast<long long>(100.0 / slowest / dt));
            const double elongation = rho * g * L * L / (2.0 * EA);
            CHECK(elongation == Approx(0.000874071).epsilon(1e-6));
            const double end = borders == Borders::light ? 1.0 : 1.0 + 1.0 / springs;
            CHECK(std::abs(-band.positions()[springs].y - L - end * elongation) < 1e-10);
        }
    }
}

TEMPLATE_LIST_TEST_CASE("A column and a row of masses are the same chain, turned", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    const auto turned = [](const glm::dvec3& p) { return glm::dvec3{-p.y, p.x, p.z}; };  // down becomes along the fly
    for (const int masses : {2, 3, 16, 17, 40}) {
        const Springs springs{0.01, 200.0, 100.0, 0.02};
        const glm::dvec3 wind{2.0, 1.0, 0.5};
        const auto terms = [&](const glm::dvec3& gravity, const glm::dvec3& blowing) {
            return Terms().add(Gravity{gravity}).add(AirDrag{0.02}).add(Wind{.velocity = blowing});
        };
        const Model column(spread(1, masses, 0.0, 1.0), springs, Attach::top, terms(down.acceleration, wind));
        const Model row(spread(masses, 1, 1.0, 0.0), springs, Attach::hoist,
                        terms(turned(down.acceleration), turned(wind)));

        const auto x = scattered(column.grid, 0.1 / masses);
        auto x_turned = x;
        for (auto& p : x_turned) p = turned(p);
        Sheet<Real, Method> hanging(column, x, noise(masses, 0.0)), lying(row, x_turned, noise(masses, 0.0));
        const double dt = 0.5 * std::min(stable_step(Method{}, column).seconds(), 1e-3);
        hanging.advance(dt, 200), lying.advance(dt, 200);
        auto expected = hanging.positions();
        for (auto& p : expected) p = turned(p);
        // Only the order of the three squares in l^2 differs: a force error of 2 eps k l a step, kept for n^2/2 steps
        // of free motion, dt^2 k/m < 1: n^2 eps l with l up to 1 m between two masses, and never less than 2 n eps.
        CHECK(distance(lying.positions(), expected) < 200.0 * 200.0 / masses * epsilon<Real>);
        CHECK(distance(hanging.positions(), x) > 1e-4);  // it moved
    }
}

TEST_CASE("Two free masses on a spring swing with sqrt(2k/m)", "[physics]") {
    // Semi-implicit Euler swings with cos(w dt) = 1 - (omega dt)^2/2 instead, exactly; along x the spring is linear.
    const double m = 0.02, k = 50.0, dt = 1e-3, pull = 0.01;
    const Model model(spread(2, 1, 0.5, 0.0), {m, k, {}, {}}, Attach::none);
    const Points x0{{-pull, 0, 0}, {0.5 + pull, 0, 0}};
    Sheet<double, SemiImplicitEuler> pair(model, x0, noise(2, 0.0));
    Sheet<double, Leapfrog> centred(model, x0, noise(2, 0.0));
    const double theta = std::acos(1.0 - k / m * dt * dt);  // omega^2 = 2k/m
    for (int n = 1; n <= 300; ++n) {
        pair.advance(dt, 1), centred.advance(dt, 1);
        // Released at rest, the first step's kick makes it start half a step late: cos((n - 1/2) theta) / cos(theta/2)
        // would be a step too early at n = 0; the recurrence's solution has x_0 = p and x_1 = (1 - a) p.
        const double expected = pull * std::cos((n + 0.5) * theta) / std::cos(0.5 * theta);
        const auto x = pair.positions();
        CHECK(std::abs((x[1].x - x[0].x - 0.5) / 2.0 - expected) < 300 * 4 * epsilon<double>);
        // Leapfrog starts half a kick back, so it is in phase.
        const auto y = centred.positions();
        CHECK(std::abs((y[1].x - y[0].x - 0.5) / 2.0 - pull * std::cos(n * theta)) < 300 * 4 * epsilon<double>);
    }
}
