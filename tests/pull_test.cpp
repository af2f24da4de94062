// Pull: a hand that holds the cloth neither tears it nor breaks a run, whatever it does, and brings in what it brings
// in.
#include "all_methods.hpp"
#include "catch.hpp"
#include "run/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <string>

using namespace drapeau;

namespace {

Scene flag(int columns, int rows, Method method = method_id<SemiImplicitEuler>) {
    Scene scene;
    scene.flag.columns = columns, scene.flag.rows = rows;
    const double share = 45.0 * 30.0 / (double(columns) * rows);
    scene.springs = {.mass = 1.22e-4 * share,
                     .stiffness = 800.0,
                     .diagonal_stiffness = 400.0,
                     .damping = 0.002,
                     .drag = 6e-4 * share,
                     .friction = {}};
    scene.gravity() = Gravity{};
    scene.wind() = Wind{.velocity = {7.0, 0.0, 1.0}, .gusts = {1.5, 0.5, 3.5}, .period = 0.8};
    scene.time.method = method;
    return scene;
}

double length(const glm::dvec3& a) {
    return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}

glm::dvec3 place_of(const Simulation& simulation, int i, int j) {
    return simulation.state().position.at(i, j);
}

/// The extremes of a mouse: from one end of the world to the other every batch, and then far away in one direction.
double greatest_stretch_of_extremes(Simulation& simulation, int batches) {
    double most = 0.0;
    for (int n = 0; n < batches; ++n) {
        const double side = n % 2 == 0 ? 100.0 : -100.0;
        const glm::dvec3 there = n < batches / 2 ? glm::dvec3(side, -side, side) : glm::dvec3(70.0, 10.0, 70.0);
        simulation.pull(Pull{0.9, 0.4, there});
        const auto divergence = simulation.advance_batch();
        if (divergence) FAIL(divergence->message);
        const Readings readings = simulation.readings();
        REQUIRE(std::isfinite(readings.kinetic_energy));
        most = std::max(most, readings.max_stretch);
    }
    return most;
}

}  // namespace

TEST_CASE("whatever a hand does, no method breaks on it, and the cloth is not torn") {
    for (const Method method : all_methods())
        for (const auto& [columns, rows] : {std::pair{4, 4}, std::pair{45, 30}, std::pair{128, 128}}) {
            const std::string name =
                with_method(method, [](const auto& m) { return std::string(std::decay_t<decltype(m)>::name); });
            CAPTURE(name, columns, rows);
            Simulation simulation(flag(columns, rows, method));
            const double before = simulation.dt();
            const double solve = with_method(method, [](const auto& m) { return m.solves ? 40.0 : 1.0; });
            const double work = solve * double(simulation.steps_per_batch()) * columns * rows;
            if (work > 5e7) continue;  // forward Euler's steps, a quarter of a million a batch
            const int batches = std::clamp(int(4e6 / work), 3, 120);
            const double stretch = greatest_stretch_of_extremes(simulation, batches);
            const double created = simulation.readings().created_share.value_or(0.0);
            simulation.pull({});
            for (int n = 0; n < (batches + 2) / 3; ++n) REQUIRE_FALSE(simulation.advance_batch());
            REQUIRE_FALSE(simulation.check());
            // A quarter by the hand at most, less than that by the wind; waves overlap.
            INFO(stretch);
            CHECK(stretch < 0.3);
            CHECK(std::abs(created) < 0.1);
            CHECK(simulation.dt() == before);  // nothing asked for a smaller step
        }
}

TEST_CASE("a hand draws the place it holds to where it is, and let go the flag flies on as it did") {
    Simulation simulation(flag(45, 30));
    for (int n = 0; n < 60; ++n) REQUIRE_FALSE(simulation.advance_batch());
    const glm::dvec3 from = place_of(simulation, 40, 12), there = from + glm::dvec3(-0.1, 0.1, 0.15);
    for (int n = 0; n < 30; ++n) {
        simulation.pull(Pull{40.0 / 44, 12.0 / 29, there});
        REQUIRE_FALSE(simulation.advance_batch());
        CHECK(simulation.pull_force() > 0.0);
    }
    const glm::dvec3 held = place_of(simulation, 40, 12);
    CHECK(length(held - there) < 0.4 * length(from - there));
    simulation.pull({});
    for (int n = 0; n < 120; ++n) REQUIRE_FALSE(simulation.advance_batch());
    CHECK(simulation.pull_force() == 0.0);
    CHECK(length(place_of(simulation, 40, 12) - there) > 0.05);
    REQUIRE_FALSE(simulation.check());
}

