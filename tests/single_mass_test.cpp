// One mass: on a spring, in the wind, falling. Everything here has a closed form, of the equation and of the method.
#include "catch.hpp"
#include "physics_sheet.hpp"

using namespace drapeau;
using namespace drapeau::testing;

namespace {

constexpr double rest = 2.0;  // m, of the spring: longer than any swing below

/// A mass on a spring along x, its other end held.
Setting oscillator(double m, double k, std::optional<double> c) {
    return {.grid = spread(2, 1, rest, 1.0), .attach = Attach::hoist, .material = {m, k, {}, c}};
}

template <class Real, class Method>
Sheet<Real, Method> displaced(const Setting& setting, double x0) {
    return {setting, {{0, 0, 0}, {rest + x0, 0, 0}}, Points(2, glm::dvec3(0.0))};
}

/// m x'' = -k x - c x', released at x0: the solution of the equation.
double damped_oscillation(double m, double k, double c, double x0, double t) {
    const double gamma = c / (2.0 * m), omega = std::sqrt(k / m - gamma * gamma);
    return std::exp(-gamma * t) * x0 * (std::cos(omega * t) + gamma / omega * std::sin(omega * t));
}

/// Semi-implicit Euler on it after n steps, in closed form: x_{n+1} = T x_n - D x_{n-1} with T = 2 - a - b, D = 1 - b,
/// a = k dt^2/m, b = c dt/m, solved by x_n = D^{n/2} (x0 cos(n theta) + B sin(n theta)).
double semi_implicit_oscillation(double m, double k, double c, double x0, double dt, int n) {
    const double a = k * dt * dt / m, b = c * dt / m;
    const double mu = std::sqrt(1.0 - b), cosine = (2.0 - a - b) / (2.0 * mu), theta = std::acos(cosine);
    const double B = ((1.0 - a) * x0 / mu - x0 * cosine) / std::sin(theta);
    return std::pow(mu, n) * (x0 * std::cos(n * theta) + B * std::sin(n * theta));
}

/// A mass on its own in wind and gravity, its spring of no stiffness.
Setting projectile() {
    Setting s = oscillator(0.01, 0.0, {});
    s.gravity = {0.0, 0.0, -9.81};
    s.drag = 0.02;
    s.wind.mean = {6.0, 0.0, 0.0};
    return s;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("A damped oscillator follows its equation with the method's order", "[physics]", DoubleCases) {
    const double m = 0.01, k = 100.0, c = 0.2, x0 = 0.01, end = 0.05;
    const double exact = damped_oscillation(m, k, c, x0, end);
    CHECK(exact == Approx(9.855066761858644e-4).epsilon(1e-12));  // the closed form is typed in rightly

    std::vector<double> errors;
    for (const int steps : {800, 1600, 3200, 6400}) {
        auto mass = displaced<double, typename TestType::Method>(oscillator(m, k, c), x0);
        mass.advance(end / steps, steps);
        errors.push_back(std::abs(mass.positions()[1].x - rest - exact));
    }
    for (std::size_t n = 1; n + 1 < errors.size(); ++n) {
        const double order = std::log2(errors[n] / errors[n + 1]);
        CHECK(order > TestType::Method::order - 0.1);
        CHECK(order < TestType::Method::order + 0.1);
    }
}

TEMPLATE_LIST_TEST_CASE("Semi-implicit Euler on an oscillator is its own closed form", "[physics]", Precisions) {
    // The spring's length of about 2 m is known to one unit in the last place (eps * 2 m); a step's force passes it on
    // with a = 0.25, and an undamped oscillation keeps every step's error at most 1/sin(theta) = 2.1 times as large:
    // over 1000 steps 2 * 0.25 * 2.1 * 1000 eps, and as much again from storing x.
    const double rounding = 4000.0 * epsilon<TestType>;

    auto undamped = displaced<TestType, SemiImplicitEuler>(oscillator(0.01, 100.0, {}), 1.0);
    undamped.advance(0.005, 1000);
    const double x = undamped.positions()[1].x - rest;
    CHECK(semi_implicit_oscillation(0.01, 100.0, 0.0, 1.0, 0.005, 1000) == Approx(-1.015507490276).epsilon(1e-12));
    CHECK(std::abs(x + 1.015507490276) < rounding + 1e-12);

    auto damped = displaced<TestType, SemiImplicitEuler>(oscillator(0.01, 100.0, 0.2), 0.01);
    damped.advance(1e-3, 50);
    CHECK(semi_implicit_oscillation(0.01, 100.0, 0.2, 0.01, 1e-3, 50) == Approx(1.43064503e-3).epsilon(1e-8));
    const double closed_form = semi_implicit_oscillation(0.01, 100.0, 0.2, 0.01, 1e-3, 50);
    CHECK(std::abs(damped.positions()[1].x - rest - closed_form) < 0.05 * rounding);  // 50 steps instead of 1000
    CHECK(damped.positions()[1].y == 0.0);
    CHECK(damped.positions()[1].z == 0.0);
}

TEST_CASE("Semi-implicit Euler conserves its shadow energy; the plain energy swings about it", "[physics]") {
    const double m = 0.01, k = 100.0, dt = 0.005;  // omega dt = 0.5
    auto mass = displaced<double, SemiImplicitEuler>(oscillator(m, k, {}), 1.0);
    const double initial = 0.5 * k;
    double lowest = 1e9, highest = 0.0, drift = 0.0;
    for (int n = 0; n < 2000; ++n) {
        mass.advance(dt, 1);
        const double x = mass.positions()[1].x - rest, v = mass.velocities()[1].x;
        const double energy = 0.5 * m * v * v + 0.5 * k * x * x;
        drift = std::max(drift, std::abs(energy - 0.5 * dt * k * x * v - initial) / initial);
        lowest = std::min(lowest, energy / initial), highest = std::max(highest, energy / initial);
    }
    CHECK(drift < 2000 * 8 * epsilon<double>);  // 2000 steps, each a few roundings of numbers up to 4 times 1 m
    // Extremes H/I = 1/(1 +- omega dt/2); a thousand phases come within 1e-3 of them.
    CHECK(lowest == Approx(0.8).epsilon(1e-3));
    CHECK(highest == Approx(4.0 / 3.0).epsilon(1e-3));
}

TEMPLATE_LIST_TEST_CASE("A mass in wind follows the method's closed form", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    const Setting s = projectile();
    const glm::dvec3 v0{1.0, 2.0, 3.0}, terminal{6.0, 0.0, -4.905};
    const double dt = 0.01;
    const int n = 50;
    Sheet<Real, typename TestType::Method> mass(s, Points(2, glm::dvec3(0.0)), {{}, v0});
    mass.advance(dt, n);

    // v_n = v_t + (v0 - v_t) r^n with r = 1 - d dt/m; forward Euler moves by the velocities one step earlier.
    const double r = 1.0 - s.drag * dt / s.material.mass;
    const bool semi_implicit = std::is_same_v<typename TestType::Method, SemiImplicitEuler>;
    const glm::dvec3 v = terminal + (v0 - terminal) * std::pow(r, n);
    const glm::dvec3 x =
        n * dt * terminal + dt * (v0 - terminal) * ((semi_implicit ? r : 1.0) * (1.0 - std::pow(r, n)) / (1.0 - r));
    if (semi_implicit) {
        CHECK(x.x == Approx(1.44221572).epsilon(1e-8));
        CHECK(x.y == Approx(0.62311371).epsilon(1e-8));
        CHECK(x.z == Approx(0.01035695).epsilon(1e-6));
    }
    // Every step rounds v (up to 6 m/s) and x (up to 3 m) a few times by eps/2.
    CHECK(length(mass.velocities()[1] - v) < 2 * n * 6.0 * epsilon<Real>);
    CHECK(length(mass.positions()[1] - x) < 2 * n * 3.0 * epsilon<Real>);
}

TEMPLATE_LIST_TEST_CASE("The terminal velocity is a fixed point of every method", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    const glm::dvec3 terminal{6.0, 0.0, -4.905};
    Sheet<Real, typename TestType::Method> mass(projectile(), Points(2, glm::dvec3(0.0)), {{}, terminal});
    mass.advance(0.01, 2000);
    // Drag pulls every rounding back at once (d dt/m = 0.02): what is left is eps * v_t / 0.02 * 0.02 a few times.
    CHECK(length(mass.velocities()[1] - terminal) < 8 * 6.0 * epsilon<Real>);

    mass.set(Points(2, glm::dvec3(0.0)), {{}, {1.0, 2.0, 3.0}});
    mass.advance(0.01, 2000);  // 0.98^2000 = 3e-18 of the beginning is left
    // The increment stalls where dt |a| < eps v/2: that is eps v/2 / 0.02 = 25 eps v short of it.
    CHECK(length(mass.velocities()[1] - terminal) < 30 * 8.0 * epsilon<Real>);
}

TEMPLATE_LIST_TEST_CASE("Friction on the mass slows it as drag in still air does", "[physics]", AllCases) {
    using Sheet = Sheet<typename TestType::Real, typename TestType::Method>;
    Setting dragged = oscillator(0.01, 100.0, 0.2), rubbed = dragged;
    dragged.drag = 0.03;
    rubbed.drag = 0.01, rubbed.friction = 0.02;
    const Points x{{0, 0, 0}, {2.01, 0.1, 0}}, v{{}, {0.1, 0.2, 0.3}};
    Sheet a(dragged, x, v), b(rubbed, x, v);
    a.advance(1e-3, 100), b.advance(1e-3, 100);
    // Both fold to one rate, whose last bit may differ: 1 eps of drag's own effect, below 100 eps of 2 m.
    CHECK(distance(a.positions(), b.positions()) < 200 * epsilon<typename TestType::Real>);
    CHECK(length(a.velocities()[1]) > 0.0);
}

TEMPLATE_LIST_TEST_CASE("Free fall is off by half a step's fall, to either side", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    Setting s = oscillator(0.01, 0.0, {});
    s.gravity = {0.0, -9.81, 0.0};
    Sheet<Real, typename TestType::Method> mass(s);
    mass.advance(0.01, 100);
    // g t^2/2 -+ g t dt/2 with t = 1 s
    const double fallen = std::is_same_v<typename TestType::Method, ForwardEuler> ? 4.85595 : 4.95405;
    CHECK(std::abs(-mass.positions()[1].y - fallen) < 100 * 10.0 * epsilon<Real>);  // 100 sums of numbers below 10
    CHECK(mass.positions()[1].x == rest);
    CHECK(mass.positions()[0] == glm::dvec3(0.0));  // attached: stays
}

TEMPLATE_LIST_TEST_CASE("A sheet in free fall keeps every spring's length, however stiff", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    for (const double k : {200.0, 1e5, 1e8}) {
        Setting s{.grid = spread(9, 6, 0.8, 0.5), .material = {0.01, k, 0.5 * k, {}}, .gravity = {0.0, -9.81, 0.0}};
        // Forward Euler lets every rounding grow by 1 + (omega dt)^2/2 a step; a twentieth of the limit keeps that 1.5.
        const double share = std::is_same_v<typename TestType::Method, ForwardEuler> ? 0.05 : 0.9;
        const double dt = share * largest_step(SemiImplicitEuler{}, s.rates());
        Sheet<Real, typename TestType::Method> sheet(s);
        sheet.advance(dt, 200);
        double worst = 0.0;
        for_each_spring(s.grid, s.material, [&](int i, int j, int i2, int j2, double, double at_rest) {
            const double l = length(sheet.cloth.position(i2, j2) - sheet.cloth.position(i, j));
            worst = std::max(worst, std::abs(l - at_rest) / at_rest);
        });
        // Each step rounds coordinates up to 0.8 m by eps/2 m, at both ends of a spring of 0.1 m (8 eps of its length
        // at most, 3 on average), and each of a mass's eight pulls by 2 eps k L, moving it by 0.4 * 2 * sqrt(8) eps L.
        // 200 undamped steps pile these 4 eps up like a random walk, 1/sin(theta) = 1.3 times: 75 eps, and the worst
        // of a hundred springs is some three to five of these away.
        CHECK(worst < 5.0 * 75.0 * epsilon<Real>);
    }
}
