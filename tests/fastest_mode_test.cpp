// Fastest mode: the limit of stability here and now, followed by one look for thirty steps, against the exact one:
// semi-implicit Euler is stable where 4M - dt^2 K - 2dt C is positive definite, leapfrog where 4M - dt^2 K - 4dt C is,
// with C of the springs' dampers alone (all exact for damping as a multiple of stiffness; see stability_test.cpp).
#include "catch.hpp"
#include "physics_reference.hpp"
#include "physics_sheet.hpp"

#include "drapeau/fastest_mode.hpp"

using namespace drapeau;
using namespace drapeau::testing;

namespace {

/// A small flag in gusts; dampers are tau times springs.
Model flag(double tau, double drag, Borders borders = Borders::alike) {
    std::optional<double> c;
    if (tau > 0.0) c = 800.0 * tau;
    return Model(spread(9, 6, 0.5, 0.3), {0.0005, 800.0, 400.0, c}, Attach::hoist,
                 Terms()
                     .add(Gravity{})
                     .add(AirDrag{drag})
                     .add(Wind{.velocity = {6.0, 0.0, 1.0}, .gusts = {2.0, 0.5, 2.0}, .period = 0.4}),
                 {}, borders);
}

double exact_limit(SemiImplicitEuler, const Reference& reference, const Points& x, double bound) {
    return last_where(0.5 * bound, 3.0 * bound, [&](double dt) {
        return reference.combined(x, 4.0, -dt * dt, -2.0 * dt, -2.0 * dt).is_positive_definite();
    });
}
double exact_limit(Leapfrog, const Reference& reference, const Points& x, double bound) {
    return last_where(0.5 * bound, 3.0 * bound, [&](double dt) {
        return reference.combined(x, 4.0, -dt * dt, -4.0 * dt, 0.0).is_positive_definite();
    });
}
double exact_limit(Rk4, const Reference& reference, const Points& x, double) {
    return 2.0 * std::sqrt(2.0) / std::sqrt(reference.max_eigenvalue(x));  // without damping
}

}  // namespace

TEMPLATE_LIST_TEST_CASE(
    "The limit found by one look for thirty steps stays within 5 % of the exact one as a flag moves", "[physics]",
    AllCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    if constexpr (has_live_limit<Method>) {
        const bool undamped = std::is_same_v<Method, Rk4>;
        for (const double tau : {0.0, 2e-5, 2e-4})
            for (const Borders borders : {Borders::alike, Borders::light}) {
                if (undamped && tau > 0.0) continue;
                const Model model = flag(tau, undamped ? 0.0 : 0.001, borders);
                const Reference reference(model, borders);
                const double bound = stable_step(Method{}, model).seconds();
                Sheet<Real, Method> sheet(model, scattered(model.grid, 0.002), at_rest(model));
                sheet.advance(0.5 * bound, static_cast<long long>(0.3 / (0.5 * bound)));  // it flies
                FastestMode<Real> mode;
                const auto look = [&](int looks) {
                    const auto found = mode.look(sheet.stepper, Method::damping_weight, Method::on_mass_weight,
                                                 1.2 * bound, looks, 0.0);
                    return exact_step(Method{}, found).seconds();
                };
                const auto exact = [&] { return exact_limit(Method{}, reference, sheet.positions(), bound); };
                look(10);
                for (int looks = 0; looks < 80; ++looks) {
                    sheet.advance(0.5 * bound, 30);
                    const double found = look(1);
                    if (looks % 20 != 19) continue;
                    const double ratio = found / exact();
                    INFO("tau " << tau << " s, look " << looks);
                    CHECK(ratio < 1.05);
                    // A lower bound of the eigenvalue is an upper one of the step, but for the precision.
                    CHECK(ratio > 1.0 - 100.0 * epsilon<Real>);
                }
                // Looked at for long enough it is exact.
                CHECK(look(2000) == Approx(exact()).epsilon(1e-3));
            }
    }
}

TEST_CASE("The limit here and now is never below the closed bound", "[physics]") {
    // Folded on one line the flag reaches the bound; anywhere else it stays above it.
    const Model model = flag(0.0, 0.0);
    const double bound = stable_step(SemiImplicitEuler{}, model).seconds();
    for (const double size : {0.0, 0.02, 0.2}) {
        Sheet<double, SemiImplicitEuler> sheet(model, scattered(model.grid, size), at_rest(model));
        FastestMode<double> mode;
        const auto found = mode.look(sheet.stepper, 2.0, 2.0, bound, 300, 0.0);
        CHECK(exact_step(SemiImplicitEuler{}, found).seconds() > bound);
    }
}

