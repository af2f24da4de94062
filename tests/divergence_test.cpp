// Divergence: a run that diverges stops on its last good state and says when, where, why and what helps.
#include "all_methods.hpp"
#include "catch.hpp"
#include "io/error.hpp"
#include "run/simulation.hpp"
#include "scene/file.hpp"

#include "drapeau/stability.hpp"

#include <cmath>
#include <limits>

using namespace drapeau;

namespace {

/// A small flag with every force.
Scene flag(Method method, Precision precision) {
    Scene scene;
    scene.flag.columns = 9, scene.flag.rows = 6;
    scene.springs = {.mass = 0.001,
                     .stiffness = 200.0,
                     .diagonal_stiffness = 100.0,
                     .damping = 0.002,
                     .drag = 0.0006,
                     .friction = {}};
    scene.gravity() = Gravity{};
    scene.wind() = Wind{.velocity = {6.0, 0.0, 1.0}, .gusts = {2.0, 0.5, 2.0}};
    scene.time = {method, {}, precision};
    return scene;
}

double limit_of(const Scene& scene) {
    return stable_step(scene.time.method, model_of(scene)).seconds();
}

bool is_finite(const Simulation& simulation) {
    const auto state = simulation.state();
    for (const auto* field : {&state.position, &state.velocity})
        for (int c = 0; c < 3; ++c)
            for (const double value : field->component(c))
                if (!std::isfinite(value)) return false;
    const auto readings = simulation.readings();
    return std::isfinite(readings.kinetic_energy) && std::isfinite(readings.spring_energy);
}

/// Methods whose step has a limit.
std::vector<Method> limited_methods() {
    std::vector<Method> limited;
    for (const Method method : all_methods())
        with_method(method, [&]<class M>(const M&) {
            if (M::stable_step({1.0, 1.0, 0.0, 0.0}).seconds() < 1e3) limited.push_back(method);
        });
    return limited;
}

/// Batches until it diverges, at most `most`.
std::optional<Divergence> run_until_divergence(Simulation& simulation, int most) {
    for (int n = 0; n < most; ++n)
        if (auto divergence = simulation.advance_batch()) return divergence;
    return {};
}

const Precision precisions[] = {Precision::single_precision, Precision::double_precision};

}  // namespace

TEST_CASE("A step far above the limit diverges and the run stands on a state that was good", "[physics]") {
    for (const auto method : limited_methods())
        for (const auto precision : precisions)
            for (const double excess : {1.5, 3.0, 100.0}) {
                Scene scene = flag(method, precision);
                // Forward Euler's bound is far below where a flag at rest diverges: the report's is enough.
                const double limit = std::max(limit_of(scene), limit_of(flag(method_id<SemiImplicitEuler>, precision)));
                scene.time.dt = excess * limit;
                INFO(name_of(method) << ", " << excess << " times the limit");
                Simulation simulation(scene);
                simulation.use_exact_dt();
                const double stretch_before = simulation.readings().max_stretch;
                std::optional<Divergence> divergence;
                while (!divergence && simulation.time() < 20.0) divergence = simulation.advance_steps(40);
                REQUIRE(divergence);
                CHECK(is_finite(simulation));
                // Good: before what was named, on the clock, and not stretched beyond what wind and weight can do.
                CHECK(simulation.steps() < divergence->step);
                CHECK(simulation.time() == static_cast<double>(simulation.steps()) * simulation.dt());
                CHECK(simulation.readings().max_stretch < stretch_before + 0.5);

                CHECK(divergence->time == Approx(static_cast<double>(divergence->step) * simulation.dt()));
                CHECK((divergence->column >= 0 && divergence->column < 9));
                CHECK((divergence->row >= 0 && divergence->row < 6));
                CHECK(divergence->dt == simulation.dt());
                CHECK(divergence->limit == simulation.stability_limit());
                CHECK(divergence->cause == Divergence::Cause::past_the_limit);
                CHECK(divergence->message.find('\n') == std::string::npos);
                CHECK(divergence->message.find("column " + std::to_string(divergence->column)) != std::string::npos);
                CHECK(divergence->message.find("stable however") != std::string::npos);
                CHECK((divergence->message.find("noise grows tenfold") != std::string::npos) ==
                      simulation.live_limit().has_value());

                // And again: the same from the same state
                std::optional<Divergence> again;
                while (!again && simulation.time() < 40.0) again = simulation.advance_steps(40);
                REQUIRE(again);
                CHECK(again->step == divergence->step);
                CHECK(again->message == divergence->message);
            }
}

