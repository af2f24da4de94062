// Divergence: a run that comes apart stops on its last good state and says when, where and why.
#include "catch.hpp"
#include "error.hpp"
#include "run/simulation.hpp"

#include <cmath>
#include <limits>

using namespace drapeau;

namespace {

/// A small flag with every force, at a step `share` of its limit.
Scene flag(Method method, Precision precision) {
    Scene scene;
    scene.flag.columns = 9, scene.flag.rows = 6;
    scene.springs = {.mass = 0.001,
                     .stiffness = 200.0,
                     .diagonal_stiffness = 100.0,
                     .damping = 0.002,
                     .drag = 0.0006,
                     .friction = {}};
    scene.gravity = GravitySettings{};
    scene.wind = WindSettings{{6.0, 0.0, 1.0}, {2.0, 0.5, 2.0}, 1.5, 1};
    scene.time = {method, {}, precision};
    return scene;
}

double limit_of(Scene scene) {
    scene.time.dt = 1e-6;
    return Simulation(scene).stability_limit();
}

bool is_finite(const Simulation& simulation) {
    for (const double value : simulation.state())
        if (!std::isfinite(value)) return false;
    Snapshot shown;
    simulation.snapshot(shown);
    for (const auto* part : {&shown.x, &shown.y, &shown.z, &shown.vx, &shown.vy, &shown.vz})
        for (const float value : *part)
            if (!std::isfinite(value)) return false;
    const auto readings = simulation.readings();
    return std::isfinite(readings.kinetic_energy) && std::isfinite(readings.spring_energy);
}

/// Batches until it diverges, at most `most`.
std::optional<Divergence> run_until_divergence(Simulation& simulation, int most) {
    for (int n = 0; n < most; ++n)
        if (auto divergence = simulation.advance_batch()) return divergence;
    return {};
}

const Precision precisions[] = {Precision::single_precision, Precision::double_precision};
const Method methods[] = {Method::forward_euler, Method::semi_implicit_euler};

}  // namespace

TEST_CASE("A step above the limit comes apart and the run stands on its last good batch", "[physics]") {
    for (const auto method : methods)
        for (const auto precision : precisions)
            for (const double excess : {1.5, 3.0, 100.0}) {
                Scene scene = flag(method, precision);
                // Forward Euler's bound is far below where a flag at rest comes apart: half the other's is enough.
                const double limit = limit_of(flag(Method::semi_implicit_euler, precision));
                scene.time.dt = excess * limit;
                Simulation simulation(scene);
                simulation.use_exact_dt();
                std::optional<Divergence> divergence;
                std::uint64_t good = simulation.state_hash();
                long long steps = 0;
                while (!divergence && steps < 4000) {
                    good = simulation.state_hash(), steps = simulation.steps();
                    divergence = simulation.advance_steps(40);
                }
                REQUIRE(divergence);
                CHECK(is_finite(simulation));
                CHECK(simulation.state_hash() == good);
                CHECK(simulation.steps() == steps);
                CHECK(simulation.time() == static_cast<double>(steps) * simulation.dt());

                CHECK(divergence->step > steps);
                CHECK(divergence->step <= steps + 40);
                CHECK(divergence->time == Approx(static_cast<double>(divergence->step) * simulation.dt()));
                CHECK((divergence->column >= 0 && divergence->column < 9));
                CHECK((divergence->row >= 0 && divergence->row < 6));
                CHECK(divergence->dt == simulation.dt());
                CHECK(divergence->limit == simulation.stability_limit());
                CHECK(divergence->safe_dt == Approx(0.9 * divergence->limit));
                CHECK(divergence->message.find('\n') == std::string::npos);
                CHECK(divergence->message.find("column " + std::to_string(divergence->column)) != std::string::npos);
                CHECK(divergence->message.find("stability limit") != std::string::npos);
                CHECK(divergence->message.find("safe") != std::string::npos);

                // And again: the same from the same state
                const auto again = simulation.advance_steps(40);
                REQUIRE(again);
                CHECK(again->step == divergence->step);
                CHECK(again->message == divergence->message);
            }
}

TEST_CASE("The step named is the one that breaks the budget, and no step before it does", "[physics]") {
    for (const auto method : methods)
        for (const auto precision : precisions)
            for (const double excess : {1.2, 2.0, 30.0}) {
                Scene scene = flag(method, precision);
                scene.time.dt = excess * limit_of(flag(Method::semi_implicit_euler, precision));
                Simulation by_batch(scene), by_step(scene);
                by_batch.use_exact_dt(), by_step.use_exact_dt();
                std::optional<Divergence> in_batch, in_step;
                while (!in_batch && by_batch.steps() < 6000) in_batch = by_batch.advance_steps(60);
                while (!in_step && by_step.steps() < 6000) in_step = by_step.advance_steps(1);
                REQUIRE(in_batch);
                REQUIRE(in_step);
                INFO("method " << static_cast<int>(method) << ", " << excess << " times the limit");
                // The watch by single steps sees work done to and fro that a batch's net displacement hides: its
                // budget is larger, by less than one step's growth here.
                CHECK(std::abs(in_batch->step - in_step->step) <= 1);
                CHECK(in_step->step == by_step.steps() + 1);
                CHECK(is_finite(by_step));
            }
}

