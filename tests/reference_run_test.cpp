// Reference run: how far it says a run has gone is how far the run is from the exact motion, at equal times.
#include "catch.hpp"

#include "run/reference_run.hpp"
#include "viewer/simulation_thread.hpp"

#include <chrono>
#include <cmath>
#include <string>
#include <thread>

using namespace drapeau;

namespace {

/// One mass on a spring, stretched by a tenth of a metre and let go: A cos(omega t) about its rest.
struct MassOnSpring {
    double mass = 0.1, stiffness = 40.0, amplitude = 0.1;  // kg, N/m, m

    double omega() const { return std::sqrt(stiffness / mass); }
    Scene scene(double dt) const {
        Scene scene;
        scene.flag.columns = 1, scene.flag.rows = 2, scene.flag.height = 1.0;
        scene.flag.attach = Attach::corner;
        scene.flag.prestretch = amplitude;
        scene.springs->mass = mass, scene.springs->stiffness = stiffness;
        scene.time.precision = Precision::double_precision;
        scene.time.dt = dt;
        return scene;
    }
    double length(double t) const { return 1.0 + amplitude * std::cos(omega() * t); }
};

/// The newest comparison after so many batches of the run, each of which is followed.
ReferenceRun::Gap gap_after(Simulation& run, ReferenceRun& reference, int batches) {
    Snapshot here;
    for (int n = 0; n < batches; ++n) {
        REQUIRE_FALSE(run.advance_batch());
        run.snapshot(here);
        reference.follow(here);
    }
    reference.wait();
    CHECK(reference.trouble().empty());
    ReferenceRun::Gap gap;
    REQUIRE(reference.take(gap));
    return gap;
}

Scene flag_in_wind() {
    Scene scene;
    scene.flag.columns = 9, scene.flag.rows = 6;
    scene.springs->mass = 0.001, scene.springs->stiffness = 50.0, scene.springs->diagonal_stiffness = 20.0;
    scene.springs->damping = 0.002, scene.springs->drag = 0.003;
    scene.gravity() = Gravity{};
    scene.wind() = Wind{.velocity = {4.0, 0.0, 1.0}, .gusts = {1.0, 0.5, 1.0}};
    return scene;
}

}  // namespace

TEST_CASE("The distance from a reference is the distance from the exact motion", "[physics][accuracy][threads]") {
    const MassOnSpring spring;
    Simulation run(spring.scene(batch_seconds / 4.0));
    ReferenceRun reference(run.scene(), run.state(), run.time());
    constexpr int batches = 90;
    const auto gap = gap_after(run, reference, batches);
    const double t = batches * batch_seconds;
    CHECK(gap.since == 0.0);
    CHECK(gap.snapshot.time == Approx(t));
    const double wrong = std::abs(-run.state().position.at(0, 1).y - spring.length(t));
    CHECK(wrong > 1e-3);  // m
    // Pictures are in float: half a unit in the last place of a metre, of each of the two.
    const double rounding = 1.3e-7;
    // rk4: a phase of (omega dt)^5/120 a step.
    const double y = spring.omega() * gap.dt, phase = std::pow(y, 4) * spring.omega() * t / 120.0;
    CHECK(std::abs(gap.rms - wrong) <= rounding + spring.amplitude * phase);
    CHECK(gap.greatest == Approx(gap.rms));  // one mass is free
}

TEST_CASE("A run at the reference's own setting does not part from it", "[accuracy][threads]") {
    const Scene scene = reference_of(flag_in_wind());
    CHECK(scene.time.method == method_id<Rk4>);
    CHECK(scene.time.precision == Precision::double_precision);
    Simulation run(scene);
    for (int n = 0; n < 7; ++n) REQUIRE_FALSE(run.advance_batch());
    ReferenceRun reference(scene, run.state(), run.time());
    const auto gap = gap_after(run, reference, 30);
    CHECK(gap.since == Approx(7 * batch_seconds));
    CHECK(gap.rms == 0.0);
    // And another setting does, by what it is wrong.
    Scene coarse = flag_in_wind();
    Simulation other(coarse);
    ReferenceRun from_start(coarse, other.state(), other.time());
    CHECK(gap_after(other, from_start, 30).rms > 1e-5);
}

