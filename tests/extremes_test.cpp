// Extremes: what runs at the edges of what a scene can say have shown (tests/extremes/), each as a law of its own; and
// that those runs are drawn as they should be.
#include "catch.hpp"
#include "extremes/case.hpp"
#include "io/error.hpp"
#include "run/engine.hpp"
#include "run/simulation.hpp"
#include "sanitized.hpp"
#include "scene/file.hpp"

#include "drapeau/stability.hpp"

#include <cmath>
#include <ctime>
#include <numeric>

using namespace drapeau;
using extremes::Begin;
using extremes::Cases;
using testing::sanitized;

namespace {

/// Nine by six masses, five centimetres apart.
Scene sheet(Method method, Precision precision = Precision::double_precision) {
    Scene scene;
    scene.flag.columns = 9, scene.flag.rows = 6;
    scene.flag.width = 0.4, scene.flag.height = 0.25;
    scene.springs = {
        .mass = 1e-3, .stiffness = 200.0, .diagonal_stiffness = 100.0, .damping = {}, .drag = {}, .friction = {}};
    scene.time = {method, {}, precision};
    return scene;
}

bool is_finite(const Simulation& simulation) {
    const auto state = simulation.state();
    const auto readings = simulation.readings();
    double sum = readings.kinetic_energy + readings.spring_energy + readings.rms_spring_force;
    for (const auto* field : {&state.position, &state.velocity})
        for (int c = 0; c < 3; ++c) sum += std::accumulate(field->component(c).begin(), field->component(c).end(), 0.0);
    return std::isfinite(sum);
}

}  // namespace

TEST_CASE("Every pair of extremes stands together in a case, and few cases have all", "[extremes]") {
    const auto levels = extremes::level_counts();
    const auto rows = extremes::covering(levels, 7);
    for (std::size_t a = 0; a < levels.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) {
            std::vector<char> seen(static_cast<std::size_t>(levels[a]) * levels[b], 0);
            for (const auto& row : rows) seen[static_cast<std::size_t>(row[a]) * levels[b] + row[b]] = 1;
            INFO("factors " << a << " and " << b);
            CHECK(std::accumulate(seen.begin(), seen.end(), 0) == levels[a] * levels[b]);
        }
    // No set can be smaller than the two largest factors' levels multiplied.
    auto sorted = levels;
    std::sort(sorted.rbegin(), sorted.rend());
    CHECK(static_cast<int>(rows.size()) < 2 * sorted[0] * sorted[1]);
}

TEST_CASE("A case is the same whenever it is asked for, and every method has some", "[extremes]") {
    const Cases cases(3), again(3);
    std::vector<int> of_method(method_count, 0);
    for (long long n = 0; n < 400; ++n) {
        const auto one = cases.at(n), other = again.at(n);
        CHECK(one.scene == other.scene);
        CHECK((one.begin == other.begin && one.threads == other.threads && one.exact_dt == other.exact_dt));
        ++of_method[static_cast<std::size_t>(one.scene.time.method)];
    }
    for (const int count : of_method) CHECK(count > 400 / (2 * static_cast<int>(method_count)));
}

TEST_CASE("Whatever moment a run is looked at, its values are finite", "[extremes]") {
    for (const auto precision : {Precision::single_precision, Precision::double_precision})
        for (const double excess : {3.0, 100.0, 1e4}) {
            // Far less than a batch, and one step a batch.
            for (const double mass : {1e-9, 0.1}) {
                Scene scene = sheet(method_id<SemiImplicitEuler>, precision);
                scene.springs->mass = mass;
                scene.gravity().emplace();
                const double limit = stable_step(scene.time.method, model_of(scene)).seconds();
                scene.time.dt = excess * limit;
                INFO(excess << " times the limit, mass " << mass);
                Simulation simulation(scene);
                simulation.use_exact_dt();
                std::optional<Divergence> divergence;
                for (int n = 0; n < 3000 && !divergence; ++n) {
                    divergence = simulation.advance_steps(1);
                    REQUIRE(is_finite(simulation));
                }
                REQUIRE(divergence);
                CHECK(divergence->cause == Divergence::Cause::past_the_limit);
            }
        }
}

TEST_CASE("Drag past its limit brings in no energy: a run it throws to and fro diverges", "[extremes]") {
    // v changes by the factor 1 - b a step: b = 2.1 lets it grow by a tenth.
    for (const bool windy : {false, true}) {
        Scene scene = sheet(method_id<ForwardEuler>);
        scene.springs->mass = 10.0, scene.springs->stiffness = 1e-3, scene.springs->diagonal_stiffness.reset();
        scene.springs->drag = 1e4;
        scene.gravity().emplace();
        if (windy) scene.wind().emplace().velocity = {5.0, 0.0, 1.0};
        scene.time.dt = 2.1 * scene.springs->mass / *scene.springs->drag;
        Simulation simulation(scene);
        simulation.use_exact_dt();
        auto divergence = simulation.advance_steps(1000);
        if (!divergence) divergence = simulation.check();
        CHECK(divergence);
    }
}

