// Simulation thread: what is asked for is done once, in order, and whatever goes wrong becomes a message.
#include "catch.hpp"
#include "small_sheet.hpp"
#include "scarce_memory.hpp"

#include "viewer/simulation_thread.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>
#include <thread>

using namespace drapeau;
using drapeau::testing::ScarceMemory;
using drapeau::testing::small_sheet;
using namespace std::chrono_literals;

namespace {

/// Batches of this one take long enough to be interrupted.
Scene large() {
    Scene scene = small_sheet(400, 300);
    scene.springs->stiffness = 2e5;
    return scene;
}

/// One that takes all the work that settling may.
Scene slow_to_settle() {
    Scene scene = small_sheet(200, 200);
    scene.springs->stiffness = 1000.0;
    scene.springs->mass = 1e-5;
    scene.flag.start = Start::hanging;
    return scene;
}

Scene impossible() {
    Scene scene = small_sheet();
    scene.flag.columns = 0;
    return scene;
}

Scene bursting() {
    Scene scene = small_sheet();
    scene.time.dt = batch_seconds;  // far beyond the limit of these springs
    return scene;
}

Moment newest_of(SimulationThread& thread) {
    thread.wait();
    Moment moment;
    REQUIRE(thread.take(moment));
    return moment;
}

/// The newest moment that satisfies the condition, or a failed requirement after a minute.
Moment wait_for(SimulationThread& thread, const std::function<bool(const Moment&)>& condition) {
    const auto deadline = std::chrono::steady_clock::now() + 60s;
    Moment moment;
    while (!(thread.take(moment) && condition(moment))) {
        REQUIRE(std::chrono::steady_clock::now() < deadline);
        std::this_thread::sleep_for(1ms);
    }
    return moment;
}

/// The run as it would be without a thread.
Snapshot after_batches(const Scene& scene, int batches) {
    Simulation simulation(scene);
    for (int batch = 0; batch < batches; ++batch) REQUIRE(!simulation.advance_batch());
    Snapshot snapshot;
    simulation.snapshot(snapshot);
    return snapshot;
}

void check_same(const Snapshot& a, const Snapshot& b) {
    CHECK(a.steps == b.steps);
    CHECK(a.time == b.time);
    for (int c = 0; c < 3; ++c) {
        const auto &from = a.position.component(c), &to = b.position.component(c);
        CHECK(std::equal(from.begin(), from.end(), to.begin(), to.end()));
    }
}

std::ptrdiff_t threads_of_this_program() {
    return std::distance(std::filesystem::directory_iterator("/proc/self/task"), {});
}

// The system lists a thread for a moment after it was joined, so a count is asked for until it is `expected`, and what
// is left of it after 10 s is the answer.
std::ptrdiff_t threads_settling_at(std::ptrdiff_t expected) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    auto count = threads_of_this_program();
    while (count != expected && std::chrono::steady_clock::now() < end) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        count = threads_of_this_program();
    }
    return count;
}

// Threads that earlier tests have joined may still be listed: the fewest seen within 0.2 s are the ones that stay.
std::ptrdiff_t threads_that_stay() {
    auto fewest = threads_of_this_program();
    for (int reading = 0; reading < 200; ++reading) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        fewest = std::min(fewest, threads_of_this_program());
    }
    return fewest;
}

}  // namespace

TEST_CASE("a thread shows its start before anything is asked for") {
    SimulationThread thread{Simulation(small_sheet())};
    const Moment moment = newest_of(thread);
    check_same(moment.snapshot, after_batches(small_sheet(), 0));
    CHECK(moment.scene == small_sheet());
    CHECK(moment.revision == 0);
    CHECK(moment.dt > 0.0);
    CHECK(!moment.stands());
}

TEST_CASE("batches asked for are done, each once, and waiting waits for all of them", "[threads]") {
    SimulationThread thread{Simulation(small_sheet())};
    thread.ask_batches(3);
    thread.ask_batches(4);
    const Moment moment = newest_of(thread);
    CHECK(thread.backlog() == 0);
    check_same(moment.snapshot, after_batches(small_sheet(), 7));
    CHECK(moment.step_seconds > 0.0);

    // Nothing goes on by itself, and nothing is new.
    Moment later;
    std::this_thread::sleep_for(20ms);
    CHECK(!thread.take(later));
}

