// What float can honour: the law behind smallest_float_step, and what the programs make of it.
#include "catch.hpp"
#include "io/error.hpp"
#include "run/engine.hpp"
#include "run/simulation.hpp"
#include "scene/file.hpp"

#include "drapeau/precision.hpp"

#include <cmath>

using namespace drapeau;

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
    creeping.springs.friction = 10.0;
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
    scene.springs.mass *= 8.0, *scene.springs.drag *= 8.0;
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
    scene.springs.mass = 0.01, scene.springs.drag = 0.01, scene.springs.stiffness = 2e5;
    scene.wind().emplace();
    scene.wind()->velocity = {3000.0, 0.0, 0.0};
    Simulation simulation(scene);
    REQUIRE(simulation.precision() == Precision::single_precision);
    for (int n = 0; n < 1200 && simulation.precision() == Precision::single_precision; ++n)
        REQUIRE_FALSE(simulation.advance_batch());
    CHECK(simulation.precision() == Precision::double_precision);
    CHECK(simulation.state().position.at(0, 0).x > 100.0);
}
