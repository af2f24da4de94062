// One mass: on a spring, in the wind, falling. Everything here has a closed form, of the equation and of the method.
#include "catch.hpp"
#include "closed_forms.hpp"
#include "physics_sheet.hpp"

using namespace drapeau;
using namespace drapeau::testing;

namespace {

constexpr double rest = 2.0;  // m, of the spring: longer than any swing below

/// A mass on a spring along x, its other end held.
Model oscillator(double m, double k, std::optional<double> c, const Terms& terms = {}) {
    return Model(spread(2, 1, rest, 1.0), {m, k, {}, c}, Attach::hoist, terms);
}

template <class Real, class Method>
struct Displaced : Sheet<Real, Method> {
    Displaced(const Model& model, double x0)
        : Sheet<Real, Method>(model, {{0, 0, 0}, {rest + x0, 0, 0}}, Points(2, glm::dvec3(0.0))) {}
    double x() const { return this->positions()[1].x - rest; }
};

/// m x'' = -k x - c x', released at x0: the solution of the equation.
double damped_oscillation(double m, double k, double c, double x0, double t) {
    const double gamma = c / (2.0 * m), omega = std::sqrt(k / m - gamma * gamma);
    return std::exp(-gamma * t) * x0 * (std::cos(omega * t) + gamma / omega * std::sin(omega * t));
}

const glm::dvec3 terminal{6.0, 0.0, -4.905};

/// A mass on its own in wind and gravity, its spring of no stiffness.
Model projectile() {
    return oscillator(
        0.01, 0.0, {},
        Terms().add(Gravity{{0.0, 0.0, -9.81}}).add(AirDrag{0.02}).add(Wind{.velocity = {6.0, 0.0, 0.0}}));
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("A damped oscillator follows its equation with the method's order", "[physics]", DoubleCases) {
    using Method = typename TestType::Method;
    const double m = 0.01, k = 100.0, c = 0.2, x0 = 0.01, end = 0.05;
    const double exact = damped_oscillation(m, k, c, x0, end);
    CHECK(exact == Approx(9.855066761858644e-4).epsilon(1e-12));  // the closed form is typed in rightly

    for (const bool drag : {false, true}) {
        const Model model = drag ? oscillator(m, k, {}, Terms().add(AirDrag{c})) : oscillator(m, k, c);
        std::vector<double> errors;
        // Of order 4 the error is 1e-9 m at 50 steps, far above rounding, and 1e-15 m at 1600, which is not.
        const int coarsest = Method::order == 4 ? 50 : 800;
        for (const int steps : {coarsest, 2 * coarsest, 4 * coarsest}) {
            Displaced<double, Method> mass(model, x0);
            mass.advance(end / steps, steps);
            errors.push_back(std::abs(mass.x() - exact));
        }
        for (int n = 0; n < 2; ++n) {
            const double order = std::log2(errors[n] / errors[n + 1]);
            CHECK(order > Method::order - 0.1);
            CHECK(order < Method::order + 0.1);
        }
    }
}

TEMPLATE_LIST_TEST_CASE("A method's motion of an oscillator is its own closed form", "[physics]", ClosedFormCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    const double m = 0.01, k = 100.0, dt = 0.005;  // omega dt = 0.5
    // The spring's length of about 2 m is known to one unit in the last place (eps * 2 m); a step's force passes it on
    // with a = 0.25, and an undamped oscillation keeps every step's error at most 1/sin(theta) = 2.1 times as large:
    // over n steps 2 * 0.25 * 2.1 * n eps, as much again from storing x; four evaluations do it four times.
    const double rounding = 4.0 * Method::passes * epsilon<Real>;

    // Forward Euler grows by sqrt(1.25) a step: 20 steps, 1000 for the others.
    const int steps = std::is_same_v<Method, ForwardEuler> ? 20 : 1000;
    Displaced<Real, Method> undamped(oscillator(m, k, {}), std::is_same_v<Method, ForwardEuler> ? 0.05 : 1.0);
    const double x0 = undamped.x();
    undamped.advance(dt, steps);
    const double growth = std::is_same_v<Method, ForwardEuler> ? std::pow(1.25, 0.5 * steps) : 1.0;
    CHECK(std::abs(undamped.x() - motion(Method{}, m, k, 0.0, false, x0, dt, steps)) < steps * rounding * growth);

    for (const bool drag : {false, true}) {
        const double c = 0.2;
        const Model model = drag ? oscillator(m, k, {}, Terms().add(AirDrag{c})) : oscillator(m, k, c);
        Displaced<Real, Method> damped(model, 0.01);
        damped.advance(1e-3, 50);
        CHECK(std::abs(damped.x() - motion(Method{}, m, k, c, drag, 0.01, 1e-3, 50)) < 50 * rounding);
        CHECK(damped.positions()[1].y == 0.0);
        CHECK(damped.positions()[1].z == 0.0);
    }
}

TEST_CASE("The closed forms are what an independent program computed", "[physics]") {
    CHECK(motion(SemiImplicitEuler{}, 0.01, 100.0, 0.0, false, 1.0, 0.005, 1000) ==
          Approx(-1.015507490276).epsilon(1e-12));
    CHECK(motion(SemiImplicitEuler{}, 0.01, 100.0, 0.2, false, 0.01, 1e-3, 50) == Approx(1.43064503e-3).epsilon(1e-8));
    // Leapfrog without damping is cos(n theta) with cos(theta) = 1 - (omega dt)^2/2: theta/dt = 101.0721020568/s.
    CHECK(motion(Leapfrog{}, 0.01, 100.0, 0.0, false, 1.0, 0.005, 1000) ==
          Approx(std::cos(101.0721020568 * 5.0)).epsilon(1e-9));
}

TEST_CASE("Semi-implicit Euler conserves its shadow energy, and the plain energy swings about it", "[physics]") {
    const double m = 0.01, k = 100.0, dt = 0.005;  // omega dt = 0.5
    Displaced<double, SemiImplicitEuler> mass(oscillator(m, k, {}), 1.0);
    const double initial = 0.5 * k;
    double lowest = 1e9, highest = 0.0, drift = 0.0, lowest_now = 1e9, highest_now = 0.0;
    for (int n = 0; n < 2000; ++n) {
        mass.advance(dt, 1);
        const double x = mass.x(), v = mass.stored_velocities()[1].x;
        const double energy = 0.5 * m * v * v + 0.5 * k * x * x;
        drift = std::max(drift, std::abs(energy - 0.5 * dt * k * x * v - initial) / initial);
        lowest = std::min(lowest, energy / initial), highest = std::max(highest, energy / initial);
        const double v_now = v - 0.5 * dt * k / m * x;  // half a kick further: at the position's time
        const double energy_now = 0.5 * m * v_now * v_now + 0.5 * k * x * x;
        lowest_now = std::min(lowest_now, energy_now / initial),
        highest_now = std::max(highest_now, energy_now / initial);
    }
    // 2000 steps, each a few roundings of a length of up to 3.2 m by eps/2, which add up like a random walk: 2000^(1/2)
    // times 4 eps.
    CHECK(drift < 45 * 4 * epsilon<double>);
    // Extremes H/I = 1/(1 +- omega dt/2); a thousand phases come within 1e-3 of them.
    CHECK(lowest == Approx(0.8).epsilon(1e-3));
    CHECK(highest == Approx(4.0 / 3.0).epsilon(1e-3));
    // With I = H - (dt/2)^2 k^2 x^2/2m: from 1 where x = 0 to 1/(1 - (omega dt/2)^2) where v = 0.
    CHECK(lowest_now == Approx(1.0).epsilon(1e-3));
    CHECK(highest_now == Approx(1.0 / (1.0 - 0.0625)).epsilon(1e-3));
}

TEMPLATE_LIST_TEST_CASE("A mass in wind follows the method's closed form", "[physics]", ClosedFormCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    const glm::dvec3 v0{1.0, 2.0, 3.0};
    const double dt = 0.01, b = 0.02 * dt / 0.01;
    const int n = 50;
    Sheet<Real, Method> mass(projectile(), Points(2, glm::dvec3(0.0)), {{}, v0});
    mass.advance(dt, n);

    // v_n = v_t + (v0 - v_t) r^n, and x_n = n dt v_t + (v0 - v_t) q (1 - r^n), q dt (1 + r + ... + r^{n-1}) being where
    // the method gets to. Forward Euler moves by the velocities one step earlier than semi-implicit Euler; Runge-Kutta
    // multiplies by the series of exp(-b) and integrates by that of its integral; leapfrog's stored velocity, which
    // moves, starts with v- = (1 + b/2) v0 - dt/2 a, so v+ = v_t + (1 - b/2) (v0 - v_t), and goes on by
    // r = (1 - b/2)/(1 + b/2); synchronised, v = (v- + v+)/2 = (v+ - v_t)/(1 - b/2) + v_t.
    double r = 1.0 - b, q = 1.0;
    if constexpr (std::is_same_v<Method, SemiImplicitEuler>) q = r;
    if constexpr (std::is_same_v<Method, Leapfrog>) r = (1.0 - 0.5 * b) / (1.0 + 0.5 * b), q = 1.0 - 0.5 * b;
    if constexpr (Method::solves) r = q = 1.0 / (1.0 + b);  // moved by the velocity at the step's end
    if constexpr (std::is_same_v<Method, Rk4>)
        r = 1.0 - b * (1.0 - b / 2.0 * (1.0 - b / 3.0 * (1.0 - b / 4.0))), q = (1.0 - r) / b;
    const double left = std::pow(r, n);
    const glm::dvec3 v = terminal + (v0 - terminal) * left;
    const glm::dvec3 x = n * dt * terminal + dt * q * (v0 - terminal) * (1.0 - left) / (1.0 - r);
    if constexpr (std::is_same_v<Method, SemiImplicitEuler>) {
        CHECK(x.x == Approx(1.44221572).epsilon(1e-8));
        CHECK(x.y == Approx(0.62311371).epsilon(1e-8));
        CHECK(x.z == Approx(0.01035695).epsilon(1e-6));
    }
    if constexpr (Method::order == 4) CHECK(length(x - glm::dvec3{1.4196986, 0.63212056, 0.04595651}) < 1e-7);
    // Every evaluation rounds v (up to 6 m/s) and x (up to 3 m) a few times by eps/2.
    CHECK(length(mass.velocities()[1] - v) < 2 * n * Method::passes * 6.0 * epsilon<Real>);
    CHECK(length(mass.positions()[1] - x) < 2 * n * Method::passes * 3.0 * epsilon<Real>);
}

TEMPLATE_LIST_TEST_CASE("The terminal velocity is a fixed point of every method", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    Sheet<Real, typename TestType::Method> mass(projectile(), Points(2, glm::dvec3(0.0)), {{}, terminal});
    mass.advance(0.01, 2000);
    // Drag pulls every rounding back at once (d dt/m = 0.02): what is left is eps * v_t / 0.02 * 0.02 a few times.
    CHECK(length(mass.velocities()[1] - terminal) < 8 * 6.0 * epsilon<Real>);

    mass.set(Points(2, glm::dvec3(0.0)), {{}, {1.0, 2.0, 3.0}});
    mass.advance(0.01, 2000);  // 0.98^2000 = 3e-18 of the beginning is left
    // The increment stalls where dt |a| < eps v/2: that is eps v/2 / 0.02 = 25 eps v short of it. XPBD rounds three
    // times as often: by dt to a displacement and back to a velocity.
    const double roundings = std::is_same_v<typename TestType::Method, Xpbd> ? 3.0 : 1.0;
    CHECK(length(mass.velocities()[1] - terminal) < roundings * 30 * 8.0 * epsilon<Real>);
}

TEMPLATE_LIST_TEST_CASE("Drag settles a velocity by the method's own factor a step, up to its limit", "[physics]",
                        ClosedFormDouble) {
    // What is left of v - v_t a step, with b = d dt/m: 1 - b of forward and semi-implicit Euler, (1 - b/2)/(1 + b/2) of
    // leapfrog, 1/(1 + b) of methods that solve, the series of exp(-b) of Runge-Kutta.
    using Method = typename TestType::Method;
    constexpr bool centred = std::is_same_v<Method, Leapfrog>, series = std::is_same_v<Method, Rk4>;
    for (const double b : {0.5, 0.99, 1.01, 1.9, 1.99, 2.01, 2.1, 2.7, 2.78, 2.79, 3.0, 10.0}) {
        double left = 1.0 - b;
        if (centred) left = (1.0 - 0.5 * b) / (1.0 + 0.5 * b);
        if (Method::solves) left = 1.0 / (1.0 + b);
        if (series) left = 1.0 - b * (1.0 - b / 2.0 * (1.0 - b / 3.0 * (1.0 - b / 4.0)));
        const double limit = series ? 2.7853 : Method::solves || centred ? INFINITY : 2.0;
        CHECK((std::abs(left) < 1.0) == (b < limit));  // the table of limits' real axis
        const Model model =
            oscillator(0.01, 0.0, {}, Terms().add(AirDrag{0.02}).add(Wind{.velocity = {6.0, 0.0, 0.0}}));
        Sheet<double, Method> mass(model, Points(2, glm::dvec3(0.0)), {{}, {1.0, 0.0, 0.0}});
        double before = 1.0 - 6.0;
        for (int n = 0; n < 10; ++n) {
            mass.advance(b * 0.01 / 0.02, 1);
            const double now = mass.velocities()[1].x - 6.0;
            INFO("d dt/m " << b << ", step " << n);
            CHECK(std::abs(now - left * before) < 16.0 * (6.0 + std::abs(now)) * (1.0 + b) * epsilon<double>);
            before = now;
        }
    }
}

TEMPLATE_LIST_TEST_CASE("Friction on the mass slows it as drag in still air does", "[physics]", AllCases) {
    using Sheet = Sheet<typename TestType::Real, typename TestType::Method>;
    const Points x{{0, 0, 0}, {2.01, 0.1, 0}}, v{{}, {0.1, 0.2, 0.3}};
    Sheet a(oscillator(0.01, 100.0, 0.2, Terms().add(AirDrag{0.03})), x, v),
        b(oscillator(0.01, 100.0, 0.2, Terms().add(AirDrag{0.01}).add(Friction{0.02})), x, v);
    a.advance(1e-3, 100), b.advance(1e-3, 100);
    // Both are one rate, whose last bit may differ: 1 eps of drag's own effect, below 100 eps of 2 m.
    CHECK(distance(a.positions(), b.positions()) < 200 * epsilon<typename TestType::Real>);
    CHECK(length(a.velocities()[1]) > 0.0);
}

TEMPLATE_LIST_TEST_CASE("Free fall is off by half a step's fall at order 1 and exact above", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    Sheet<Real, Method> mass(oscillator(0.01, 0.0, {}, Terms().add(Gravity{{0.0, -9.81, 0.0}})));
    mass.advance(0.01, 100);
    // g t^2/2 -+ g t dt/2 with t = 1 s
    const double fallen = std::is_same_v<Method, ForwardEuler> ? 4.85595 : Method::order == 1 ? 4.95405 : 4.905;
    // As many sums of numbers below 10 as there are evaluations
    CHECK(std::abs(-mass.positions()[1].y - fallen) < 100 * Method::passes * 10.0 * epsilon<Real>);
    CHECK(std::abs(mass.velocities()[1].y + 9.81) < 100 * Method::passes * 10.0 * epsilon<Real>);
    CHECK(mass.positions()[1].x == rest);
    CHECK(mass.positions()[0] == glm::dvec3(0.0));  // attached: stays
}

TEMPLATE_LIST_TEST_CASE("A sheet in free fall keeps every spring's length, however stiff", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    for (const double k : {200.0, 1e5, 1e8}) {
        const Model model(spread(9, 6, 0.8, 0.5), {0.01, k, 0.5 * k, {}}, Attach::none,
                          Terms().add(Gravity{{0.0, -9.81, 0.0}}));
        // Forward Euler lets every rounding grow by 1 + (omega dt)^2/2 a step; a twentieth of the limit keeps that 1.5.
        const double share = std::is_same_v<Method, ForwardEuler> ? 0.05 : 0.9;
        const double dt = share * stable_step(SemiImplicitEuler{}, model).seconds();
        Sheet<Real, Method> sheet(model);
        sheet.advance(dt, 200);
        const auto measured = sheet.measure();
        // Each step rounds coordinates up to 0.8 m by eps/2 m, at both ends of a spring of 0.1 m (8 eps of its length
        // at most, 3 on average), and each of a mass's eight pulls by 2 eps k L, moving it by 0.4 * 2 * sqrt(8) eps L.
        // 200 undamped steps pile these 4 eps up like a random walk, 1/sin(theta) = 1.3 times: 75 eps, and the worst
        // of a hundred springs is some three to five of these away.
        CHECK(measured.max_stretch < 5.0 * 75.0 * epsilon<Real>);
        CHECK(measured.mean_stretch < 5.0 * 75.0 * epsilon<Real>);  // of absolute values: none is shorter either
    }
}
