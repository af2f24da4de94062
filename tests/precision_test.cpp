// What float can honour: the law behind smallest_float_step, and what the programs make of it.
#include "catch.hpp"
#include "io/error.hpp"
#include "physics_sheet.hpp"
#include "run/engine.hpp"
#include "run/simulation.hpp"
#include "scene/file.hpp"

#include "drapeau/precision.hpp"

#include <cmath>

using namespace drapeau;
using namespace drapeau::testing;

namespace {

/// A free flag that begins to fall through still air: every mass alike, until rounding parts them.
Scene falling(double dt) {
    Scene scene;
    scene.flag.attach = Attach::none;
    scene.flag.disturbance = 0.0;
    scene.springs = {
        .mass = 1e-4, .stiffness = 200.0, .diagonal_stiffness = 100.0, .damping = 0.002, .drag = 6e-4, .friction = {}};
    scene.gravity().emplace();
    scene.time.dt = dt;
    return scene;
}

double honest_step(const Scene& scene) {
    const Model model = model_of(scene);
    return smallest_float_step(std::hypot(scene.flag.width, scene.flag.height), typical_speed(model));
}

/// The root mean square of what velocities in float differ by from those in double (m/s), after `steps` steps.
double difference(const Scene& scene, long long steps) {
    const Model model = model_of(scene);
    std::vector<State<double>> states;
    for (const auto precision : {Precision::single_precision, Precision::double_precision}) {
        const auto engine = make_engine(model, scene.time.method, precision);
        Report ignored;
        engine->advance({.dt = *scene.time.dt}, 0, steps, no_step, ignored, nullptr);
        states.push_back(engine->state(static_cast<double>(steps) * *scene.time.dt));
    }
    double squares = 0.0;
    for (int j = 0; j < scene.flag.rows; ++j)
        for (int i = 0; i < scene.flag.columns; ++i) {
            const auto d = states[0].velocity.at(i, j) - states[1].velocity.at(i, j);
            squares += d.x * d.x + d.y * d.y + d.z * d.z;
        }
    return std::sqrt(squares / (scene.flag.rows * scene.flag.columns));
}

}  // namespace

TEST_CASE("Float knows velocities to a unit in the last place of positions over the step, over the range of dt",
          "[physics]") {
    // A displacement dt v is rounded to the unit of x: v is off by up to 2^-24 x/dt, x from 0 to 1.8 m, and springs
    // share that out among neighbours whose units differ: never more than once that, and a good part of it.
    const double reach = std::hypot(1.5, 1.0);
    double parts = 0.0;  // the mean
    for (const double dt : {1e-4, 3e-5, 1e-5, 3e-6, 1e-6}) {
        const double unit = float_velocity_unit(reach, dt);
        const double off = difference(falling(dt), 2000);
        INFO("dt " << dt << " s, " << off / unit << " units");
        CHECK(off < unit);
        parts += off / unit / 5.0;
    }
    CHECK(parts > 0.05);
    // So at the smallest step called honest a two-hundredth of the speed of this fall (1.63 m/s in the end) is kept.
    const double honest = honest_step(falling(1e-4));
    CHECK(honest == Approx(200.0 * 0x1p-24 * reach / (9.8 / 6.0)).epsilon(1e-3));
    CHECK(difference(falling(honest), 2000) < 9.8 / 6.0 / 200.0);
}

TEMPLATE_LIST_TEST_CASE("A velocity below half a unit of the position over the step does not move a mass in float",
                        "[physics]", AllCases) {
    // At 1 m, where the unit is 2^-23 m, 1 mm/s moves a mass by 1e-7 m in 0.1 ms: by a whole unit instead, 19 % too
    // far. In half of that it is moved by 5e-8 m: less than half a unit, nothing. In double it moves as it should.
    using Real = typename TestType::Real;
    const Model model(spread(2, 1, 1.0, 0.0), {0.01, 0.0, {}, {}}, Attach::hoist);
    for (const auto& [dt, in_float] : {std::pair{1e-4, 1e4 * 0x1p-23 / 1e-3}, {5e-5, 0.0}}) {
        Sheet<Real, typename TestType::Method> mass(model, {{0, 0, 0}, {1, 0, 0}}, {{}, {1e-3, 0, 0}});
        mass.advance(dt, 1000);
        const double moved = (mass.positions()[1].x - 1.0) / (1e-3 * 1000 * dt);
        CHECK(moved == Approx(std::is_same_v<Real, float> ? in_float : 1.0).margin(1e-8));
        CHECK((float_velocity_unit(1.0, dt) > 1e-3) == (in_float == 0.0));
    }
}