TEST_CASE("a single step is one step") {
    SimulationThread thread{Simulation(small_sheet())};
    for (int step = 0; step < 3; ++step) thread.ask_step();
    const Moment moment = newest_of(thread);
    CHECK(moment.snapshot.steps == 3);
    CHECK(moment.snapshot.time == Approx(3 * moment.dt));
}

TEST_CASE("readings are of the moment itself after a step or a change, and never far behind it while the flag plays",
          "[threads]") {
    SimulationThread thread{Simulation(small_sheet())};
    CHECK(newest_of(thread).readings.time == 0.0);
    for (int batch = 1; batch <= 100; ++batch) {
        thread.ask_batches(1);
        const Moment moment = newest_of(thread);
        CHECK(moment.readings.time <= moment.snapshot.time);
        CHECK(moment.readings.time > moment.snapshot.time - 1.0);
    }
    thread.ask_step();
    const Moment stepped = newest_of(thread);
    CHECK(stepped.readings.time == stepped.snapshot.time);
    thread.ask_batches(1);
    thread.wait();
    Scene windless = small_sheet();
    windless.wind().reset();
    thread.apply(windless, 1);
    const Moment changed = newest_of(thread);
    CHECK(changed.readings.time == changed.snapshot.time);

    // Where the flag stands still they are asked for.
    const auto is_old = [](const Moment& moment) { return moment.readings.time < moment.snapshot.time; };
    Moment stands = changed;
    for (int batch = 0; batch < 20 && !is_old(stands); ++batch) {
        thread.ask_batches(1);
        stands = newest_of(thread);
    }
    REQUIRE(is_old(stands));
    thread.ask_now();
    const Moment read = newest_of(thread);
    CHECK(read.snapshot.time == stands.snapshot.time);
    CHECK(read.readings.time == read.snapshot.time);
}

TEST_CASE("springs are drawn with the rest lengths and stiffnesses of the model") {
    Scene scene = small_sheet(4, 3);
    scene.flag.width = 1.5, scene.flag.height = 1.0;
    scene.springs->stiffness = 50.0;
    SimulationThread thread{Simulation(scene)};
    CHECK(newest_of(thread).kinds == SpringKinds{.fly = {0.5f, 50.0f}, .hoist = {0.5f, 50.0f}, .diagonal = {}});

    scene.springs->diagonal_stiffness = 20.0;
    thread.apply(scene, 1);
    const SpringKind diagonal = newest_of(thread).kinds.diagonal;
    CHECK(diagonal.rest == Approx(std::sqrt(0.5)));
    CHECK(diagonal.stiffness == 20.0f);

    // A chain has no springs across, whatever its width.
    scene.flag.columns = 1;
    scene.springs->diagonal_stiffness.reset();
    thread.restart(scene, 2);
    CHECK(newest_of(thread).kinds == SpringKinds{.fly = {}, .hoist = {0.5f, 50.0f}, .diagonal = {}});
}

TEST_CASE("a change goes on from where the run is, a restart from the start") {
    SimulationThread thread{Simulation(small_sheet())};
    thread.ask_batches(5);
    thread.wait();
    Scene windless = small_sheet();
    windless.wind().reset();
    thread.apply(windless, 1);
    const Moment changed = newest_of(thread);
    CHECK(changed.revision == 1);
    CHECK(changed.scene == windless);
    CHECK(changed.snapshot.time == Approx(5 * batch_seconds));

    thread.restart(windless, 2);
    const Moment restarted = newest_of(thread);
    CHECK(restarted.revision == 2);
    check_same(restarted.snapshot, after_batches(windless, 0));
}

TEST_CASE("of several changes asked for at once the last counts, and a restart among them is not lost", "[threads]") {
    SimulationThread thread{Simulation(small_sheet())};
    thread.ask_batches(3);
    thread.wait();
    thread.apply(large(), 1);  // takes longer than to ask for two more
    thread.restart(small_sheet(20, 10), 2);
    thread.apply(small_sheet(30, 10), 3);
    const Moment moment = newest_of(thread);
    CHECK(moment.revision == 3);
    CHECK(moment.snapshot.position.columns() == 30);
    CHECK(moment.snapshot.time == 0.0);
}

