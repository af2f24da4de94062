// Chains: one row or one column of masses, for which statics has simple exact answers.
#include "catch.hpp"
#include "closed_forms.hpp"

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

/// A chain that hangs from its top, N springs of length l each; the lowest mass is a share `end` of the others. It
/// swings sideways at omega^2 = x g/l where shape(x, N) = 0: with the tension (n + end) m g above the mass with n
/// masses below it and (n - 1 + end) m g below it,
///   (n + end) (u_{n+1} - u_n) = (n - 1 + end) (u_n - u_{n-1}) - x u_n,    the lowest: end (u_1 - u_0) = -x end u_0.
/// For end = 1 that is the recurrence of Laguerre's polynomials, u_n = L_n(x).
std::vector<double> swinging_shape(double x, int springs, double end) {
    std::vector<double> u{1.0};
    for (int n = 0; n < springs; ++n) {
        const double below = n > 0 ? (n - 1 + end) * (u[n] - u[n - 1]) : 0.0;
        u.push_back(u[n] + (below - x * (n > 0 ? 1.0 : end) * u[n]) / (n + end));
    }
    return u;
}
/// The slowest swing's x: the support's place is the first where the shape is zero.
double slowest_swing(int springs, double end) {
    double low = 0.0, high = 2.0 / springs;  // 1.45/N for a rope
    while (high - low > 1e-15 * high) {
        const double middle = 0.5 * (low + high);
        (swinging_shape(middle, springs, end).back() > 0.0 ? low : high) = middle;
    }
    return low;
}

