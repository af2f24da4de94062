// The methods that solve: implicit Euler against its own equation and the damping it adds, XPBD against its softness.
#include "catch.hpp"
#include "physics_reference.hpp"
#include "physics_sheet.hpp"
#include "run/simulation.hpp"
#include "sanitized.hpp"
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

/// XPBD's step as plainly as can be: masses move as if there were no springs, then springs are corrected one by one,
/// in the order of the method's groups.
class PlainXpbd {
public:
    PlainXpbd(const Model& model, Borders borders, const Points& from, const Points& at)
        : x(from), v(at), model_(model), reference_(model, borders), springs_(reference_.springs()) {
        const int columns = model.grid.columns;
        const auto place = [&](const Reference::Spring& s) {
            const int row = s.a / columns, column = s.a % columns, down = s.b / columns - row;
            // Along rows: even columns, odd ones. Then from even rows: downwards, falling, rising; then from odd rows.
            if (down == 0) return column % 2;
            const int across = s.b % columns - column;
            return 2 + 3 * (row % 2) + (across == 0 ? 0 : across > 0 ? 1 : 2);
        };
        std::stable_sort(springs_.begin(), springs_.end(),
                         [&](const auto& s, const auto& other) { return place(s) < place(other); });
    }

    /// `pushed`: a mass's acceleration (m/s2), but for drag, of `rate` (1/s).
    void step(double dt, const glm::dvec3& pushed, double rate) {
        const double s = 1.0 + dt * rate;
        auto moved = v;
        for (std::size_t n = 0; n < x.size(); ++n)
            moved[n] = is_held(model_, static_cast<int>(n)) ? glm::dvec3(0.0) : dt / s * (v[n] + dt * pushed);
        const auto lightness = [&](int n) { return is_held(model_, n) ? 0.0 : 1.0 / (reference_.mass(n) * s); };
        for (const auto& spring : springs_) {
            const auto grown = moved[spring.b] - moved[spring.a], d = x[spring.b] - x[spring.a] + grown;
            const double l = length(d), w_a = lightness(spring.a), w_b = lightness(spring.b);
            const double tension = (spring.k * (l - spring.rest) + spring.c / dt * dot(grown, d) / l) /
                                   (1.0 + dt * (dt * spring.k + spring.c) * (w_a + w_b));
            moved[spring.a] += dt * dt * tension * w_a / l * d;
            moved[spring.b] -= dt * dt * tension * w_b / l * d;
        }
        for (std::size_t n = 0; n < x.size(); ++n) x[n] += moved[n], v[n] = moved[n] / dt;
    }

    Points x, v;

private:
    Model model_;
    Reference reference_;
    std::vector<Reference::Spring> springs_;
};

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

TEST_CASE("Where implicit Euler leaves most of its steps unsolved, that is said until settings change", "[physics]") {
    // At dt^2 k/m = 10^9 neither conjugate gradients nor double get far; at 500 they do.
    Scene scene = read_scene(find_scene("report"));
    scene.flag.columns = scene.flag.rows = 8;
    scene.time = {method_id<ImplicitEuler>, 1.0 / 60.0, Precision::double_precision};
    scene.springs->stiffness = 1e9;
    Simulation simulation(scene);
    const auto after_half_a_second = [&] {
        for (int n = 0; n < 30; ++n) REQUIRE_FALSE(simulation.advance_batch());
        CHECK(simulation.solves().steps == 30);
        INFO(simulation.solves().unsolved << " unsolved, " << simulation.method_remark());
        const bool is_said = simulation.method_remark().find("unsolved") != std::string::npos;
        CHECK(is_said == (2 * simulation.solves().unsolved > simulation.solves().steps));
        return is_said;
    };
    CHECK(after_half_a_second());
    scene.springs->stiffness = 200.0;
    simulation.change(scene);
    CHECK_FALSE(after_half_a_second());
}

TEST_CASE("Implicit Euler takes a thirtieth of a second on every scene of springs and drag", "[physics]") {
    // Air on faces and bending are taken at a step's beginning and have limits of their own.
    std::vector<std::string> names{"report", "spring"};
    if (!sanitized)
        for (const char* name : {"breeze", "calm", "storm", "banner", "drop", "drum"})
            names.push_back(std::string("linear-drag/") + name);
    for (const std::string& name : names) {
        Scene scene = read_scene(assets_directory() / "scenes" / (name + ".toml"));
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
        CHECK(solves.unsolved <= 6);  // steps in which the cloth snaps over; their residual is reported
    }
}