TEST_CASE("a change while a batch runs is taken before the next") {
    SimulationThread thread{Simulation(large())};
    thread.ask_batches(10000);
    const Moment before = wait_for(thread, [](const Moment& moment) { return moment.snapshot.steps > 0; });
    // A flag as slow, so that hardly a batch of it is done before its first moment is seen.
    Scene changed = large();
    changed.wind().reset();
    thread.apply(changed, 1);
    const Moment after = wait_for(thread, [](const Moment& moment) { return moment.revision == 1; });
    // One batch may have been done between looking and asking, one between the change and the look.
    CHECK(after.snapshot.time <= before.snapshot.time + 2.001 * batch_seconds);
    CHECK(thread.backlog() > 9990);
}

TEST_CASE("a thread ends promptly in the middle of a batch that takes minutes") {
    Scene slow = large();
    slow.time.dt = 1e-8;
    slow.time.precision = Precision::double_precision;
    auto thread = std::make_unique<SimulationThread>(Simulation(slow));
    thread->ask_batches(1000);
    std::this_thread::sleep_for(50ms);
    const auto begin = std::chrono::steady_clock::now();
    thread.reset();
    // Hundredths of a second; the rest is for a busy machine.
    CHECK(std::chrono::steady_clock::now() - begin < 10s);
}

TEST_CASE("a start that settles is abandoned for a newer change, which then starts anew, and by the end") {
    auto thread = std::make_unique<SimulationThread>(Simulation(small_sheet()));
    thread->ask_batches(3);
    thread->wait();
    thread->restart(slow_to_settle(), 1);
    while (!thread->settling()) std::this_thread::sleep_for(1ms);
    auto begin = std::chrono::steady_clock::now();
    thread->apply(small_sheet(20, 10), 2);
    const Moment moment = newest_of(*thread);
    CHECK(std::chrono::steady_clock::now() - begin < 1s);  // it needs three
    CHECK(!thread->settling());
    CHECK(moment.revision == 2);
    CHECK(moment.scene == small_sheet(20, 10));
    CHECK(moment.snapshot.time == 0.0);

    thread->apply(slow_to_settle(), 3);
    while (!thread->settling()) std::this_thread::sleep_for(1ms);
    begin = std::chrono::steady_clock::now();
    thread.reset();
    CHECK(std::chrono::steady_clock::now() - begin < 1s);
}

TEST_CASE("a refused scene is reported with its reason and leaves the run as it was") {
    SimulationThread thread{Simulation(small_sheet())};
    thread.ask_batches(2);
    thread.wait();
    for (const bool from_start : {false, true}) {
        if (from_start)
            thread.restart(impossible(), 5);
        else
            thread.apply(impossible(), 4);
        const Moment moment = newest_of(thread);
        CHECK(moment.refused_revision == (from_start ? 5 : 4));
        CHECK(moment.refusal.find("flag.columns = 0") != std::string::npos);
        CHECK(moment.revision == 0);
        CHECK(moment.scene == small_sheet());
        check_same(moment.snapshot, after_batches(small_sheet(), 2));
        CHECK(!moment.stands());
    }
    thread.ask_batches(3);
    check_same(newest_of(thread).snapshot, after_batches(small_sheet(), 5));

    thread.restart(small_sheet(), 6);
    const Moment taken = newest_of(thread);
    CHECK(taken.refusal.empty());
    CHECK(taken.refused_revision == -1);
    CHECK(taken.revision == 6);
}

TEST_CASE("a divergence drops the batches that were asked for, until a scene is taken", "[threads]") {
    SimulationThread thread{Simulation(bursting())};
    thread.ask_batches(100000);
    const Moment burst = newest_of(thread);
    REQUIRE(burst.divergence);
    CHECK(burst.stands());
    CHECK(thread.backlog() == 0);

    thread.ask_batches(5);
    thread.ask_step();
    CHECK(newest_of(thread).snapshot.steps == burst.snapshot.steps);

    Scene safe = bursting();
    safe.time.dt = burst.divergence->safe_dt;
    thread.apply(safe, 1);
    thread.ask_batches(5);
    const Moment moment = newest_of(thread);
    CHECK(!moment.stands());
    CHECK(moment.snapshot.time == Approx(burst.snapshot.time + 5 * batch_seconds));
}