TEST_CASE("A flat sheet of light borders swings fastest at 4(k + kd)/m and little more, a single cell at (4k + 8kd)/m",
          "[physics]") {
    // The endless lattice's fastest wave has 4(k + kd); free corners, a quarter as heavy, are a little faster; one cell
    // on its own has 4k + 8kd, where kd >= k/2 the most that any sheet made of such cells can have.
    const auto fastest = [](int cells, double kd, double longer) {  // m omega^2 where k = 1 N/m
        const Model model({cells + 1, cells + 1, 0.1, 0.1}, {1.0, 1.0, kd, {}}, Attach::none, {}, {}, Borders::light);
        auto x = scattered(model.grid, 0.0);
        for (auto& p : x) p *= longer;
        Sheet<double, SemiImplicitEuler> sheet(model, x, at_rest(model));
        FastestMode<double> mode;
        return mode.look(sheet.stepper, 2.0, 2.0, 0.1, 2000, 0.0).stiffness;
    };
    for (const double kd : {1.0, 0.5, 0.1}) {
        CHECK(fastest(1, kd, 1.0) == Approx(4.0 + 8.0 * kd).epsilon(1e-6));
        CHECK(fastest(11, kd, 1.0) > 4.0 * (1.0 + kd) * (1.0 - 0.02));
        CHECK(fastest(11, kd, 1.0) < 4.0 * (1.0 + kd) * (1.0 + 0.06));
    }
    // What an independent program found for kd = k
    CHECK(fastest(2, 1.0, 1.0) == Approx(8.96).margin(0.005));
    CHECK(fastest(11, 1.0, 1.0) == Approx(8.41).margin(0.005));
    CHECK(fastest(11, 1.0, 1.1) == Approx(8.66).margin(0.01));
}

TEMPLATE_LIST_TEST_CASE("Past its limit a method multiplies a mode as it says, and at the limit it begins to",
                        "[physics]", DoubleCases) {
    using Method = typename TestType::Method;
    if constexpr (requires { Method::growth(Oscillator{}, 1.0); }) {
        for (const double c : {0.0, 0.02}) {
            const double m = 0.01, k = 100.0;
            std::optional<double> damping;
            if (c > 0.0) damping = c;
            const Model model(spread(2, 1, 2.0, 1.0), {m, k, damping, damping}, Attach::hoist);
            const Oscillator mode{m, k, c, 0.0};
            const double past = Method::order == 4 ? 1.02 : 1.002;
            const double dt = past * exact_step(Method{}, mode).seconds();
            Sheet<double, Method> mass(model, {{0, 0, 0}, {2.0 + 1e-9, 0, 0}}, Points(2, glm::dvec3(0.0)));
            const auto size = [&] {
                return std::hypot(mass.positions()[1].x - 2.0, mass.stored_velocities()[1].x / std::sqrt(k / m));
            };
            mass.advance(dt, 40);  // the growing part alone is left
            const double before = size();
            constexpr int steps = 24;
            mass.advance(dt, steps);
            // A mode that turns as it grows is seen at two phases, up to a factor of about 2 over 24 steps; lengths of
            // 2 m are known to 4e-16 m of some 1e-8.
            const double tolerance = Method::order == 4 ? 0.03 : 0.002;
            CHECK(std::pow(size() / before, 1.0 / steps) == Approx(Method::growth(mode, dt)).epsilon(tolerance));
            CHECK(Method::growth(mode, dt) > 1.0);
            if (std::is_same_v<Method, SemiImplicitEuler> || Method::order == 4)
                CHECK(Method::growth(mode, dt / past * 0.999) <= 1.0 + 1e-9);
        }
    }
    // "8 steps at 1 %, 81 at 1e-4", ln 10 / (2 sqrt(2 eps))
    if constexpr (std::is_same_v<Method, SemiImplicitEuler>) {
        const Oscillator mode{1.0, 1.0, 0.0, 0.0};
        CHECK(std::log(10.0) / std::log(Method::growth(mode, 2.0 * 1.01)) == Approx(8.1).epsilon(0.02));
        CHECK(std::log(10.0) / std::log(Method::growth(mode, 2.0 * 1.0001)) == Approx(81.4).epsilon(0.01));
    }
}