TEST_CASE("In float a sheet at rest is pulled at by half a spring times the unit of where it is", "[physics]") {
    // Lengths of 0.03 m are differences of coordinates, each rounded by up to 2^-24 of a power of two that is |x| or
    // less: k |x| 2^-24/2 a coordinate, known to a factor of 2 for that power.
    const double k = 1000.0, found[] = {4.2e-5, 2.8e-3};  // N, by an independent program
    int n = 0;
    for (const double away : {1.5, 100.0}) {
        const Model model({20, 20, 0.03, 0.03}, {1.0, k, {}, {}}, Attach::none);  // 1 kg: accelerations are forces
        auto x = scattered(model.grid, 0.0);
        for (auto& p : x) p.x += away;
        Sheet<float, SemiImplicitEuler> sheet(model, x, at_rest(model));
        Rows<float> rows(model, sheet.checkpoint().fields);
        kernels_for<Vector<float>, SemiImplicitEuler>(model).evaluate(rows.whole());
        const double noise = root_mean_square(points_of(rows.out)) / std::sqrt(3.0), law = 0.5 * k * away * 0x1p-24;
        INFO("at " << away << " m: " << noise << " N");
        CHECK(noise < 2.0 * law);
        CHECK(noise > 0.5 * law);
        CHECK(noise == Approx(found[n++]).epsilon(0.25));
    }
}

TEMPLATE_TEST_CASE("Near the origin float is a micrometre off, far away the more the smaller the step", "[physics]",
                   SemiImplicitEuler, Leapfrog, Rk4) {
    // A cloth of 6 x 5 masses hangs from its top in gusts for a second. What rounding alone makes it be off by grows as
    // 1/dt or so (powers from 1/2 to 3/2: 4 to 64 times from 2 ms to 1/8 ms). An independent program found 1.3e-7 to
    // 3.3e-7 m near the origin, and 2.3e-5 to 6.1e-4 m at 100 m.
    const auto rounding_error = [](double away, double dt) {
        const Model model(
            {6, 5, 0.1, 0.1}, {0.01, 200.0, 100.0, 0.05}, Attach::top,
            Terms().add(Gravity{}).add(AirDrag{0.01}).add(Wind{{3.0, 0.5, 1.0}, {1.0, 0.5, 1.0}, 1.5, false, 3}));
        auto x = scattered(model.grid, 0.0);
        for (auto& p : x) p.x += away;
        Sheet<float, TestType> in_float(model, x, at_rest(model));
        Sheet<double, TestType> in_double(model, x, at_rest(model));
        in_float.advance(dt, std::llround(1.0 / dt)), in_double.advance(dt, std::llround(1.0 / dt));
        auto off = in_float.positions();
        const auto exact = in_double.positions();
        for (std::size_t n = 0; n < off.size(); ++n) off[n] -= exact[n];
        return root_mean_square(off);
    };
    for (const double dt : {2e-3, 1.25e-4}) CHECK(rounding_error(0.0, dt) < 5e-6);
    const double coarse = rounding_error(100.0, 2e-3), fine = rounding_error(100.0, 1.25e-4);
    INFO("at 100 m: " << coarse << " m at 2 ms, " << fine << " m at 1/8 ms");
    CHECK(fine > 4.0 * coarse);
    CHECK(coarse < 2e-4);
    CHECK(fine > 6e-5);
    CHECK(fine < 6e-3);
}

TEST_CASE("An automatic step that float cannot honour is taken in double, and that is said") {
    // Forward Euler needs steps of some 0.1 us on the report's flag.
    Scene scene = read_scene(find_scene("report"));
    Simulation usual(scene);
    CHECK(usual.precision() == Precision::single_precision);
    CHECK(usual.precision_remark().empty());

    scene.time.method = method_id<ForwardEuler>;
    Simulation forward(scene);
    CHECK(forward.precision() == Precision::double_precision);
    CHECK(forward.precision_remark().find("double") != std::string::npos);

    // Friction so strong that masses creep.
    Scene creeping = falling(1e-4);
    creeping.time.dt.reset();
    creeping.springs->friction = 10.0;
    CHECK(Simulation(creeping).precision() == Precision::double_precision);

    // A change in flight both ways.
    usual.advance_batch();
    const auto before = usual.state().position.at(10, 10);
    usual.change(scene);
    CHECK(usual.precision() == Precision::double_precision);
    const auto after = usual.state().position.at(10, 10);
    CHECK(std::abs(after.x - before.x) + std::abs(after.y - before.y) + std::abs(after.z - before.z) < 1e-6);
    scene.time.method = method_id<SemiImplicitEuler>;
    usual.change(scene);
    CHECK(usual.precision() == Precision::single_precision);
}