TEST_CASE("a hand that came and went before a step leaves no trace in it, and none that never came") {
    Simulation pulled(flag(12, 8)), free(flag(12, 8));
    pulled.pull(Pull{0.5, 0.5, {1.0, 1.0, 1.0}});
    pulled.pull({});
    for (int n = 0; n < 30; ++n) {
        REQUIRE_FALSE(pulled.advance_batch());
        REQUIRE_FALSE(free.advance_batch());
    }
    CHECK(pulled.state_hash() == free.state_hash());
    pulled.pull(Pull{0.5, 0.5, {1.0, 1.0, 1.0}});
    REQUIRE_FALSE(pulled.advance_batch());
    REQUIRE_FALSE(free.advance_batch());
    CHECK(pulled.state_hash() != free.state_hash());
}

TEST_CASE("a pulled flag is the same to the bit for any number of threads") {
    Scene scene = flag(64, 96);
    Simulation one(scene), three(scene);
    three.use_threads(3);
    for (int n = 0; n < 10; ++n)
        for (Simulation* simulation : {&one, &three}) {
            simulation->pull(Pull{0.7, 0.33, {1.0, 0.1 * n, 0.5}});
            REQUIRE_FALSE(simulation->advance_batch());
        }
    CHECK(one.state_hash() == three.state_hash());
}

TEST_CASE("a weight hangs from a hand by the spring's length that carries it, and the force shown is the weight") {
    Scene scene;
    scene.flag.columns = scene.flag.rows = 5;
    scene.flag.attach = Attach::none;
    scene.springs = {
        .mass = 0.004, .stiffness = 400.0, .diagonal_stiffness = 200.0, .damping = 0.05, .drag = 0.05, .friction = {}};
    scene.gravity() = Gravity{};
    scene.time.method = GENERATE(method_id<SemiImplicitEuler>, method_id<Leapfrog>);
    scene.time.precision = Precision::double_precision;
    Simulation simulation(scene);
    const glm::dvec3 hand(0.75, 0.0, 0.0);
    simulation.pull(Pull{0.5, 0.0, hand});
    for (int n = 0; n < 900; ++n) REQUIRE_FALSE(simulation.advance_batch());
    const double weight = 25 * 0.004 * 9.8;
    CHECK(simulation.pull_force() == Approx(weight).epsilon(1e-2));
    // k = M (20/s)^2: g / 400.
    CHECK(hand.y - place_of(simulation, 2, 0).y == Approx(9.8 / 400.0).epsilon(1e-2));
}

TEST_CASE("nothing is held where every mass is fixed, and else the free mass that is nearest") {
    const Grid grid = spread(5, 3, 1.0, 1.0);
    CHECK_FALSE(nearest_free(grid, 0.5, 0.5, [](int, int) { return true; }));
    const auto hoist = [](int i, int) { return i == 0; };
    CHECK(nearest_free(grid, 0.0, 1.0, hoist) == std::pair{1, 2});
    CHECK(nearest_free(grid, 0.7, 0.1, hoist) == std::pair{3, 0});
    Scene scene = flag(4, 4);
    scene.flag.attach = Attach::all;
    Simulation fixed(scene);
    fixed.pull(Pull{0.5, 0.5, {1.0, 1.0, 1.0}});
    REQUIRE_FALSE(fixed.advance_batch());
    CHECK(fixed.pull_force() == 0.0);
    CHECK(place_of(fixed, 3, 3) == glm::dvec3(fixed.model().grid.rest(3, 3)));
}