TEST_CASE("An automatic step that a short run shows to be too large is answered with a smaller one", "[extremes]") {
    // A mass on a spring in wind and gravity a thousand times as strong as on Earth: looked at before the first window
    // of the ledger has ended.
    Scene scene;
    scene.flag.columns = 2, scene.flag.rows = 1;
    scene.flag.width = 1.0;
    scene.springs = {
        .mass = 1e-3, .stiffness = 1e6, .diagonal_stiffness = {}, .damping = {}, .drag = 1e-3, .friction = {}};
    scene.gravity().emplace().acceleration = {0.0, -1e4, 0.0};
    scene.wind().emplace().velocity = {1000.0, 0.0, 200.0};
    scene.time = {method_id<Leapfrog>, {}, Precision::double_precision};
    Simulation simulation(scene);
    simulation.put(State<double>(2, 1));  // both in one place
    const double usual = simulation.dt();
    CHECK_FALSE(simulation.advance_steps(std::llround(0.057 / usual)));
    CHECK_FALSE(simulation.check());
    CHECK(simulation.dt() < usual);
    CHECK(simulation.time() == Approx(0.057).margin(usual));
}

TEST_CASE("However strong its dampers, xpbd keeps its automatic step", "[extremes]") {
    // What such dampers take in the midst of a step is unknown at its end: far too much would be counted.
    Scene scene = sheet(method_id<Xpbd>);
    scene.springs->damping = 1e5;
    scene.springs->drag = 0.04;
    scene.gravity().emplace();
    scene.wind().emplace().velocity = {3.0, 0.0, 0.6};
    Simulation simulation(scene);
    const double usual = simulation.dt();
    for (int n = 0; n < 20; ++n) REQUIRE_FALSE(simulation.advance_batch());
    CHECK(simulation.dt() == usual);
}

TEST_CASE("Where steps are too short to move a mass, its fall is not called created", "[extremes]") {
    // Terminal velocity m g / c_f = 10^-8 m/s: in a step 10^-17 m, below a unit of a place of some metres. Stopped by
    // friction or not, it is far from a billionth of the flag's size in all.
    for (const double friction : {0.0, 1e6}) {
        Scene scene = sheet(method_id<ForwardEuler>);
        scene.flag.height = 5.0;
        scene.springs->damping = 0.05;
        if (friction > 0.0) scene.springs->friction = friction;
        scene.gravity().emplace().acceleration = {0.0, friction > 0.0 ? -9.8 : -1e-6, 0.0};
        scene.time.dt = friction > 0.0 ? 1e-9 : 1e-7;
        Simulation simulation(scene);
        simulation.use_exact_dt();
        CHECK_FALSE(simulation.advance_steps(2500));
        CHECK_FALSE(simulation.check());
    }
}

TEST_CASE("An automatic step of leapfrog does not let drag throw velocities to and fro", "[extremes]") {
    Scene scene = sheet(method_id<Leapfrog>);
    scene.flag.prestretch = 0.5;
    scene.springs->stiffness = 1e-3, scene.springs->diagonal_stiffness.reset();
    scene.springs->drag = 10.0;
    scene.wind().emplace().velocity = {2.0, 0.0, 0.4};
    Simulation simulation(scene);
    CHECK(simulation.dt() * *scene.springs->drag <= scene.springs->mass * (1.0 + 1e-9));
    for (int n = 0; n < 10; ++n) REQUIRE_FALSE(simulation.advance_batch());
    CHECK_FALSE(simulation.check());
    // Drag holds the loose cloth: it goes with the wind.
    CHECK(simulation.state().velocity.at(8, 3).x == Approx(2.0).epsilon(0.01));
}

TEST_CASE("Far from the origin float gives way to double, or is refused", "[extremes]") {
    Scene scene = sheet(method_id<SemiImplicitEuler>, Precision::single_precision);
    scene.gravity().emplace();
    auto far = Simulation(scene).state();
    for (int j = 0; j < 6; ++j)
        for (int i = 0; i < 9; ++i) far.position.set(i, j, far.position.at(i, j) + glm::dvec3{6e4, 0.0, 8e4});
    Simulation automatic(scene);
    automatic.put(far);
    CHECK(automatic.precision() == Precision::double_precision);
    CHECK(automatic.state().position.at(8, 5).z == Approx(8e4));
    CHECK_FALSE(automatic.advance_batch());

    scene.time.dt = 1e-4;
    Simulation given(scene);
    const auto hash = given.state_hash();
    CHECK_THROWS_AS(given.put(far), InputError);
    CHECK(given.state_hash() == hash);
}