TEST_CASE("How its steps are grouped does not change where a run diverges", "[physics]") {
    for (const auto precision : precisions)
        for (const double excess : {1.2, 2.0, 30.0}) {
            Scene scene = flag(method_id<SemiImplicitEuler>, precision);
            scene.time.dt = excess * limit_of(scene);
            Simulation by_batch(scene), by_step(scene);
            by_batch.use_exact_dt(), by_step.use_exact_dt();
            std::optional<Divergence> in_batch, in_step;
            while (!in_batch && by_batch.steps() < 6000) in_batch = by_batch.advance_steps(60);
            while (!in_step && by_step.steps() < 6000) in_step = by_step.advance_steps(1);
            REQUIRE(in_batch);
            REQUIRE(in_step);
            INFO(excess << " times the limit");
            CHECK(in_batch->message == in_step->message);
            CHECK(by_batch.steps() == by_step.steps());
            CHECK(by_batch.state_hash() == by_step.state_hash());
        }
}

TEST_CASE("The step that the message names holds", "[physics]") {
    for (const auto method : limited_methods())
        for (const auto precision : precisions) {
            Scene scene = flag(method, precision);
            if (method == method_id<ForwardEuler>) scene.springs->drag = 0.1;  // a step worth taking
            scene.time.dt = 2.0 * std::max(limit_of(scene), limit_of(flag(method_id<SemiImplicitEuler>, precision)));
            Simulation simulation(scene);
            const auto divergence = run_until_divergence(simulation, 600);
            INFO(name_of(method));
            REQUIRE(divergence);
            REQUIRE(divergence->safe_dt > 0.0);
            const double time = simulation.time();
            scene.time.dt = divergence->safe_dt;
            simulation.change(scene);
            CHECK(simulation.dt() <= divergence->safe_dt);
            CHECK(simulation.time() == time);
            CHECK_FALSE(run_until_divergence(simulation, method == method_id<ForwardEuler> ? 30 : 300));
            CHECK(is_finite(simulation));
            CHECK(simulation.readings().max_stretch < 0.5);
        }
}

TEST_CASE("Auto is a step within the bound, and runs", "[physics]") {
    for (const auto method : limited_methods())
        for (const auto precision : precisions) {
            if (method == method_id<ForwardEuler>) continue;  // its steps are tiny: tested below
            Simulation simulation(flag(method, precision));
            INFO(name_of(method));
            CHECK(simulation.dt() <= 0.75 * simulation.stability_limit().seconds() * (1.0 + 1e-8));
            CHECK(simulation.dt() > 0.1 * simulation.stability_limit().seconds());
            CHECK_FALSE(run_until_divergence(simulation, 300));
            CHECK(simulation.lowered_because().empty());
        }
}

TEST_CASE("Where every step is stable auto is the method's coarsest, and smaller where that is too coarse",
          "[physics]") {
    for (const auto precision : precisions) {
        Simulation implicit(flag(method_id<ImplicitEuler>, precision));
        CHECK(implicit.stability_limit().is_unlimited());
        CHECK(implicit.dt() == Approx(batch_seconds));
        CHECK_FALSE(run_until_divergence(implicit, 300));
        CHECK(implicit.lowered_because().empty());

        // Six steps a batch make these springs much too soft: they would hold more than there is energy for.
        Simulation soft(flag(method_id<Xpbd>, precision));
        CHECK(soft.dt() <= 2.0 * std::sqrt(0.001 / 1600.0));
        CHECK(soft.dt() > std::sqrt(0.001 / 1600.0));
        CHECK_FALSE(run_until_divergence(soft, 300));
        CHECK(is_finite(soft));
        CHECK(soft.readings().max_stretch < 0.5);
        CHECK(soft.lowered_because().empty());
    }
}