TEST_CASE("A given step that float does not honour is warned of, and refused where nothing is left") {
    const double honest = honest_step(falling(1e-4));
    CHECK(Simulation(falling(1.1 * honest)).precision_remark().empty());
    Scene scene = falling(0.5 * honest);
    Simulation warned(scene);
    warned.use_exact_dt();
    CHECK(warned.precision() == Precision::single_precision);
    CHECK(warned.precision_remark().find("choose double") != std::string::npos);
    scene.time.precision = Precision::double_precision;
    CHECK(Simulation(scene).precision_remark().empty());
    CHECK_THROWS_AS(Simulation(falling(0.005 * honest)), InputError);
    CHECK_THROWS_WITH(Simulation(falling(0.005 * honest)), ContainsSubstring("double"));
}

TEST_CASE("A run that float's rounding breaks says so, and not that the motion is violent") {
    // Free fall of loose masses in small steps: double falls, float gathers energy from the rounding of positions.
    Scene scene;
    scene.flag.columns = scene.flag.rows = 3;
    scene.flag.attach = Attach::none;
    scene.springs = {
        .mass = 0.001, .stiffness = 10.0, .diagonal_stiffness = {}, .damping = {}, .drag = {}, .friction = {}};
    scene.gravity().emplace();
    scene.time.dt = 1e-7;
    Simulation simulation(scene);
    simulation.use_exact_dt();
    std::optional<Divergence> divergence;
    for (int n = 0; n < 20 && !divergence; ++n) divergence = simulation.advance_steps(10000);
    if (!divergence) divergence = simulation.check();
    REQUIRE(divergence);
    CHECK(divergence->cause == Divergence::Cause::float_rounding);
    CHECK_THAT(divergence->message, ContainsSubstring("float cannot honour steps of 100 ns"));
}

TEST_CASE("A flat flag leaves its plane unless it is told not to", "[physics]") {
    // Wind along the fly, in the plane: the flag droops where it would else stand out for ever.
    Scene scene = read_scene(find_scene("report"));
    scene.flag.columns = 16, scene.flag.rows = 11;
    scene.springs->mass *= 8.0, *scene.springs->drag *= 8.0;
    scene.wind()->velocity = {2.0, 0.0, 0.0}, scene.wind()->gusts = {};
    const auto fly = [&](std::optional<double> disturbance) {
        scene.flag.disturbance = disturbance;
        Simulation simulation(scene);
        for (int n = 0; n < 60 * 20; ++n) REQUIRE_FALSE(simulation.advance_batch());
        double across = 0.0;
        const auto state = simulation.state();
        for (int j = 0; j < 11; ++j)
            for (int i = 0; i < 16; ++i) across = std::max(across, std::abs(state.position.at(i, j).z));
        return std::pair{across, state.position.at(15, 0).y};
    };
    scene.flag.disturbance = 0.0;
    Simulation told(scene);
    CHECK_THAT(told.start_remark(), ContainsSubstring("stays in the plane"));
    Scene crosswind = scene;
    crosswind.wind()->velocity.z = 1.0;  // the same model, blown at from the side
    told.change(crosswind);
    CHECK(told.start_remark().empty());
    scene.flag.disturbance.reset();
    CHECK(Simulation(scene).start_remark().empty());
    const auto [kept, stands] = fly(0.0);
    CHECK(kept == 0.0);
    for (const auto& disturbance : {std::optional<double>(), std::optional(0.002)}) {
        const auto [across, corner] = fly(disturbance);
        CHECK(across > 0.05);
        CHECK(corner < stands - 0.2);
    }
    // What wind pushes across needs none: it begins exactly flat.
    scene.flag.disturbance.reset();
    scene.wind()->velocity.z = 1.0;
    CHECK(Simulation(scene).state().position.at(15, 5).z == 0.0);
}

TEST_CASE("A flag that has flown far away is taken on in double") {
    // Float's unit grows with the way: after 10 km it is a millimetre.
    Scene scene = falling(1e-4);
    scene.flag.columns = scene.flag.rows = 4;
    scene.time.dt.reset();
    scene.springs->mass = 0.01, scene.springs->drag = 0.01, scene.springs->stiffness = 2e5;
    scene.wind().emplace();
    scene.wind()->velocity = {3000.0, 0.0, 0.0};
    Simulation simulation(scene);
    REQUIRE(simulation.precision() == Precision::single_precision);
    for (int n = 0; n < 1200 && simulation.precision() == Precision::single_precision; ++n)
        REQUIRE_FALSE(simulation.advance_batch());
    CHECK(simulation.precision() == Precision::double_precision);
    CHECK(simulation.state().position.at(0, 0).x > 100.0);
}
