// Tolerance: an automatic step that is small enough and not needlessly so, the same on any machine, and that does not
// follow every gust.
#include "catch.hpp"
#include "io/error.hpp"
#include "run/simulation.hpp"
#include "run/tolerance_step.hpp"
#include "scene/file.hpp"

#include "drapeau/stability.hpp"

#include <cmath>
#include <vector>

using namespace drapeau;

namespace {

using Verdict = ErrorEstimate::Verdict;

ErrorEstimate estimate_of(double rate, double dt, int order = 1) {
    ErrorEstimate estimate;
    estimate.verdict = Verdict::resolved;
    estimate.rate = estimate.apart = estimate.by_method = rate;
    estimate.dt = dt, estimate.order = order;
    return estimate;
}
ErrorEstimate unresolved(Verdict verdict, double apart, double dt) {
    auto estimate = estimate_of(NAN, dt);
    estimate.verdict = verdict, estimate.apart = apart;
    return estimate;
}

/// A taut sheet that vibrates for ever in many modes, none of them damped: its error is much the same at any time.
Scene membrane(Method method, double tolerance) {
    Scene scene;
    scene.flag = {.columns = 9,
                  .rows = 7,
                  .width = 0.8,
                  .height = 0.6,
                  .attach = Attach::edges,
                  .start = Start::flat,
                  .prestretch = 0.1,
                  .disturbance = 0.003,
                  .texture = ""};
    scene.springs = {
        .mass = 0.001, .stiffness = 200.0, .diagonal_stiffness = 100.0, .damping = {}, .drag = {}, .friction = {}};
    scene.time = {.method = method, .dt = {}, .precision = Precision::double_precision, .tolerance = tolerance};
    return scene;
}

/// A flag in gusts that come and go.
Scene gusty(double tolerance) {
    Scene scene;
    scene.flag.columns = 11, scene.flag.rows = 7;
    scene.springs = {
        .mass = 0.001, .stiffness = 200.0, .diagonal_stiffness = 100.0, .damping = 0.02, .drag = 0.004, .friction = {}};
    scene.gravity() = Gravity{};
    scene.wind() = Wind{.velocity = {4.0, 0.0, 1.0}, .gusts = {2.0, 0.5, 3.0}};
    scene.time = {.method = method_id<SemiImplicitEuler>,
                  .dt = {},
                  .precision = Precision::double_precision,
                  .tolerance = tolerance};
    return scene;
}

void run(Simulation& simulation, int batches) {
    for (int n = 0; n < batches; ++n) REQUIRE_FALSE(simulation.advance_batch());
}

/// Against a run of the classical Runge-Kutta method at a thirtieth of the step, over a tenth of a second from now.
double true_error(const Simulation& simulation) {
    const ErrorWindow window = simulation.error_window();
    const Model& model = simulation.model();
    const auto moved = [&](Method method, long long steps) {
        const auto engine = make_engine(model, method, Precision::double_precision);
        engine->set(window.state);
        Report ignored;
        const Clock clock{window.time, 0, window.seconds / static_cast<double>(steps)};
        engine->advance(clock, 0, steps, no_step, ignored, nullptr);
        return engine->state(clock.at(steps)).position;
    };
    const long long steps = std::llround(window.seconds / simulation.dt());
    const auto x = moved(simulation.scene().time.method, steps), exact = moved(method_id<Rk4>, 30 * steps);
    double squares = 0.0;
    long long free = 0;
    for (int j = 0; j < x.rows(); ++j)
        for (int i = 0; i < x.columns(); ++i) {
            if (model.held(i, j)) continue;
            const auto d = x.at(i, j) - exact.at(i, j);
            squares += d.x * d.x + d.y * d.y + d.z * d.z;
            ++free;
        }
    return std::sqrt(squares / static_cast<double>(free)) / window.seconds;
}

}  // namespace

TEST_CASE("A tolerance is met and no more than a quarter of the steps is wasted", "[physics][accuracy]") {
    for (const auto& [method, tolerance] :
         {std::pair{method_id<SemiImplicitEuler>, 5e-4}, {method_id<Leapfrog>, 1e-4}, {method_id<Rk4>, 2e-7}}) {
        Simulation simulation(membrane(method, tolerance));
        Scene without = membrane(method, tolerance);
        without.time.tolerance.reset();
        INFO(name_of(method));
        CHECK(simulation.dt() < Simulation(without).dt());
        run(simulation, 10 * 60);  // the step has settled
        double most = 0.0;
        for (int second = 0; second < 5; ++second) {
            run(simulation, 60);
            most = std::max(most, true_error(simulation));
        }
        INFO("true error " << most << " m/s, asked " << tolerance << ", " << simulation.steps_per_batch()
                           << " steps a batch, " << simulation.step_reason());
        CHECK(most <= tolerance);
        // So many steps would have done for the error to be what was asked.
        const int order = with_method(method, [](const auto& m) { return std::decay_t<decltype(m)>::order; });
        const double steps = static_cast<double>(simulation.steps_per_batch());
        CHECK(0.75 * steps <= steps * std::pow(most / tolerance, 1.0 / order));
        CHECK(simulation.step_reason().find("mm/s asked") != std::string::npos);
    }
}