TEST_CASE("XPBD's step corrects springs one by one in the order it says", "[physics]") {
    const glm::dvec3 gravity{0.5, -9.81, 1.0};
    for (const Borders borders : {Borders::alike, Borders::light})
        for (const auto& springs : all_springs(0.01, 200.0, 100.0, 0.05))
            for (const double dt : {1e-3, 1.0 / 120.0}) {
                const Model model({7, 6, 0.1, 0.08}, springs, Attach::grommets,
                                  Terms().add(Gravity{gravity}).add(AirDrag{0.02}), {}, borders);
                Sheet<double, Xpbd> sheet(model, scattered(model.grid, 0.02), noise(42, 0.5));
                PlainXpbd plain(model, borders, sheet.positions(), sheet.velocities());
                const int steps = 20;
                sheet.advance(dt, steps);
                for (int n = 0; n < steps; ++n) plain.step(dt, gravity, 0.02 / 0.01);
                // Each of eight springs at a mass moves it by a difference of lengths known to a few eps of 1 m; what
                // one step is off by moves the mass on with a velocity of that over dt for the others.
                const double rounding = 8 * 4 * epsilon<double> * steps * steps;
                CHECK(distance(sheet.positions(), plain.x) < rounding);
                CHECK(distance(sheet.velocities(), plain.v) < rounding / dt);
                CHECK(distance(sheet.positions(), scattered(model.grid, 0.02)) > 1e-3);
            }
}

TEMPLATE_LIST_TEST_CASE("XPBD's chain gives way 1 + dt^2 k/m times as far, and carries its weight all the same",
                        "[physics]", Precisions) {
    // At rest a step moves no mass: its fall by dt^2 g/s (s = 1 + dt d/m: drag makes masses heavier) is taken back by
    // the two springs that hold it, so each carries exactly what hangs below it, T_j. A spring's length when it is
    // corrected is longer than at rest by k^-1 [1 + 2 r] T_j with r = dt^2 k/(m s), the sum of both ends' lightness
    // (one end's at the top, which is held). Every other spring is corrected first, while all masses have fallen alike
    // (but the top's held end has not): it gives way 1 + 2 r times as far. The others' ends have been pulled apart by
    // then, by r (T_{j-1} + T_{j+1})/k = 2 r T_j/k: they give way as far as they should. That is 1 + r on average.
    constexpr int springs = 20;
    const double m = 0.01, k = 200.0, g = 9.81, drag = 0.2;
    const Model model(spread(1, springs + 1, 0.0, 1.0), {m, k, {}, {}}, Attach::top,
                      Terms().add(Gravity{{0.0, -g, 0.0}}).add(AirDrag{drag}));
    // The excess of the elongation as found elsewhere, springs corrected one after the other downwards or upwards
    for (const auto& [ratio, downwards, upwards] : {std::tuple{0.109, 0.098, 0.108}, {0.0068, 0.0061, 0.0067}}) {
        const double dt = std::sqrt(ratio * m / k), r = ratio / (1.0 + dt * drag / m);
        Sheet<TestType, Xpbd> chain(model);
        chain.advance(dt, static_cast<long long>(8.0 / dt));
        CHECK(Xpbd::softness(k, m, dt) == Approx(1.0 + ratio));
        const auto x = chain.positions();
        // Each length is a difference of numbers up to 1.1 m; a mass stalls where a step's motion rounds away, off by
        // a force of (eps/2 * 1.1 m) / dt * d: 3 eps of 1 m over k at 0.1 s.
        const double rounding = 8.0 * (1.0 + drag / (dt * k)) * 1.1 * epsilon<TestType>;
        double elongation = 0.0;
        for (int j = 0; j < springs; ++j) {
            const double weight = (springs - j) * m * g;
            double longer = weight / k;
            if (j == 0) longer = weight / k * (1.0 + r) - r * m * g / k;  // its upper end does not fall nor follow
            if (j > 0 && j % 2 == 0) longer = weight / k * (1.0 + 2.0 * r);
            INFO("spring " << j << " from the top, dt^2 k/m = " << ratio);
            CHECK(std::abs(x[j].y - x[j + 1].y - model.grid.pitch_y - longer) < rounding);
            elongation += longer;
        }
        const double softer = elongation / (m * g * springs * (springs + 1) / (2.0 * k)) - 1.0;
        // As soft as in any other order: drag's share less, and the top and the end half a spring's each.
        CHECK(softer > downwards * (r / ratio) * (1.0 - 1.0 / springs));
        CHECK(softer < upwards * (r / ratio) * (1.0 + 1.0 / springs));
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
