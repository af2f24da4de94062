// The methods that solve: implicit Euler against its own equation and the damping it adds, XPBD against its softness.
#include "catch.hpp"
#include "physics_reference.hpp"
#include "physics_sheet.hpp"
#include "run/simulation.hpp"
#include "scene/file.hpp"

using namespace drapeau;
using namespace drapeau::testing;

namespace {

Model cloth(double k, std::optional<double> damping) {
    return Model({7, 6, 0.1, 0.1}, {0.01, k, 0.5 * k, damping}, Attach::grommets,
                 Terms()
                     .add(Gravity{{0.0, -9.81, 0.0}})
                     .add(AirDrag{0.01})
                     .add(Wind{{3.0, 0.5, 1.0}, {1.0, 0.5, 1.0}, 1.5, true, 3}));
}

}  // namespace

TEST_CASE("Implicit Euler's step solves its equation, as far as it says", "[physics]") {
    for (const double k : {20.0, 2000.0})
        for (const auto damping : {std::optional<double>(), std::optional(0.05)})
            for (const double dt : {1e-3, 1.0 / 60.0}) {
                const Model model = cloth(k, damping);
                const Reference reference(model);
                Sheet<double, ImplicitEuler> sheet(model, scattered(model.grid, 0.02), noise(masses_of(model), 0.5));
                for (int n = 0; n < 20; ++n) {
                    const auto v = sheet.velocities();
                    const double t = sheet.time();
                    const Report report = sheet.advance(dt, 1);
                    const auto x_next = sheet.positions(), v_next = sheet.velocities();
                    const auto a = reference.acceleration(x_next, v_next, t + dt);
                    double squares = 0.0, change = 0.0;
                    int free = 0;
                    for (int i = 0; i < masses_of(model); ++i) {
                        if (is_held(model, i)) continue;
                        const auto lacking = v_next[i] - v[i] - dt * a[i];
                        squares += dot(lacking, lacking), change += dot(v_next[i] - v[i], v_next[i] - v[i]);
                        ++free;
                    }
                    const double left = std::sqrt(squares / free);
                    // What it reports is what there is, but for the rounding of forces of k times 1 m.
                    CHECK(std::abs(report.solves.residual - left) <
                          1e-3 * left + 64.0 * epsilon<double> * dt * k / 0.01);
                    CHECK(report.solves.steps == 1);
                    if (dt > 2e-3) continue;
                    CHECK(report.solves.unsolved == 0);
                    CHECK(left < 1e-3 * std::sqrt(change / free));
                }
            }
}

TEST_CASE("Implicit Euler damps a swing as it says where it is chosen", "[physics]") {
    // numerics: at dt = 1/60 s a swing of 1 Hz keeps 72 % a period, of 2 Hz 53 %, of 5 Hz 23 %.
    CHECK(ImplicitEuler::amplitude_kept(1.0, 1.0 / 60.0) == Approx(0.72).margin(0.005));
    CHECK(ImplicitEuler::amplitude_kept(2.0, 1.0 / 60.0) == Approx(0.53).margin(0.005));
    CHECK(ImplicitEuler::amplitude_kept(5.0, 1.0 / 60.0) == Approx(0.23).margin(0.005));

    // Measured on one mass on a spring: the amplitude is multiplied by 1/sqrt(1 + y^2) a step.
    const double m = 0.01, hertz = 2.0, k = m * std::pow(2.0 * 3.141592653589793 * hertz, 2), dt = 1.0 / 60.0;
    const Model model(spread(2, 1, 2.0, 1.0), {m, k, {}, {}}, Attach::hoist);
    Sheet<double, ImplicitEuler> mass(model, {{0, 0, 0}, {2.1, 0, 0}}, Points(2, glm::dvec3(0.0)));
    const double before = std::sqrt(mass.measure().total());
    mass.advance(dt, 30);  // a period
    CHECK(std::sqrt(mass.measure().total()) / before == Approx(ImplicitEuler::amplitude_kept(hertz, dt)).epsilon(1e-6));
}

TEST_CASE("Implicit Euler takes a thirtieth of a second on every shipped scene", "[physics]") {
    for (const auto& name : {"report", "breeze", "calm", "storm", "banner", "drop", "drum", "spring"}) {
        Scene scene = read_scene(find_scene(name));
        scene.flag.start = Start::flat;  // settling takes its time and is tested elsewhere
        scene.time.method = method_id<ImplicitEuler>;
        scene.time.dt = 1.0 / 30.0;
        Simulation simulation(scene);
        simulation.use_exact_dt();
        INFO(name);
        CHECK_FALSE(simulation.advance_steps(60));
        CHECK_FALSE(simulation.check());
        const Readings readings = simulation.readings();
        CHECK(std::isfinite(readings.kinetic_energy));
        CHECK(readings.max_stretch < 0.5);  // no explicit method gets anywhere at such a step
        const Solves& solves = simulation.solves();
        CHECK(solves.steps == 60);
        CHECK(solves.unsolved <= 20);  // steps in which the cloth snaps over; their residual is reported
    }
}