TEST_CASE("What stability asks for is enough where the tolerance is wide", "[accuracy]") {
    Scene wide = gusty(1.0), without = wide;
    without.time.tolerance.reset();
    Simulation a(wide), b(without);
    run(a, 200), run(b, 200);
    CHECK(a.dt() == b.dt());
    CHECK(a.state_hash() == b.state_hash());
    CHECK(a.step_reason() == "limit: stiffness of the springs");
    REQUIRE(a.error());
    CHECK(a.error()->resolved());
    CHECK_FALSE(b.error());  // nobody asked
}

TEST_CASE("Watching the error does not alter the run, and a wide tolerance shows the same error",
          "[accuracy][threads]") {
    Scene scene = gusty(1.0);
    Simulation asked(scene);
    scene.time.tolerance.reset();
    Simulation watched(scene), alone(scene);
    watched.watch_error(ErrorWatch::Mode::awaited);
    run(asked, 130), run(watched, 130), run(alone, 130);
    CHECK(watched.state_hash() == alone.state_hash());
    REQUIRE(watched.error());
    REQUIRE(asked.error());
    CHECK(watched.error()->rate == asked.error()->rate);

    Simulation aside(scene);
    aside.watch_error(ErrorWatch::Mode::aside);
    for (int n = 0; n < 10000 && !aside.error(); ++n) run(aside, 1);
    CHECK(aside.error());
}

TEST_CASE("A tolerance gives the same steps however they are grouped and shared among threads", "[accuracy]") {
    Scene scene = gusty(5e-4);
    scene.wind()->gusts = {1.0, 0.5, 1.0};  // calms down, so that the step grows
    Simulation a(scene), b(scene), single(scene);
    std::vector<long long> steps_of_a, steps_of_b;
    for (int n = 0; n < 400; ++n) {
        run(a, 1), run(b, 1);
        steps_of_a.push_back(a.steps()), steps_of_b.push_back(b.steps());
    }
    CHECK(steps_of_a == steps_of_b);
    CHECK(a.state_hash() == b.state_hash());
    CHECK(a.steps() != a.steps_per_batch() * 400);  // the step has changed on the way
    while (single.steps() < a.steps()) REQUIRE_FALSE(single.advance_steps(1));
    CHECK(single.state_hash() == a.state_hash());

    scene.flag.columns = 70, scene.flag.rows = 67;  // enough masses for threads to be worth it
    scene.springs->mass = 0.01, scene.springs->drag = 0.04;
    scene.time.tolerance = 2e-3;
    Simulation alone(scene), together(scene);
    together.use_threads(3);
    run(alone, 70), run(together, 70);
    CHECK(alone.step_reason().find("mm/s asked") != std::string::npos);
    CHECK(alone.steps() == together.steps());
    CHECK(alone.state_hash() == together.state_hash());
    CHECK(alone.error());
}

TEST_CASE("A wind that changes does not make the step chatter", "[accuracy]") {
    Simulation simulation(gusty(1e-3));
    int changes = 0, wishes = 0, estimates = 0;
    double dt = simulation.dt();
    std::optional<ErrorEstimate> before;
    for (int n = 0; n < 60 * 60; ++n) {
        run(simulation, 1);
        changes += simulation.dt() != dt;
        dt = simulation.dt();
        const auto& error = simulation.error();
        if (!error || (before && before->rate == error->rate)) continue;
        ++estimates;
        wishes += before && (error->rate > 1.2 * before->rate || before->rate > 1.2 * error->rate);
        before = error;
    }
    INFO(changes << " changes, " << wishes << " of " << estimates << " estimates differ by a fifth");
    CHECK(wishes > estimates / 2);    // the wind does change the error
    CHECK(changes <= estimates / 4);  // six estimates a cycle at least, and fewer than that
}

