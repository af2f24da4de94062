// Energy: what methods keep and lose of it, and the work that is counted against it.
#include "catch.hpp"
#include "physics_reference.hpp"
#include "physics_sheet.hpp"

#include <complex>

using namespace drapeau;
using namespace drapeau::testing;

namespace {

/// A small cloth on two grommets in gusts: every force, external and internal.
Model cloth(std::optional<double> damping) {
    return Model({5, 4, 0.1, 0.1}, {0.01, 200.0, 100.0, damping}, Attach::grommets,
                 Terms()
                     .add(Gravity{{0.0, -9.81, 0.0}})
                     .add(AirDrag{0.01})
                     .add(Friction{0.005})
                     .add(Wind{{3.0, 0.5, 1.0}, {1.0, 0.5, 1.0}, 1.5, true, 3}));
}

/// One mass on a spring along x: omega = 100/s.
Model oscillator() {
    return Model(spread(2, 1, 2.0, 1.0), {0.01, 100.0, {}, {}}, Attach::hoist);
}
const Points displaced{{0, 0, 0}, {2.01, 0, 0}};

}  // namespace

TEMPLATE_LIST_TEST_CASE("A mode's energy grows or shrinks by the method's own factor", "[physics]", ClosedFormDouble) {
    // With y = omega dt; of the amplitude a step: forward Euler sqrt(1 + y^2), implicit Euler and XPBD, which with one
    // spring are the same, 1/sqrt(1 + y^2), Runge-Kutta
    // (1 - y^6/72 + y^8/576)^(1/2), the staggered methods 1 at any stable step: with v+ - v- = -dt w K x and
    // x' - x = dt v', m v-.v+ / 2 + K x^2 / 2 changes by m v'.(v'' - v)/2 + K (x' + x)(x' - x)/2 = 0.
    using Method = typename TestType::Method;
    const double omega = 100.0;
    for (const double y : {0.1, 0.5, 1.0, 1.5, 1.9, 1.99}) {
        double factor = 1.0;
        if (std::is_same_v<Method, ForwardEuler>) factor = 1.0 + y * y;
        if (Method::solves) factor = 1.0 / (1.0 + y * y);
        if (std::is_same_v<Method, Rk4>) factor = 1.0 - std::pow(y, 6) / 72.0 + std::pow(y, 8) / 576.0;
        Sheet<double, Method> mass(oscillator(), displaced, Points(2, glm::dvec3(0.0)));
        mass.advance(y / omega, 1);
        double before = mass.measure().total();
        const double first = before;
        double worst = 0.0;
        for (int n = 1; n <= (std::is_same_v<Method, ForwardEuler> ? 10 : 1000); ++n) {
            mass.advance(y / omega, 1);
            const double now = mass.measure().total();
            worst = std::max(worst, std::abs(now - factor * before));
            // Near the limit swings grow until the spring turns over; only what is linear is the law's.
            if (now > 10.0 * first) break;
            before = now;
        }
        // Of a length of 2 m, known to 2 eps m, the swing of 0.01 m or more (1/sqrt(1 - y^2/4) = 10 times at most) is
        // known to 100 * 2 eps of itself; energies are squares of it, each a few such numbers, 100 times greater in
        // parts than in all for y = 1.99.
        INFO("omega dt = " << y);
        CHECK(worst < 2000.0 / (1.0 - y * y / 4.0) * epsilon<double> * first);
    }
}