TEMPLATE_LIST_TEST_CASE("XPBD's chain gives way 1 + dt^2 k/m times as far, and carries its weight all the same",
                        "[physics]", Precisions) {
    constexpr int springs = 20;
    const double m = 0.01, k = 200.0, g = 9.81;
    const Model model(spread(1, springs + 1, 0.0, 1.0), {m, k, {}, {}}, Attach::top,
                      Terms().add(Gravity{{0.0, -g, 0.0}}).add(AirDrag{0.2}));
    for (const double ratio : {0.109, 0.0068}) {
        const double dt = std::sqrt(ratio * m / k);
        Sheet<TestType, Xpbd> chain(model);
        chain.advance(dt, static_cast<long long>(8.0 / dt));
        const double softer = (-chain.positions()[springs].y - 1.0) / (m * g * springs * (springs + 1) / (2.0 * k));
        CHECK(Xpbd::softness(k, m, dt) == Approx(1.0 + ratio));
        // Springs that are corrected first give way 1 + 2 dt^2 k/m times as far, those after them, whose ends these
        // have moved, as far as they should: 1 + dt^2 k/m on average, where drag makes masses heavier by 1 + dt d/m.
        // (The first spring, held at one end, and the lower ones, of less tension, move that by half a spring of
        // twenty.)
        const double heavier = 1.0 + dt * 0.2 / m;
        CHECK(softer - 1.0 > 0.9 * ratio / heavier);
        CHECK(softer - 1.0 < 1.1 * ratio / heavier);
        // Each carries the weight below it: its own tension, k l over its own softness.
        const double top = chain.positions()[0].y - chain.positions()[1].y - model.grid.pitch_y;
        // (The top one's upper end is held: it is corrected after the lower end has fallen by dt^2 g, a twentieth.)
        CHECK(top * k / (1.0 + 0.95 * ratio / heavier) == Approx(springs * m * g).epsilon(2e-3));
    }
}

TEST_CASE("XPBD's sheet is too soft in proportion to dt^2 k/m", "[physics]") {
    // A sheet held at its top: how much further than at a far smaller step it hangs. 0.96 to 1.00 of dt^2 k/m was
    // measured elsewhere, springs one after the other; in groups most are corrected after others have moved their ends.
    const Model model({6, 8, 0.1, 0.1}, {0.01, 200.0, 100.0, {}}, Attach::top,
                      Terms().add(Gravity{{0.0, -9.81, 0.0}}).add(AirDrag{0.1}));
    const auto hangs = [&](double ratio) {
        const double dt = std::sqrt(ratio * 0.01 / 200.0);
        Sheet<double, Xpbd> sheet(model);
        sheet.advance(dt, static_cast<long long>(6.0 / dt));
        return -sheet.positions()[7 * 6 + 2].y - 0.7;
    };
    const double stiff = hangs(0.0005);
    for (const double ratio : {0.011, 0.1, 0.69}) {
        const double slope = (hangs(ratio) / stiff - 1.0) / ratio;
        INFO("dt^2 k/m = " << ratio << ", slope " << slope);
        CHECK(slope > 0.7);
        CHECK(slope < 1.0);
    }
}

TEST_CASE("A start half a kick back makes semi-implicit Euler several times as accurate for nothing", "[physics]") {
    Scene scene = read_scene(find_scene("report"));
    scene.flag.columns = 23, scene.flag.rows = 15;
    const Model model = model_of(scene);
    // Swung in for 0.3 s; then 0.1 s, whose truth is a run at a fortieth of the step.
    Sheet<double, Leapfrog> swung(model);
    swung.advance(1e-5, 30000);
    const auto x = swung.positions(), v = swung.velocities();
    constexpr int steps = 800;
    const double dt = 0.1 / steps;
    Sheet<double, Leapfrog> truth(model, x, v);
    truth.advance(dt / 40, 40 * steps);
    const auto error = [&](auto&& sheet) {
        sheet.advance(dt, steps);
        auto off = sheet.positions();
        for (std::size_t n = 0; n < off.size(); ++n) off[n] -= truth.positions()[n];
        return root_mean_square(off);
    };
    const double plain = error(Sheet<double, SemiImplicitEuler>(model, x, v)),
                 back = error(Sheet<double, HalfKickStart>(model, x, v));
    INFO("errors " << plain << " and " << back << " m");
    CHECK(plain > 4.0 * back);
}

TEST_CASE("Without damping a start half a kick back makes semi-implicit Euler a method of order 2", "[physics]") {
    const Model model({5, 4, 0.1, 0.1}, {0.01, 200.0, 100.0, {}}, Attach::grommets,
                      Terms().add(Gravity{{0.0, -9.81, 0.0}}));
    const auto x = scattered(model.grid, 0.01), v = noise(masses_of(model), 0.3);
    Points exact = x, exact_v = v;
    Sheet<double, Leapfrog> held(model, x, v);  // held masses get no velocity
    exact_v = held.velocities();
    Reference(model).runge_kutta(exact, exact_v, 0.2 / 6400, 6400);
    std::vector<double> errors, in_velocity;
    for (const int steps : {800, 1600, 3200}) {
        Sheet<double, HalfKickStart> sheet(model, x, v);
        sheet.advance(0.2 / steps, steps);
        auto off = sheet.positions(), off_v = sheet.velocities();
        for (std::size_t n = 0; n < off.size(); ++n) off[n] -= exact[n], off_v[n] -= exact_v[n];
        errors.push_back(root_mean_square(off)), in_velocity.push_back(root_mean_square(off_v));
    }
    for (int n = 0; n < 2; ++n) {
        CHECK(std::log2(errors[n] / errors[n + 1]) == Approx(2.0).margin(0.1));
        CHECK(std::log2(in_velocity[n] / in_velocity[n + 1]) == Approx(2.0).margin(0.1));
    }
}
