// Timeline: a flight goes on from a kept moment as it did, to the bit, whatever it is made of; what is kept stays
// within its budget.
#include "all_methods.hpp"
#include "catch.hpp"
#include "small_sheet.hpp"

#include "run/simulation.hpp"
#include "scene/file.hpp"
#include "viewer/simulation_thread.hpp"
#include "viewer/timeline.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace drapeau;
using drapeau::testing::small_sheet;

namespace {

/// Air that moves along and is held, bending, travelling gusts, a stretch limit, contacts and a halyard that hauls.
Scene everything() {
    Scene scene = small_sheet();
    scene.springs->stiffness = 50.0;
    scene.terms.get<Air>() = Air{.added = true};
    scene.terms.get<Bending>() = Bending{.stiffness = 1e-5, .damping = 0.01};
    scene.wind()->travelling = true;
    scene.limits.get<StretchLimit>() = StretchLimit{0.05};
    scene.limits.get<Ground>() = Ground{.height = -1.2};
    scene.limits.get<Pole>() = Pole{};
    scene.flag.halyard = 0.5;
    return scene;
}

struct State {
    std::uint64_t hash = 0;
    long long steps = 0;
    double time = 0.0, dt = 0.0, created = 0.0;

    bool operator==(const State&) const = default;
};

State state_of(const Simulation& simulation) {
    return {simulation.state_hash(), simulation.steps(), simulation.time(), simulation.dt(),
            simulation.readings().created_share.value_or(0.0)};
}

std::vector<State> fly(Simulation& simulation, int batches) {
    std::vector<State> states;
    for (int batch = 0; batch < batches; ++batch) {
        if (simulation.advance_batch()) break;
        states.push_back(state_of(simulation));
    }
    return states;
}

/// Flies on from a moment again: in the same run, in another that did something else, and after a change of settings.
void check_goes_on(const Scene& scene, int before = 7, int after = 25) {
    Simulation simulation(scene);
    fly(simulation, before);
    simulation.advance_steps(1);  // within a batch
    const auto kept = simulation.keep();
    const State then = state_of(simulation);
    const auto flown = fly(simulation, after);
    REQUIRE(flown.size() == std::size_t(after));

    simulation.restore(*kept);
    CHECK(state_of(simulation) == then);
    CHECK(fly(simulation, after) == flown);

    Simulation other(small_sheet(9, 7));
    other.use_threads(2);
    fly(other, 2);
    other.restore(*kept);
    CHECK(state_of(other) == then);
    CHECK(fly(other, after) == flown);

    Scene changed = scene;
    changed.flag.columns += 3;
    changed.gravity().reset();
    simulation.change(changed);
    fly(simulation, 2);
    simulation.restore(*kept);
    CHECK(fly(simulation, after) == flown);
}

KeptMomentPtr at(const std::shared_ptr<const KeptRun>& run, double time) {
    return std::make_shared<KeptMoment>(KeptMoment{run, nullptr, {.time = time}});
}

std::size_t bytes_of(const KeptRun& run) {
    std::size_t sum = 0;
    run.each_part([&](const void*, std::size_t bytes) { sum += bytes; });
    return sum;
}

}  // namespace

TEST_CASE("a flight goes on from a kept moment as it did, to the bit, by every method in both precisions") {
    for (const Method method : all_methods())
        for (const Precision precision : {Precision::single_precision, Precision::double_precision}) {
            CAPTURE(name_of(method), int(precision));
            Scene scene = small_sheet();
            scene.springs->friction = 0.01;  // forward Euler has a stable step
            scene.time.method = method;
            scene.time.precision = precision;
            check_goes_on(scene);
        }
}

TEST_CASE("a flight with everything in it goes on from a kept moment as it did, to the bit") {
    for (const Precision precision : {Precision::single_precision, Precision::double_precision}) {
        Scene scene = everything();
        scene.time.precision = precision;
        check_goes_on(scene);
    }
    Scene leapfrog = everything();
    leapfrog.time.method = method_id<Leapfrog>;
    check_goes_on(leapfrog);
}