TEMPLATE_LIST_TEST_CASE("A damped mode's amplitude is multiplied by the method's own factor a step", "[physics]",
                        ClosedFormDouble) {
    // The motion of two roots r+ and r- has x_{n+1} x_{n-1} - x_n^2 multiplied by r+ r- a step, the square of the
    // amplitude's factor, whatever its phase. With a = (omega dt)^2 and b = beta dt: forward Euler 1 - b + a,
    // semi-implicit Euler 1 - b, leapfrog under drag (1 - b/2)/(1 + b/2), implicit Euler and XPBD 1/(1 + a + b),
    // Runge-Kutta |R(z)|^2. So forward Euler swings as if its damper were c - k dt, implicit Euler c + k dt.
    using Method = typename TestType::Method;
    const double m = 0.01, k = 100.0, omega = 100.0;
    for (const double y : {0.1, 0.5, 1.0})
        for (const double zeta : {0.0, 0.05, 0.3})
            for (const bool drag : {false, true}) {
                if (std::is_same_v<Method, Leapfrog> && !drag) continue;  // three roots
                const double dt = y / omega, a = y * y, b = 2.0 * zeta * y, c = 2.0 * zeta * omega * m;
                double factor = 1.0 - b;
                if (std::is_same_v<Method, ForwardEuler>) factor = 1.0 - b + a;
                if (std::is_same_v<Method, Leapfrog>) factor = (1.0 - 0.5 * b) / (1.0 + 0.5 * b);
                if (Method::solves) factor = 1.0 / (1.0 + a + b);
                if (std::is_same_v<Method, Rk4>) {
                    const std::complex<double> z = y * std::complex<double>{-zeta, std::sqrt(1.0 - zeta * zeta)};
                    factor = std::norm(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0))));
                }
                Springs springs{m, k, {}, {}};
                if (!drag) springs.damping = c;
                Sheet<double, Method> mass(
                    Model(spread(2, 1, 2.0, 1.0), springs, Attach::hoist, Terms().add(AirDrag{drag ? c : 0.0})),
                    displaced, Points(2, glm::dvec3(0.0)));
                std::vector<double> x{0.01};
                for (int n = 0; n < 12; ++n) {
                    mass.advance(dt, 1);
                    x.push_back(mass.positions()[1].x - 2.0);
                }
                INFO("omega dt " << y << ", zeta " << zeta << ", drag " << drag);
                double size = 1e-4;
                for (int n = 2; n + 1 < 12; ++n) {
                    const double before = x[n] * x[n - 2] - x[n - 1] * x[n - 1];
                    const double now = x[n + 1] * x[n - 1] - x[n] * x[n];
                    // Swings of 0.01 m (forward Euler's grow to 0.6 m) are known to a few eps of 2 m.
                    for (const double one : x) size = std::max(size, one * one);
                    CHECK(std::abs(now - factor * before) < 100.0 * std::sqrt(size) * 2.0 * epsilon<double>);
                }
            }
}

TEST_CASE("Forward Euler's energy grows 4.9e9 times in a hundred steps of half a radian, Runge-Kutta's hardly falls",
          "[physics]") {
    const auto kept = []<class Method>(Method, double swing, double omega_dt, int steps) {
        Sheet<double, Method> mass(oscillator(), {{0, 0, 0}, {2.0 + swing, 0, 0}}, Points(2, glm::dvec3(0.0)));
        const double before = mass.measure().total();
        mass.advance(omega_dt / 100.0, steps);
        return mass.measure().total() / before;
    };
    CHECK(kept(ForwardEuler{}, 1e-5, 0.5, 100) == Approx(std::pow(1.25, 100)).epsilon(1e-8));  // 0.7 m in the end
    CHECK(std::pow(1.25, 100) == Approx(4.9e9).epsilon(0.01));
    // A swing of 1 Hz at 1/60 s keeps 0.9999995 of its amplitude a period.
    const double period = std::sqrt(kept(Rk4{}, 0.01, 2.0 * 3.141592653589793 / 60.0, 60));
    CHECK(1.0 - period == Approx(5e-7).epsilon(0.15));
    CHECK(std::log(period) / 60.0 == Approx(-std::pow(2.0 * 3.141592653589793 / 60.0, 6) / 144.0).epsilon(0.01));
}

TEMPLATE_LIST_TEST_CASE("Without damping a staggered method's energy is constant on a swinging sheet of one mode",
                        "[physics]", DoubleCases) {
    // Small motion about a taut rest: K is constant up to the motion's size, so is the energy up to its cube.
    using Method = typename TestType::Method;
    if constexpr (Method::staggered) {
        const Model model({6, 5, 0.1, 0.1}, {0.01, 200.0, 100.0, {}}, Attach::edges);
        auto taut = scattered(model.grid, 0.0);
        for (auto& p : taut) p *= 1.2;
        const double size = 1e-6;
        auto x = taut;
        const auto off = noise(30, size);
        for (int n = 0; n < 30; ++n)
            if (!is_held(model, n)) x[n] += off[n];
        Sheet<double, Method> sheet(model, x, at_rest(model));
        Sheet<double, Method> still(model, taut, at_rest(model));
        const double dt = 0.9 * stable_step(SemiImplicitEuler{}, model).seconds();
        sheet.advance(dt, 1);
        const double elastic = still.measure().elastic, first = sheet.measure().total() - elastic;
        double worst = 0.0;
        for (int n = 0; n < 300; ++n) {
            sheet.advance(dt, 1);
            worst = std::max(worst, std::abs(sheet.measure().total() - elastic - first));
        }
        // Cubic terms are about size/L of the quadratic ones, and the difference of two energies of `elastic`
        // joules is rounded by a few hundred terms' eps/2.
        CHECK(worst < 10.0 * size / 0.1 * first + 100.0 * epsilon<double> * elastic);
    }
}