TEST_CASE("Moments between batches and before the reference are passed over", "[threads]") {
    const MassOnSpring spring;
    Simulation run(spring.scene(batch_seconds / 4.0));
    ReferenceRun reference(run.scene(), run.state(), 0.0);
    const auto first = gap_after(run, reference, 10);
    ReferenceRun::Gap gap;
    Snapshot moment;
    REQUIRE_FALSE(run.advance_steps(1));  // a step into the next batch
    run.snapshot(moment);
    reference.follow(moment);
    moment.time = 0.05;
    reference.follow(moment);
    reference.wait();
    CHECK_FALSE(reference.take(gap));
    REQUIRE_FALSE(run.advance_steps(3));
    run.snapshot(moment);
    reference.follow(moment);
    reference.wait();
    REQUIRE(reference.take(gap));
    CHECK(gap.snapshot.time == Approx(first.snapshot.time + batch_seconds));
}

TEST_CASE("A reference that cannot go on says why, and nobody waits for it", "[threads]") {
    Scene scene = flag_in_wind();
    scene.flag.columns = 0;
    ReferenceRun reference(scene, State<double>(2, 2), 0.0);
    for (int n = 0; n < 1000 && reference.trouble().empty(); ++n)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    CHECK(reference.trouble().find("columns") != std::string::npos);
    Snapshot moment;
    moment.position = FieldBuffer<float>(2, 2);
    reference.follow(moment);
    reference.wait();
    CHECK_FALSE(reference.behind());
}

TEST_CASE("A reference follows the run on its thread, and begins anew when settings change", "[threads]") {
    SimulationThread thread{Simulation(flag_in_wind())};
    ReferenceRun::Gap gap;
    thread.ask_batches(5);
    thread.wait();
    CHECK_FALSE(thread.take_reference(gap));
    thread.follow_reference(true);
    thread.wait();
    REQUIRE(thread.take_reference(gap));
    CHECK(gap.since == Approx(5 * batch_seconds));
    CHECK(gap.rms == 0.0);
    thread.ask_batches(20);
    thread.wait();
    REQUIRE(thread.take_reference(gap));
    CHECK(gap.since == Approx(5 * batch_seconds));
    CHECK(gap.snapshot.time == Approx(25 * batch_seconds));
    CHECK(gap.rms > 0.0);

    thread.restart_reference();
    thread.wait();
    REQUIRE(thread.take_reference(gap));
    CHECK(gap.since == Approx(25 * batch_seconds));
    CHECK(gap.rms == 0.0);

    Scene changed = flag_in_wind();
    changed.wind()->velocity.x = 8.0;
    thread.ask_batches(5);
    thread.wait();
    thread.apply(changed, 1);
    thread.wait();
    REQUIRE(thread.take_reference(gap));
    CHECK(gap.since == Approx(30 * batch_seconds));
    CHECK(gap.rms == 0.0);
    thread.restart(changed, 2);
    thread.wait();
    REQUIRE(thread.take_reference(gap));
    CHECK(gap.since == 0.0);

    thread.follow_reference(false);
    thread.ask_batches(2);
    thread.wait();
    CHECK_FALSE(thread.take_reference(gap));
    CHECK(thread.reference_trouble().empty());
}

TEST_CASE("A reference that is asked for together with a scene that is refused begins all the same", "[threads]") {
    Scene large = flag_in_wind();
    large.flag.columns = 150, large.flag.rows = 100;
    SimulationThread thread{Simulation(large)};
    Scene refused = large;
    refused.flag.columns = 0;
    thread.ask_batches(1);  // both are asked for while it is at work
    thread.follow_reference(true);
    thread.apply(refused, 1);
    thread.wait();
    ReferenceRun::Gap gap;
    CHECK(thread.take_reference(gap));
}