TEST_CASE("Less damping, a smaller automatic step", "[physics]") {
    double before = 1.0;
    for (const double drag : {1e-2, 1e-3, 1e-4, 1e-5, 0.0}) {
        Scene scene = flag(method_id<Leapfrog>, Precision::double_precision);
        scene.wind().reset();
        scene.springs->damping.reset();
        if (drag > 0.0)
            scene.springs->drag = drag;
        else
            scene.springs->drag.reset();
        const Simulation simulation(scene);
        const double share = simulation.dt() / simulation.stability_limit().seconds();
        CHECK(share < before);
        before = share;
    }
    CHECK(before == Approx(0.3).epsilon(0.05));  // made a whole number of steps a batch
}

namespace {

/// Crumpled and stretched, hardly damped: at three quarters of the bound it heats up tenfold and more.
Scene violent() {
    Scene scene;
    scene.flag.columns = 12, scene.flag.rows = 9;
    scene.flag.width = 0.55, scene.flag.height = 0.4;
    scene.flag.start = Start::crumpled;
    scene.flag.prestretch = 0.8;
    scene.springs = {
        .mass = 1e-4, .stiffness = 300.0, .diagonal_stiffness = 150.0, .damping = 1e-4, .drag = 5e-4, .friction = {}};
    scene.gravity() = Gravity{};
    scene.time.precision = Precision::double_precision;
    return scene;
}

}  // namespace

TEST_CASE("Energy created by an automatic step takes the run back, and it goes on with a smaller one", "[physics]") {
    Simulation automatic(violent());
    const double usual = automatic.dt();
    Scene fine = violent(), coarse = violent();
    fine.time.dt = usual / 8.0;
    coarse.time.dt = usual;
    Simulation exact(fine), stubborn(coarse);
    bool lowered = false;
    std::optional<Divergence> divergence;
    for (int n = 1; n <= 120; ++n) {
        REQUIRE_FALSE(automatic.advance_batch());
        REQUIRE_FALSE(exact.advance_batch());
        if (!divergence) divergence = stubborn.advance_batch();
        lowered = lowered || !automatic.lowered_because().empty();
        CHECK(std::abs(automatic.time() - n * batch_seconds) < 1e-9);
    }
    CHECK(lowered);
    REQUIRE(divergence);  // the same step, given as a number, stops
    CHECK(divergence->cause == Divergence::Cause::energy_created);
    // Chaotic motion agrees in its statistics: energies within a factor of two.
    const auto a = automatic.readings(), b = exact.readings();
    const double ratio = (a.kinetic_energy + a.spring_energy) / (b.kinetic_energy + b.spring_energy);
    CHECK(ratio < 2.0);
    CHECK(ratio > 0.5);
}

TEST_CASE("An automatic step that was lowered grows again when the motion has calmed", "[physics]") {
    Simulation simulation(violent());
    const double usual = simulation.dt();
    double smallest = usual;
    for (int n = 0; n < 60 * 30; ++n) {
        REQUIRE_FALSE(simulation.advance_batch());
        smallest = std::min(smallest, simulation.dt());
    }
    CHECK(smallest < 0.7 * usual);
    CHECK(simulation.dt() == usual);
}