TEST_CASE("a step that a tolerance chooses is chosen again as it was, what was under way included") {
    Scene scene = small_sheet(11, 7);
    scene.springs = {
        .mass = 0.001, .stiffness = 200.0, .diagonal_stiffness = 100.0, .damping = 0.02, .drag = 0.004, .friction = {}};
    scene.time.precision = Precision::double_precision;
    scene.time.tolerance = 1e-3;
    Simulation simulation(scene);
    const double dt = simulation.dt();
    int changed_after = 0;
    while (simulation.dt() == dt && changed_after < 600) fly(simulation, 1), ++changed_after;
    INFO(changed_after);
    REQUIRE(simulation.dt() != dt);
    for (const int before : {50, 10})  // before the estimate that changes it is asked for, and after
        if (before < changed_after) check_goes_on(scene, changed_after - before, before + 10);
}

TEST_CASE("a step that is lowered because energy is created is lowered again at the same moment") {
    Scene scene = small_sheet();
    scene.springs->damping = scene.springs->drag = std::nullopt;
    scene.springs->stiffness = 50.0;
    scene.wind().reset();
    scene.flag.prestretch = 2.0;
    Simulation simulation(scene);
    int lowered_after = 0;
    while (simulation.lowered_because().empty() && lowered_after < 600) fly(simulation, 1), ++lowered_after;
    INFO(lowered_after);
    REQUIRE(!simulation.lowered_because().empty());
    check_goes_on(scene, std::max(0, lowered_after - 9), 40);
}

TEST_CASE("a kept moment knows its scene, its time and where the masses were") {
    Simulation simulation(small_sheet());
    fly(simulation, 3);
    const auto kept = simulation.keep();
    Snapshot then, again;
    simulation.snapshot(then);
    fly(simulation, 3);
    kept->snapshot(again);
    CHECK(kept->scene() == small_sheet());
    CHECK(kept->time() == then.time);
    CHECK(again.steps == then.steps);
    for (int c = 0; c < 3; ++c)
        CHECK(std::equal(then.position.component(c).begin(), then.position.component(c).end(),
                         again.position.component(c).begin()));
}

TEST_CASE("what is kept stays within its budget, dense where it is new and sparser where it is old") {
    Simulation simulation(small_sheet());
    std::vector<std::shared_ptr<const KeptRun>> runs;
    for (int n = 0; n < 40; ++n) {
        fly(simulation, 1);
        runs.push_back(simulation.keep());
    }
    const std::size_t budget = 200 * bytes_of(*runs.back());
    Timeline timeline(budget, 100.0);
    for (int n = 0; n <= 60 * 130; ++n) {
        if (timeline.wants(n / 60.0)) timeline.add(at(runs[std::size_t(n) % runs.size()], n / 60.0));
        REQUIRE(timeline.bytes() <= budget);
    }
    CHECK(timeline.last() == Approx(130.0));
    CHECK(timeline.first() >= 30.0 - 1e-6);
    CHECK(timeline.first() < 35.0);
    const double newest = timeline.last();
    CHECK(newest - timeline.before(newest)->time() < 0.06);
    CHECK(timeline.after(timeline.first())->time() - timeline.first() < 5.0);
    const std::size_t before = timeline.size();
    timeline.shrink();
    CHECK(timeline.size() < before);
    CHECK(timeline.last() == newest);
}

TEST_CASE("what several moments share is counted once, and given back with the last of them") {
    Simulation simulation(small_sheet());
    fly(simulation, 20);
    const auto one = simulation.keep(), other = simulation.keep();
    Timeline timeline;
    timeline.add(at(one, 1.0));
    const std::size_t first = timeline.bytes();
    CHECK(first == bytes_of(*one));
    timeline.add(at(other, 2.0));
    CHECK(timeline.bytes() < 2 * first);
    timeline.drop_after(1.0);
    CHECK(timeline.bytes() == first);
    timeline.clear();
    CHECK(timeline.bytes() == 0);
}