TEST_CASE("With the safe step that the message names the run goes on", "[physics]") {
    for (const auto precision : precisions) {
        Scene scene = flag(Method::semi_implicit_euler, precision);
        scene.time.dt = 1.6 * limit_of(scene);
        Simulation simulation(scene);
        const auto divergence = run_until_divergence(simulation, 600);
        REQUIRE(divergence);
        const double time = simulation.time();
        scene.time.dt = divergence->safe_dt;
        simulation.change(scene);
        CHECK(simulation.dt() <= divergence->safe_dt);
        CHECK(simulation.time() == time);
        CHECK_FALSE(run_until_divergence(simulation, 300));
        CHECK(is_finite(simulation));
        CHECK(simulation.readings().greatest_stretch < 1.0);
    }
}

TEST_CASE("Auto is a step within the bound, and runs", "[physics]") {
    for (const auto precision : precisions) {
        Simulation simulation(flag(Method::semi_implicit_euler, precision));
        CHECK(simulation.dt() <= 0.9 * simulation.stability_limit() * (1.0 + 1e-8));
        CHECK(simulation.dt() > 0.4 * simulation.stability_limit());
        CHECK_FALSE(run_until_divergence(simulation, 300));
    }
}

TEST_CASE("Forward Euler without drag or friction: auto says which damping is needed, and that damping runs",
          "[physics]") {
    for (const auto precision : precisions) {
        Scene scene = flag(Method::forward_euler, precision);
        scene.springs.drag.reset();
        scene.wind.reset();
        std::string message;
        try {
            const Simulation simulation(scene);
        } catch (const InputError& error) {
            message = error.what();
        }
        REQUIRE(message.find("time.dt") != std::string::npos);
        REQUIRE(message.find("N s/m") != std::string::npos);
        CHECK(message.find("semi-implicit-euler") != std::string::npos);

        // "... their sum must exceed X N s/m ..."
        const std::string before = "must exceed ";
        const auto place = message.find(before);
        REQUIRE(place != std::string::npos);
        const double needed = std::stod(message.substr(place + before.size()));
        scene.springs.friction = 1.1 * needed;
        Simulation simulation(scene);
        CHECK(simulation.stability_limit() > 0.0);
        CHECK_FALSE(run_until_divergence(simulation, 120));
        CHECK(is_finite(simulation));
    }
}

TEST_CASE("No finite setting, however extreme, shows a value that is not finite", "[physics]") {
    struct Extreme {
        const char* name;
        void (*apply)(Scene&);
    };
    const Extreme extremes[] = {
        {"hurricane of 1e6 m/s",
         [](Scene& s) {
             s.wind->velocity = {1e6, 0.0, 1e6};
         }},
        {"gusts of 1e6 m/s",
         [](Scene& s) {
             s.wind->gusts = {1e6, 1e6, 1e6};
         }},
        {"stiffness 1e8", [](Scene& s) { s.springs.stiffness = 1e8; }},
        {"stiffness 1e8 at a numeric step", [](Scene& s) { s.springs.stiffness = 1e8, s.time.dt = 1e-3; }},
        {"a step a million times too large", [](Scene& s) { s.time.dt = 1e3; }},
        {"a mass of 1e-9 kg", [](Scene& s) { s.springs.mass = 1e-9, s.time.dt = 1e-3; }},
        {"gravity of 1e6 m/s2",
         [](Scene& s) {
             s.gravity->acceleration = {0.0, -1e6, 0.0};
         }},
        {"drag beyond its own limit", [](Scene& s) { s.springs.drag = 10.0, s.time.dt = 1.0 / 60.0; }},
        {"damping beyond its own limit", [](Scene& s) { s.springs.damping = 10.0, s.time.dt = 1.0 / 60.0; }},
        {"everything held", [](Scene& s) { s.flag.attach = Attach::all; }},
        {"nothing held", [](Scene& s) { s.flag.attach = Attach::none; }},
        {"two masses", [](Scene& s) { s.flag.columns = 2, s.flag.rows = 1; }},
        {"crumpled", [](Scene& s) { s.flag.start = Start::crumpled; }},
        {"every mass in one place", [](Scene& s) { s.flag.prestretch = -0.999999; }},
    };
    for (const auto& extreme : extremes)
        for (const auto method : methods)
            for (const auto precision : precisions) {
                INFO(extreme.name << ", method " << static_cast<int>(method));
                Scene scene = flag(method, precision);
                extreme.apply(scene);
                try {
                    Simulation simulation(scene);
                    for (int batch = 0; batch < 3; ++batch) {
                        // Steps of an extreme auto are many: a few dozen show as much as a batch.
                        const auto divergence = simulation.steps_per_batch() > 3000 ? simulation.advance_steps(200)
                                                                                    : simulation.advance_batch();
                        CHECK(is_finite(simulation));
                        if (divergence) CHECK(!divergence->message.empty());
                    }
                } catch (const InputError& error) {
                    CHECK(std::string(error.what()).size() > 10);  // refused with a line
                }
            }
}