TEST_CASE("Forward Euler without drag or friction: auto says which damping is needed, and that damping runs",
          "[physics]") {
    for (const auto precision : precisions) {
        Scene scene = flag(method_id<ForwardEuler>, precision);
        scene.springs->drag.reset();
        scene.wind().reset();
        std::string message;
        try {
            const Simulation simulation(scene);
        } catch (const InputError& error) {
            message = error.what();
        }
        REQUIRE(message.find("time.dt") != std::string::npos);
        REQUIRE(message.find("N·s/m") != std::string::npos);
        CHECK(message.find("semi-implicit-euler") != std::string::npos);

        // "... their sum must exceed X N·s/m ..."
        const std::string before = "must exceed ";
        const auto place = message.find(before);
        REQUIRE(place != std::string::npos);
        const double needed = std::stod(message.substr(place + before.size()));
        scene.springs->friction = 1.1 * needed;
        Simulation simulation(scene);
        CHECK(simulation.stability_limit().is_finite());
        CHECK_FALSE(run_until_divergence(simulation, 120));
        CHECK(is_finite(simulation));
    }
}

TEST_CASE("Explaining a divergence can be abandoned", "[physics]") {
    Scene scene = flag(method_id<SemiImplicitEuler>, Precision::double_precision);
    scene.time.dt = 3.0 * limit_of(scene);
    Simulation simulation(scene);
    std::atomic<bool> abandon{false};
    // The flag is set before the batch that diverges begins its explanation: nothing is replayed to the end.
    std::optional<Divergence> divergence;
    for (int n = 0; n < 600 && !divergence; ++n) divergence = simulation.advance_batch();
    REQUIRE(divergence);
    abandon = true;
    const auto hash = simulation.state_hash();
    CHECK_FALSE(simulation.advance_batch(&abandon));
    CHECK(simulation.state_hash() == hash);
}

TEST_CASE("No finite setting, however extreme, shows a value that is not finite", "[physics]") {
    struct Extreme {
        const char* name;
        void (*apply)(Scene&);
    };
    const Extreme extremes[] = {
        {"hurricane of 1e6 m/s",
         [](Scene& s) {
             s.wind()->velocity = {1e6, 0.0, 1e6};
         }},
        {"gusts of 1e6 m/s",
         [](Scene& s) {
             s.wind()->gusts = {1e6, 1e6, 1e6};
         }},
        {"travelling gusts of 1e6 m/s",
         [](Scene& s) {
             s.wind()->gusts = {1e6, 1e6, 1e6};
             s.wind()->travelling = true;
         }},
        {"stiffness 1e8", [](Scene& s) { s.springs->stiffness = 1e8; }},
        {"stiffness 1e8 at a numeric step", [](Scene& s) { s.springs->stiffness = 1e8, s.time.dt = 1e-3; }},
        {"a step a million times too large", [](Scene& s) { s.time.dt = 1e3; }},
        {"a mass of 1e-9 kg", [](Scene& s) { s.springs->mass = 1e-9, s.time.dt = 1e-3; }},
        {"gravity of 1e6 m/s2",
         [](Scene& s) {
             s.gravity()->acceleration = {0.0, -1e6, 0.0};
         }},
        {"drag beyond its own limit", [](Scene& s) { s.springs->drag = 10.0, s.time.dt = 1.0 / 60.0; }},
        {"damping beyond its own limit", [](Scene& s) { s.springs->damping = 10.0, s.time.dt = 1.0 / 60.0; }},
        {"everything held", [](Scene& s) { s.flag.attach = Attach::all; }},
        {"nothing held", [](Scene& s) { s.flag.attach = Attach::none; }},
        {"two masses", [](Scene& s) { s.flag.columns = 2, s.flag.rows = 1; }},
        {"crumpled", [](Scene& s) { s.flag.start = Start::crumpled; }},
        {"every mass in one place", [](Scene& s) { s.flag.prestretch = -0.999999; }},
        {"a limit that cannot be met",
         [](Scene& s) {
             s.flag.attach = Attach::edges, s.flag.prestretch = 0.5;
             s.limits.add(StretchLimit{.stretch = 0.01});
         }},
    };
    for (const auto& extreme : extremes)
        for (const auto method : all_methods())
            for (const auto precision : precisions) {
                INFO(extreme.name << ", " << name_of(method));
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