TEST_CASE("a scene there is no memory for is refused in words, and the run goes on to the same bits") {
    SimulationThread thread{Simulation(small_sheet())};
    thread.ask_batches(2);
    thread.wait();
    for (const bool from_start : {false, true}) {
        {
            const ScarceMemory scarce(20000);  // bytes; the small flag never needs as much at once
            if (from_start)
                thread.restart(large(), 2);
            else
                thread.apply(large(), 1);
            thread.wait();
        }
        const Moment moment = newest_of(thread);
        CHECK(moment.refused_revision == (from_start ? 2 : 1));
        CHECK(moment.refusal.find("not enough memory for this flag: 400 x 300 masses") == 0);
        CHECK(moment.scene == small_sheet());
        check_same(moment.snapshot, after_batches(small_sheet(), 2));
    }
    thread.ask_batches(3);
    check_same(newest_of(thread).snapshot, after_batches(small_sheet(), 5));
}

TEST_CASE("whatever is thrown while the run advances becomes a message, and the next scene goes on", "[threads]") {
    using Thrown = ScarceMemory::Thrown;
    const std::pair<Thrown, std::string> cases[] = {{Thrown::bad_alloc, "not enough memory"},
                                                    {Thrown::another_exception, "another exception"},
                                                    {Thrown::no_exception, "unknown reason"}};
    for (const auto& [thrown, said] : cases) {
        CAPTURE(said);
        SimulationThread thread{Simulation(small_sheet(100, 100))};
        thread.wait();
        {
            const ScarceMemory scarce(20000, thrown);  // bytes; a component of this flag is 40000
            thread.ask_batches(1000);
            thread.wait();
        }
        const Moment failed = newest_of(thread);
        CHECK(failed.failure.find(said) != std::string::npos);
        CHECK(failed.stands());
        CHECK(failed.snapshot.position.columns() == 100);  // the last picture there was
        CHECK(thread.backlog() == 0);

        thread.ask_batches(3);
        thread.wait();
        Moment moment;
        if (thread.take(moment)) CHECK(moment.stands());

        thread.restart(small_sheet(), 1);
        thread.ask_batches(3);
        const Moment healed = newest_of(thread);
        CHECK(!healed.stands());
        CHECK(healed.revision == 1);
        check_same(healed.snapshot, after_batches(small_sheet(), 3));
    }
}

TEST_CASE("one processor is left to the picture, and one thread there always is") {
    CHECK(simulation_threads(0) == 1);
    CHECK(simulation_threads(1) == 1);
    CHECK(simulation_threads(2) == 1);
    CHECK(simulation_threads(8) == 7);
}

TEST_CASE("a large flag is moved by as many threads as given, through changes and restarts too, to the same bits",
          "[threads]") {
    const auto before = threads_that_stay();
    const Scene scene = small_sheet(100, 80);
    SimulationThread thread(Simulation(scene), 3);
    // The one that serves requests is among the three.
    CHECK(threads_settling_at(before + 3) == before + 3);
    thread.restart(scene, 1);
    thread.wait();
    CHECK(threads_settling_at(before + 3) == before + 3);
    thread.ask_batches(2);
    check_same(newest_of(thread).snapshot, after_batches(scene, 2));
    thread.apply(small_sheet(110, 80), 2);
    thread.wait();
    CHECK(threads_settling_at(before + 3) == before + 3);
    // A flag too small for threads to pay stays on one.
    thread.restart(small_sheet(), 3);
    thread.wait();
    CHECK(threads_settling_at(before + 1) == before + 1);
}

TEST_CASE("moments come with velocities while they are wanted, the present one at once") {
    SimulationThread thread{Simulation(small_sheet())};
    thread.ask_batches(3);
    CHECK(newest_of(thread).snapshot.velocity.columns() == 0);
    thread.give_velocities(true);
    const Moment here = newest_of(thread);
    CHECK(here.snapshot.velocity.columns() == here.snapshot.position.columns());
    CHECK(here.snapshot.time == Approx(3.0 * batch_seconds));
    thread.ask_batches(1);
    CHECK(newest_of(thread).snapshot.velocity.rows() == here.snapshot.position.rows());
    thread.give_velocities(false);
    thread.ask_batches(1);
    CHECK(newest_of(thread).snapshot.velocity.columns() == 0);
}