TEMPLATE_LIST_TEST_CASE("An accounted step moves as any other", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    for (const auto damping : {std::optional<double>(), std::optional(0.05)}) {
        const Model model = cloth(damping);
        const auto x = scattered(model.grid, 0.02), v = noise(masses_of(model), 0.5);
        Sheet<Real, Method> plain(model, x, v), accounted(model, x, v);
        const int steps = 20;
        const double dt = 1e-3;
        plain.advance(dt, steps);
        for (int n = 0; n < steps; ++n) accounted.accounted_step(dt);
        // Forces are summed in another order, off by 8 eps of what meets at a mass, at most 8 * 300 N/m * 0.3 m: a
        // velocity of dt/m times that, or a position of dt times it, kept for the steps that are left; each evaluation.
        const double kick = 8.0 * epsilon<Real> * 8.0 * 300.0 * 0.3 * dt / model.springs.mass;
        CHECK(distance(plain.positions(), accounted.positions()) < Method::passes * kick * dt * steps * steps);
        CHECK(distance(plain.velocities(), accounted.velocities()) < Method::passes * kick * steps * steps);
        CHECK(distance(plain.positions(), x) > 1e-3);
    }
}

TEMPLATE_LIST_TEST_CASE("Work is told of the accounted step alone", "[physics]", DoubleCases) {
    using Method = typename TestType::Method;
    Sheet<double, Method> sheet(cloth(0.05)), same(cloth(0.05));
    CHECK(sheet.advance(1e-3, 10).work.all() == 0.0);
    const Work among = sheet.advance(1e-3, 10, 15).work;
    same.advance(1e-3, 15);
    const Work alone = same.accounted_step(1e-3).work;
    CHECK(among.external == alone.external);
    CHECK(among.damping == alone.damping);
    CHECK(alone.damping < 0.0);  // dampers only take
    CHECK(alone.passes == 0.0);
    CHECK(sheet.advance(1e-3, 5).work.all() == 0.0);
}

TEMPLATE_LIST_TEST_CASE("Energy less work is the springs' quadrature error and nothing else", "[physics]",
                        WrittenOutDouble) {
    // The kinetic energy gains dt F.(v- + v+)/2 exactly, so of an accounted step all is left but what the springs'
    // potential changes beside what that quadrature takes their forces to do: of staggered methods the trapezoid of
    // the forces at both ends along the step, U(x') - U(x) + (f + f').(x' - x)/2; of forward Euler
    // U(x') - U(x) + f.(x' - x) + dt f.(v' - v)/2.
    using Method = typename TestType::Method;
    if constexpr (Method::passes == 1) {
        for (const auto damping : {std::optional<double>(), std::optional(0.05)}) {
            const Model model = cloth(damping);
            const Reference reference(model);
            const double dt = 1e-3;
            Sheet<double, Method> sheet(model, scattered(model.grid, 0.02), noise(masses_of(model), 0.5));
            sheet.advance(dt, 1);
            for (int n = 0; n < 100; ++n) {
                const auto x = sheet.positions(), v = sheet.stored_velocities();
                const double before = sheet.measure().balance();
                const Work work = sheet.accounted_step(dt).work;
                const auto x_next = sheet.positions(), v_next = sheet.stored_velocities();
                const double left = sheet.measure().balance() - before - work.all();

                const auto still = at_rest(model);
                const auto f = reference.forces(x, still), f_next = reference.forces(x_next, still);
                double expected = reference.elastic_energy(x_next) - reference.elastic_energy(x);
                for (std::size_t i = 0; i < x.size(); ++i) {
                    if (is_held(model, static_cast<int>(i))) continue;
                    expected += Method::staggered
                                    ? 0.5 * dot(f[i] + f_next[i], x_next[i] - x[i])
                                    : dot(f[i], x_next[i] - x[i]) + 0.5 * dt * dot(f[i], v_next[i] - v[i]);
                }
                // Sums of some two hundred terms, none above the energy there is (forward Euler's grows to many joules)
                CHECK(std::abs(left - expected) < 200.0 * epsilon<double> * sheet.measure().total());
            }
        }
    }
}