TEST_CASE("the moments of a timeline are found by their time, and a newer one takes the place of those after it") {
    Simulation simulation(small_sheet());
    const auto run = simulation.keep();
    Timeline timeline;
    CHECK(!timeline.nearest(0.0));
    for (const double time : {1.0, 2.0, 3.0, 4.0}) timeline.add(at(run, time));
    CHECK(timeline.nearest(-1.0)->time() == 1.0);
    CHECK(timeline.nearest(2.6)->time() == 3.0);
    CHECK(timeline.nearest(9.0)->time() == 4.0);
    CHECK(timeline.before(3.0)->time() == 2.0);
    CHECK(timeline.after(3.0)->time() == 4.0);
    CHECK(timeline.at_or_before(3.0)->time() == 3.0);
    CHECK(!timeline.before(1.0));
    CHECK(!timeline.after(4.0));
    timeline.add(at(run, 2.5));
    CHECK(timeline.size() == 3);
    CHECK(timeline.last() == 2.5);
    CHECK(timeline.samples(2.0).size() == 2);
}

namespace {

Moment newest_of(SimulationThread& thread) {
    thread.wait();
    Moment moment;
    REQUIRE(thread.take(moment));
    return moment;
}

bool same_picture(const Snapshot& a, const Snapshot& b) {
    bool same = a.steps == b.steps && a.time == b.time && a.position.columns() == b.position.columns();
    for (int c = 0; same && c < 3; ++c)
        same =
            std::equal(a.position.component(c).begin(), a.position.component(c).end(), b.position.component(c).begin());
    return same;
}

}  // namespace

TEST_CASE("the simulation's thread keeps every frame, goes on from any and forgets what came after") {
    SimulationThread thread{Simulation(small_sheet())};
    thread.ask_batches(20);
    const Moment end = newest_of(thread);
    CHECK(thread.history().moments == 21);
    const KeptMomentPtr middle = thread.kept([](const Timeline& kept) { return kept.nearest(10.0 / 60.0); });
    REQUIRE(middle);
    thread.go_on_from(middle, end.scene, 1);
    const Moment then = newest_of(thread);
    CHECK(then.revision == 1);
    CHECK(thread.history().moments == 11);
    Snapshot kept;
    middle->run->snapshot(kept);
    CHECK(same_picture(then.snapshot, kept));
    thread.ask_batches(10);
    CHECK(same_picture(newest_of(thread).snapshot, end.snapshot));
    CHECK(thread.history().moments == 21);
    thread.restart(small_sheet(), 2);
    newest_of(thread);
    CHECK(thread.history().moments == 1);
}

TEST_CASE("a kept moment of another grid comes back with its settings, or goes on with others") {
    SimulationThread thread{Simulation(small_sheet())};
    thread.ask_batches(5);
    const Moment before = newest_of(thread);
    thread.apply(small_sheet(16, 10), 1);
    thread.ask_batches(5);
    CHECK(newest_of(thread).snapshot.position.columns() == 16);
    const KeptMomentPtr first = thread.kept([](const Timeline& kept) { return kept.nearest(3.0 / 60.0); });
    thread.go_on_from(first, first->run->scene(), 2);
    thread.ask_batches(2);
    CHECK(same_picture(newest_of(thread).snapshot, before.snapshot));
    Scene stiffer = small_sheet();
    stiffer.springs->stiffness *= 1.5;
    thread.go_on_from(first, stiffer, 3);
    thread.ask_batches(2);
    const Moment changed = newest_of(thread);
    CHECK(changed.scene == stiffer);
    CHECK(!same_picture(changed.snapshot, before.snapshot));
}

TEST_CASE("parts of batches make up the flight that whole batches are") {
    SimulationThread whole{Simulation(small_sheet())}, parts{Simulation(small_sheet())};
    whole.ask_batches(3);
    const Moment end = newest_of(whole);
    REQUIRE(end.steps_per_batch > 3);
    for (long long left = 3 * end.steps_per_batch; left > 0; left -= std::min(left, 3LL)) {
        parts.ask_part(std::min(left, 3LL));
        parts.wait();
    }
    CHECK(same_picture(newest_of(parts).snapshot, end.snapshot));
}