TEST_CASE("The step shrinks after two estimates in a row or one far above, grows after four, and stays in between",
          "[accuracy]") {
    const double usual = batch_seconds / 20.0, dt = batch_seconds / 100.0, tolerance = 1e-3;
    const auto above = estimate_of(1.6e-3, dt), below = estimate_of(0.3e-3, dt), near = estimate_of(0.95e-3, dt);
    ToleranceStep step;
    CHECK(std::isinf(step.allowed()));
    CHECK_FALSE(step.take_in(above, tolerance, usual));
    CHECK_FALSE(step.take_in(near, tolerance, usual));
    CHECK_FALSE(step.take_in(above, tolerance, usual));  // the row begins anew
    CHECK(step.take_in(above, tolerance, usual));
    CHECK(step.allowed() == Approx(dt * 0.9 / 1.6));

    ToleranceStep growing;
    for (int n = 0; n < 3; ++n) CHECK_FALSE(growing.take_in(below, tolerance, usual));
    CHECK(growing.take_in(estimate_of(0.5e-3, dt), tolerance, usual));
    CHECK(growing.allowed() == Approx(dt * 0.9 / 0.5));  // as far as the largest of the four errors lets it
    ToleranceStep fast;
    for (int n = 0; n < 4; ++n) fast.take_in(estimate_of(1e-9, dt), tolerance, usual);
    CHECK(fast.allowed() == Approx(2.0 * dt));
    // Never beyond what stability allows.
    ToleranceStep bound;
    for (int n = 0; n < 4; ++n) bound.take_in(estimate_of(1e-9, usual / 1.5), tolerance, usual);
    CHECK(bound.allowed() == Approx(usual));
    // By the order: 16 times the error is twice the steps of a method of order 4.
    ToleranceStep fourth;
    for (int n = 0; n < 2; ++n) fourth.take_in(estimate_of(1.8e-3, dt, 4), tolerance, usual);
    CHECK(fourth.allowed() == Approx(dt * 0.9 * std::pow(1.8, -0.25)));
    // One estimate of more than twice the tolerance is enough.
    ToleranceStep far;
    CHECK(far.take_in(estimate_of(2.25e-3, dt, 2), tolerance, usual));
    CHECK(far.allowed() == Approx(0.6 * dt));
    CHECK(far.take_in(estimate_of(1.0, dt), tolerance, usual));
    CHECK(far.allowed() == Approx(0.5 * dt));
}

TEST_CASE("Where the error is not resolvable the step stays, unless it is too coarse", "[accuracy]") {
    const double usual = batch_seconds / 20.0, dt = batch_seconds / 100.0, tolerance = 1e-3;
    for (const auto verdict :
         {Verdict::unmeasured, Verdict::chaos, Verdict::rounding, Verdict::limit, Verdict::not_finite}) {
        ToleranceStep step;
        for (int n = 0; n < 10; ++n) CHECK_FALSE(step.take_in(unresolved(verdict, 1.0, dt), tolerance, usual));
        CHECK_FALSE(step.lower_at_once(unresolved(verdict, 1.0, dt), tolerance));
    }
    ToleranceStep coarse;
    CHECK_FALSE(coarse.take_in(unresolved(Verdict::coarse, 1.0, dt), tolerance, usual));
    CHECK(coarse.take_in(unresolved(Verdict::coarse, 1.0, dt), tolerance, usual));
    CHECK(coarse.allowed() == Approx(0.5 * dt));
    ToleranceStep within;
    for (int n = 0; n < 10; ++n) within.take_in(unresolved(Verdict::coarse, 0.5e-3, dt), tolerance, usual);
    CHECK(std::isinf(within.allowed()));
}

TEST_CASE("A tolerance that float cannot meet is met in double", "[accuracy]") {
    Scene scene = gusty(1e-6);
    scene.time.method = method_id<Rk4>;
    scene.time.precision = Precision::single_precision;
    Simulation simulation(scene);
    run(simulation, 70);
    CHECK(simulation.precision() == Precision::double_precision);
    CHECK_FALSE(simulation.precision_remark().empty());
    // A change of strengths keeps it so.
    scene.wind()->velocity.x = 4.5;
    simulation.change(scene);
    CHECK(simulation.precision() == Precision::double_precision);
    scene.time.tolerance = 1e-2;
    simulation.change(scene);
    CHECK(simulation.precision() == Precision::single_precision);
}

TEST_CASE("A tolerance goes with an automatic step only", "[accuracy]") {
    Scene scene = gusty(1e-3);
    scene.time.dt = 1e-4;
    CHECK_THROWS_WITH(Simulation(scene),
                      ContainsSubstring("time.tolerance = 0.001: goes with time.dt = \"auto\" only"));
}

TEST_CASE("The reason of a step is told", "[accuracy]") {
    Scene scene = gusty(1e-3);
    scene.time.tolerance.reset();
    CHECK(Simulation(scene).step_reason() == "limit: stiffness of the springs");
    scene.springs->damping = 5.0;
    CHECK(Simulation(scene).step_reason() == "limit: damping of the springs");
    scene.springs->damping = 0.0, scene.springs->drag = 10.0;
    CHECK(Simulation(scene).step_reason() == "limit: drag and friction");
    scene = gusty(1e-3);
    CHECK(Simulation(scene).step_reason().ends_with(" of 1 mm/s asked"));
    scene.time.tolerance.reset(), scene.springs->mass = 100.0;
    CHECK(Simulation(scene).step_reason() == "limit: 1/60 s");
    scene.time.dt = 1e-4;
    CHECK(Simulation(scene).step_reason() == "given");
}