/// The angular frequency (1/s) at which a hanging chain, set in this shape sideways, is seen to swing.
double seen_swinging(int springs, double length, double stiffness, Borders borders, const std::vector<double>& shape,
                     double guess) {
    const double m = 0.1 / springs, l = length / springs, end = borders == Borders::light ? 0.5 : 1.0;
    const Model model(spread(1, springs + 1, 0.0, length), {m, stiffness, {}, {}}, Attach::top, Terms().add(down), {},
                      borders);
    // Each spring stretched by what it carries; across by 1e-6 of l at most.
    Points x{glm::dvec3(0.0)};
    for (int n = springs - 1; n >= 0; --n)
        x.push_back({1e-6 * l * shape[n], x.back().y - l - (n + end) * m * g / stiffness, 0.0});
    Sheet<double, Leapfrog> chain(model, x, at_rest(model));
    // A quarter of the swing's time: the share of the shape that is left is cos(omega t), seen where it falls fastest.
    const double dt = 0.8 * std::sqrt(m * (borders == Borders::light ? 0.5 : 1.0) / stiffness);
    const auto steps = std::llround(0.4 * 3.141592653589793 / guess / dt);
    chain.advance(dt, steps);
    const auto now = chain.positions();
    double left = 0.0, whole = 0.0;
    for (int n = 0; n < springs; ++n) {
        const double share = n > 0 ? 1.0 : end;
        left += share * shape[n] * now[springs - n].x, whole += share * shape[n] * x[springs - n].x;
    }
    // Leapfrog's own frequency is larger by (omega dt)^2/24, 1e-8 or less here.
    return std::acos(left / whole) / (static_cast<double>(steps) * dt);
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

TEMPLATE_LIST_TEST_CASE("In steady wind a chain hangs straight, at tan(angle) = w/v_t from the vertical", "[physics]",
                        DoubleCases) {
    // Every mass is pulled by m g_eff, g_eff = g + (d/m) w; at rest each spring carries what hangs below it.
    using Method = typename TestType::Method;
    if (std::is_same_v<Method, Xpbd>) return;  // too soft by nature: solvers_test.cpp
    constexpr int springs = 6;
    const double m = 0.01, k = 20.0, v_t = 2.0, d = m * g / v_t;
    for (const auto& [w, degrees] : {std::pair{2.0, 45.0}, {5.0, 68.2}, {10.0, 78.7}, {15.0, 82.4}}) {
        const Model model(spread(1, springs + 1, 0.0, 0.3), {m, k, {}, {}}, Attach::top,
                          Terms().add(down).add(AirDrag{d}).add(Wind{.velocity = {0.0, 0.0, w}}));
        const double angle = std::atan(w / v_t);
        CHECK(angle * 180.0 / 3.141592653589793 == Approx(degrees).margin(0.05));
        const glm::dvec3 along{0.0, -std::cos(angle), std::sin(angle)};
        Sheet<double, Method> chain(model);
        // exp(-d/2m t) = exp(-2.45/s * 10 s) = 2e-11 is left. Forward Euler takes k dt from what damps: at half its
        // limit half of it is left.
        const bool forward = std::is_same_v<Method, ForwardEuler>;
        const double dt = (forward ? 0.6 : 1.0) * settling_step<Method>(model), seconds = forward ? 20.0 : 10.0;
        chain.advance(dt, static_cast<long long>(seconds / dt));
        double far = 0.0;
        for (int j = 1; j <= springs; ++j) {
            far += 0.05 + (springs - j + 1) * m * std::hypot(g, d / m * w) / k;
            INFO("wind " << w << " m/s, mass " << j);
            CHECK(length(chain.positions()[j] - far * along) < 1e-10);
        }
    }
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

TEMPLATE_LIST_TEST_CASE("A chain held at both ends swings along itself with 2 sqrt(k/m) sin(p pi/2N)", "[physics]",
                        ClosedFormDouble) {
    using Method = typename TestType::Method;
    if constexpr (!std::is_same_v<Method, Xpbd>) {  // solves springs one by one: no closed form
        // Forward Euler's grow by sqrt(2) a step where omega dt = 1: by 32 in ten steps.
        constexpr bool grows = std::is_same_v<Method, ForwardEuler>;
        constexpr int springs = 10, steps = grows ? 10 : 40;
        const double m = 0.02, k = 50.0, l = 0.1, size = grows ? 3e-4 : 0.01;
        // Dampers are a multiple of springs: every mode is an oscillator of its own with them too.
        for (const auto c : {std::optional<double>(), std::optional(0.05)})
            for (const bool standing : {false, true}) {
                Model model({standing ? 1 : springs + 1, standing ? springs + 1 : 1, l, l}, {m, k, {}, c},
                            Attach::none);
                model.hold(0, 0);
                model.hold(standing ? 0 : springs, standing ? springs : 0);
                for (int p = 1; p < springs; ++p) {
                    const double sine = std::sin(p * 3.141592653589793 / (2.0 * springs));
                    const double stiffness = 4.0 * k * sine * sine;  // m omega^2
                    const auto displaced = [&](double by) {
                        auto x = scattered(model.grid, 0.0);
                        for (int n = 1; n < springs; ++n)
                            (standing ? x[n].y : x[n].x) += by * std::sin(n * p * 3.141592653589793 / springs);
                        return x;
                    };
                    Sheet<double, Method> chain(model, displaced(size), at_rest(model));
                    const double dt = 0.5 * std::sqrt(m / k);  // omega dt = 1 for the fastest
                    chain.advance(dt, steps);
                    const double at =
                        motion(Method{}, m, stiffness, c.value_or(0.0) * stiffness / k, false, size, dt, steps);
                    INFO("p " << p << ", damped " << c.has_value() << ", standing " << standing);
                    // Springs stay in line, so they are linear. Lengths are known to eps of 1 m; a step's force passes
                    // that on with a <= 1, kept for all steps.
                    CHECK(distance(chain.positions(), displaced(at)) <
                          (grows ? 32.0 : 2.0) * Method::passes * steps * epsilon<double>);
                }
            }
    }
}

TEST_CASE("A hanging chain swings sideways at the zeros of Laguerre's polynomials", "[physics]") {
    // omega^2 = x g/l. Springs so stiff that none is longer by more than a millionth: omega is off by half that.
    const double root = std::sqrt(2.0), l = 0.2;
    for (const auto& zeros : {std::vector{2.0 - root, 2.0 + root}, {0.26356, 1.41340, 3.59643}}) {
        const int springs = zeros.size() == 2 ? 2 : 5;  // of five, the three slowest
        for (const double x : zeros) {
            const auto shape = swinging_shape(x, springs, 1.0);
            CHECK(std::abs(shape.back()) < 1e-4);  // the zero is typed in rightly
            const double omega = std::sqrt(x * g / l);
            CHECK(seen_swinging(springs, springs * l, 1e6, Borders::alike, shape, omega) ==
                  Approx(omega).epsilon(1e-5));  // zeros as given to five places
        }
    }
}

TEST_CASE("A hanging band swings as a rope, sqrt(g/L) j_0/2, to order 2 of its grid with half a mass at its end",
          "[physics]") {
    // j_0 = 2.404826 is the first zero of Bessel's J_0. A whole mass at the end makes it order 1.
    const double L = 1.0, rope = 0.5 * 2.404826 * std::sqrt(g / L);
    std::vector<double> light, alike;
    for (const int springs : {5, 10, 20, 40})
        for (const Borders borders : {Borders::light, Borders::alike}) {
            if (springs == 40 && borders == Borders::alike) continue;
            const double x = slowest_swing(springs, borders == Borders::light ? 0.5 : 1.0);
            const double omega = std::sqrt(x * g * springs / L);
            // The band is longer by m g/2EA = 2.5e-6 of itself, its swing slower by about half that.
            const double seen = seen_swinging(springs, L, 2e5 * springs, borders,
                                              swinging_shape(x, springs, borders == Borders::light ? 0.5 : 1.0), omega);
            CHECK(seen == Approx(omega).epsilon(2.5e-6));
            (borders == Borders::light ? light : alike).push_back(rope - seen);
        }
    // What an independent program found, as given
    const double light_off[] = {0.0439, 0.0111, 0.00279, 0.00070}, alike_off[] = {0.171, 0.0894, 0.0459};
    for (int n = 0; n < 4; ++n) CHECK(light[n] == Approx(light_off[n]).margin(1e-5 + 0.005 * light_off[n]));
    for (int n = 0; n < 3; ++n) CHECK(alike[n] == Approx(alike_off[n]).epsilon(0.005));
    for (int n = 0; n < 3; ++n) CHECK(std::log2(light[n] / light[n + 1]) == Approx(2.0).margin(0.1));
    for (int n = 0; n < 2; ++n) CHECK(std::log2(alike[n] / alike[n + 1]) == Approx(1.0).margin(0.1));
}