TEMPLATE_LIST_TEST_CASE("Energy less work vanishes with the method's order", "[physics]", DoubleCases) {
    // The trapezoid's of order 2, forward Euler's of order 1. Runge-Kutta counts work by its own four evaluations, so
    // energy and work are one equation more that it solves with order 4. In one step it is one order more; of
    // Runge-Kutta at least that, for in linear motion terms of dt^5 vanish: a mode loses y^6/72 of its energy.
    using Method = typename TestType::Method;
    constexpr int order = Method::staggered ? 2 : Method::order;
    const auto check_order = [](const std::vector<double>& left, int expected) {
        for (int n = 0; n < 2; ++n) {
            const double measured = std::log2(std::abs(left[n] / left[n + 1]));
            INFO("left " << left[n] << " and " << left[n + 1] << " J");
            CHECK(measured > expected - 0.1);
            CHECK((order == 4 || measured < expected + 0.1));
        }
    };
    for (const auto damping : {std::optional<double>(), std::optional(0.05)}) {
        const Model model = cloth(damping);
        const auto x = scattered(model.grid, 0.02), v = noise(masses_of(model), 1.0);
        // What is left after `n` steps of dt
        const auto left_after = [&](double dt, int n) {
            Sheet<double, Method> sheet(model, x, v);
            sheet.advance(dt, 0);  // the method starts, which sets its velocities back by half a kick
            const double before = sheet.measure().balance();
            double work = 0.0;
            for (int step = 0; step < n; ++step) work += sheet.accounted_step(dt).work.all();
            return sheet.measure().balance() - before - work;
        };
        // omega dt is a quarter at the first of these, far from rounding (1e-15 J) at the last.
        const double dt = order == 4 ? 5e-4 : 2e-5;
        check_order({left_after(dt, 1), left_after(dt / 2, 1), left_after(dt / 4, 1)}, order + 1);
        if (order == 4) continue;
        const double end = 0.1;
        const int steps = order == 1 && !damping ? 25600 : 3200;
        check_order({left_after(end / steps, steps), left_after(end / steps / 2, 2 * steps),
                     left_after(end / steps / 4, 4 * steps)},
                    order);
    }
}

TEMPLATE_LIST_TEST_CASE("Measured energies and stretches are sums over every spring and mass", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    for (const auto& [columns, rows] : awkward_sizes)
        for (const auto& springs : all_springs(0.01, 200.0, 100.0, 0.05))
            for (const Borders borders : {Borders::alike, Borders::light}) {
                const Model model({columns, rows, 0.1, 0.08}, springs, Attach::grommets, {}, {}, borders);
                const Reference reference(model, borders);
                Sheet<Real, typename TestType::Method> sheet(model, scattered(model.grid, 0.02),
                                                             noise(masses_of(model), 1.0));
                const auto m = sheet.measure();  // not started: position and velocity at the same time
                const auto x = sheet.positions(), v = sheet.stored_velocities();
                double kinetic = 0.0, mean = 0.0, max_force = 0.0, squares = 0.0;
                glm::dvec3 moment(0.0);
                for (int n = 0; n < masses_of(model); ++n) {
                    if (is_held(model, n)) continue;
                    kinetic += 0.5 * reference.mass(n) * dot(v[n], v[n]);
                    moment += reference.mass(n) * x[n];
                }
                for (const auto& s : reference.springs()) {
                    const double longer = length(x[s.b] - x[s.a]) - s.rest;
                    mean += std::abs(longer) / s.rest;
                    max_force = std::max(max_force, s.k * std::abs(longer));
                    squares += s.k * longer * s.k * longer;
                }
                const auto count = static_cast<double>(reference.springs().size());
                // A spring's length is off by some 4 eps of coordinates up to 3 m: 12 eps of 0.02 m that it is longer
                // or shorter by, energies and squares twice as much, sums of all a little more.
                const double off = 8.0 * 4.0 * epsilon<Real> * (length(model.grid.rest(columns, rows)) + 0.1) / 0.02;
                CHECK(m.kinetic == Approx(kinetic).epsilon(off));
                CHECK(m.elastic == Approx(reference.elastic_energy(x)).epsilon(off));
                CHECK(m.max_stretch == Approx(reference.max_stretch(x)).epsilon(off));
                CHECK(m.mean_stretch == Approx(mean / count).epsilon(off));
                CHECK(m.max_force == Approx(max_force).epsilon(off));
                CHECK(m.rms_force == Approx(std::sqrt(squares / count)).epsilon(off));
                CHECK(length(m.moment - moment) < off * length(moment) + off * 0.01);
                CHECK(model.springs_in_all() == static_cast<long long>(reference.springs().size()));
            }
}