TEST_CASE("An automatic step that no machine can follow is refused, and the flag that flies stays", "[extremes]") {
    Scene scene = sheet(method_id<SemiImplicitEuler>);
    Simulation flying(scene);
    flying.advance_batch();
    const auto hash = flying.state_hash();
    scene.springs->mass = 1e-9, scene.springs->stiffness = 1e9;
    scene.springs->diagonal_stiffness.reset();
    scene.springs->damping = 1e3;  // limit about m/(8 c) = 10^-13 s
    CHECK_THROWS_WITH(Simulation(scene), ContainsSubstring("is the least"));
    CHECK_THROWS_AS(flying.change(scene), InputError);
    CHECK(flying.state_hash() == hash);
    CHECK_FALSE(flying.advance_batch());
}

TEST_CASE("Explaining a divergence costs no more than a second or so, however short the steps", "[extremes]") {
    // A few thousand of the shortest steps: what a second of work allows is some hundred thousand; a batch has
    // millions.
    Scene scene = sheet(method_id<SemiImplicitEuler>);
    scene.springs->mass = 1e-9, scene.springs->stiffness = 1e8, scene.springs->diagonal_stiffness.reset();
    scene.gravity().emplace().acceleration = {0.0, -1e4, 0.0};
    scene.flag.start = Start::crumpled;
    scene.time.dt = 1.2 * stable_step(scene.time.method, model_of(scene)).seconds();
    Simulation simulation(scene);
    simulation.use_exact_dt();
    const auto processor_seconds = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
    const double start = processor_seconds();
    auto divergence = simulation.advance_steps(3000);
    if (!divergence) divergence = simulation.check();
    const double explained = processor_seconds() - start;
    REQUIRE(divergence);
    CHECK(divergence->step <= 3000);

    constexpr long long many = 200'000;
    const auto engine = make_engine(model_of(scene), scene.time.method, scene.time.precision);
    Report ignored;
    const double plain_start = processor_seconds();
    engine->advance({.dt = 1e-9}, 0, many, no_step, ignored, nullptr);
    CHECK(explained < 10.0 * (processor_seconds() - plain_start));
}

TEST_CASE("Ten million steps of a sheet that nothing damps: its energy does not drift", "[physics]") {
    // A symplectic method keeps a shadow energy for exponentially long times, so the energy of v-.v+ swings within
    // bounds that a hundredth of the run has shown; were it to drift, it would be a hundred times as far. Nearly linear
    // motion at omega dt = 0.25 keeps it to (omega dt)^2 A/L. Rounding adds a random walk: of places up to X = 0.5 m a
    // spring is known to eps X, so each step works k eps X v dt on each of the springs.
    constexpr long long all = sanitized ? 500'000 : 10'000'000, look = 1000, known = all / (sanitized ? 10 : 100);
    const Model model(spread(4, 4, 0.3, 0.3), {1e-3, 100.0, 50.0, {}}, Attach::hoist);
    const double dt = 0.125 * stable_step(method_id<Leapfrog>, model).seconds();
    const auto engine = make_engine(model, method_id<Leapfrog>, Precision::double_precision);
    auto state = engine->state(0.0);
    for (int j = 0; j < 4; ++j)
        for (int i = 1; i < 4; ++i)
            state.position.set(
                i, j, state.position.at(i, j) + 1e-4 * glm::dvec3{std::sin(5.0 * i + j), std::cos(3.0 * j - i), 0.0});
    engine->set(state);
    const Clock clock{.dt = dt};
    Report ignored;
    double first = 0.0, early = 0.0, late = 0.0;  // J; the farthest from the first, in a hundredth and in all
    for (long long n = 0; n < all; n += look) {
        engine->advance(clock, n, n + look, no_step, ignored, nullptr);
        const double energy = engine->measure(clock.at(n + look)).total();
        if (n == 0) first = energy;
        late = std::max(late, std::abs(energy - first));
        if (n < known) early = late;
    }
    const double speed = std::sqrt(2.0 * first / 1e-3);
    const double walk =
        std::sqrt(static_cast<double>(all * model.springs_in_all())) * 100.0 * 0x1p-52 * 0.5 * speed * dt;
    INFO("early " << early / first << ", late " << late / first << ", walk " << walk / first);
    CHECK(early < 0.25 * 0.25 * 0.1 * first);
    CHECK(late < 2.0 * early + 3.0 * walk);
}
