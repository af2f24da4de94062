// Simulation: a run keeps its time, its bits and, through a change of settings, its state.
#include "all_methods.hpp"
#include "catch.hpp"
#include "run/simulation.hpp"
#include "sanitized.hpp"

#include "drapeau/stability.hpp"

#include <cmath>
#include <limits>
#include <set>
#include <vector>

using namespace drapeau;

namespace {

Scene small(Precision precision = Precision::double_precision) {
    Scene scene;
    scene.flag.columns = 11, scene.flag.rows = 7;
    scene.springs = {.mass = 0.001,
                     .stiffness = 200.0,
                     .diagonal_stiffness = 100.0,
                     .damping = 0.002,
                     .drag = 0.002,
                     .friction = {}};
    scene.gravity() = Gravity{};
    scene.wind() = Wind{.velocity = {4.0, 0.0, 1.0}, .gusts = {1.0, 0.5, 1.0}};
    scene.time.precision = precision;
    return scene;
}

/// Position and velocity of one mass.
struct Mass {
    glm::dvec3 x, v;
    bool operator==(const Mass&) const = default;
};
std::vector<Mass> masses(const Simulation& simulation) {
    const auto state = simulation.state();
    std::vector<Mass> all;
    for (int j = 0; j < state.rows(); ++j)
        for (int i = 0; i < state.columns(); ++i) all.push_back({state.position.at(i, j), state.velocity.at(i, j)});
    return all;
}

double length(const glm::dvec3& a) {
    return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}
template <class Real>
constexpr double epsilon = std::numeric_limits<Real>::epsilon();

void run(Simulation& simulation, int batches) {
    for (int n = 0; n < batches; ++n) REQUIRE_FALSE(simulation.advance_batch());
}

double distance(const Simulation& a, const Simulation& b) {
    double most = 0.0;
    const auto one = masses(a), other = masses(b);
    for (std::size_t n = 0; n < one.size(); ++n) most = std::max(most, length(one[n].x - other[n].x));
    return most;
}

const Attach attachments[] = {Attach::hoist, Attach::grommets, Attach::top, Attach::corner,
                              Attach::sides, Attach::edges,    Attach::all, Attach::none};

}  // namespace

TEST_CASE("A whole number of equal steps fills a batch", "[physics]") {
    for (const double dt : {1.0, 1.0 / 60.0, 1.0 / 61.0, 1e-2, 1e-3, 2.34e-4, 1e-6}) {
        const double whole = whole_steps_per_batch(dt), steps = batch_seconds / whole;
        CHECK(whole <= dt * (1.0 + 1e-8));
        CHECK(std::abs(steps - std::round(steps)) < 1e-9 * steps);
        CHECK((steps <= 1.0 || batch_seconds / (steps - 1.0) > dt * (1.0 - 1e-8)));  // and no more than it takes
    }
    // A step that divides the batch stays itself, although 1/60 is not exact.
    for (const int steps : {1, 2, 3, 7, 49, 100, 12345}) {
        const double dt = batch_seconds / steps;
        CHECK(whole_steps_per_batch(dt) == Approx(dt).epsilon(1e-15));
    }

    Scene scene = small();
    scene.time.dt = 3e-4;
    Simulation simulation(scene);
    CHECK(simulation.steps_per_batch() == 56);
    CHECK(static_cast<double>(simulation.steps_per_batch()) * simulation.dt() == Approx(batch_seconds).epsilon(1e-15));
}

TEST_CASE("Time is a whole number of steps", "[physics]") {
    Scene scene = small();
    scene.time.dt = 3e-4;
    Simulation simulation(scene);
    for (int n = 1; n <= 600; ++n) {
        REQUIRE_FALSE(simulation.advance_batch());
        CHECK(simulation.steps() == 56 * n);
        CHECK(simulation.time() == static_cast<double>(56 * n) * simulation.dt());
    }
    CHECK(std::abs(simulation.time() - 10.0) < 1e-12);  // not a running sum: no drift

    Simulation exact(scene);
    exact.use_exact_dt();
    CHECK(exact.dt() == 3e-4);
    REQUIRE_FALSE(exact.advance_steps(10000));
    CHECK(exact.time() == 10000 * 3e-4);
}

TEST_CASE("The same scene gives the same bits, however its steps are grouped", "[physics]") {
    for (const auto precision : {Precision::single_precision, Precision::double_precision})
        for (const auto start : {Start::flat, Start::crumpled}) {
            Scene scene = small(precision);
            scene.flag.start = start;
            Simulation a(scene), b(scene), one_by_one(scene), halves(scene);
            run(a, 20), run(b, 20);
            CHECK(a.state_hash() == b.state_hash());
            CHECK(masses(a) == masses(b));
            for (long long n = 0; n < a.steps(); ++n) REQUIRE_FALSE(one_by_one.advance_steps(1));
            CHECK(one_by_one.state_hash() == a.state_hash());
            REQUIRE_FALSE(halves.advance_steps(a.steps() / 2));
            REQUIRE_FALSE(halves.advance_steps(a.steps() - a.steps() / 2));
            CHECK(halves.state_hash() == a.state_hash());
            CHECK(halves.time() == a.time());

            // Looking changes nothing.
            Snapshot shown;
            const auto before = a.state_hash();
            a.snapshot(shown), a.readings(), a.state();
            CHECK(a.state_hash() == before);
            CHECK(shown.time == a.time());
            CHECK(shown.steps == a.steps());
        }
}

TEST_CASE("Any number of threads gives the bits of one, in the kernels as they are built", "[physics][threads]") {
    constexpr int steps = testing::sanitized ? 5 : 70;
    for (const auto precision : {Precision::single_precision, Precision::double_precision})
        for (const auto method : all_methods())
            for (const bool all_terms : {false, true}) {
                Scene scene = small(precision);
                scene.flag.columns = 70, scene.flag.rows = 67;  // enough masses for threads to be worth it
                scene.flag.start = Start::crumpled;
                scene.time.method = method;
                scene.time.dt = 1e-5;
                if (!all_terms) scene.springs->diagonal_stiffness.reset(), scene.springs->damping.reset();
                Simulation alone(scene);
                REQUIRE_FALSE(alone.advance_steps(steps));
                for (const int threads : {2, 3}) {
                    Simulation together(scene);
                    together.use_threads(threads);
                    REQUIRE_FALSE(together.advance_steps(steps));
                    CHECK(together.state_hash() == alone.state_hash());
                }
            }
}

TEST_CASE("The hash sees every bit", "[physics]") {
    // Prestretched by one unit in the last place
    Scene scene = small(), other = scene;
    other.flag.prestretch = std::numeric_limits<double>::epsilon();
    CHECK(Simulation(scene).state_hash() == Simulation(scene).state_hash());
    CHECK(Simulation(scene).state_hash() != Simulation(other).state_hash());
    // After one step of forward Euler under a gravity a little larger along one axis only that velocity differs.
    for (int axis = 0; axis < 3; ++axis) {
        Scene one = scene, two = scene;
        one.time.method = two.time.method = method_id<ForwardEuler>;
        one.time.dt = two.time.dt = 1e-5;
        two.gravity()->acceleration[axis] += 1e-6;
        Simulation a(one), b(two);
        REQUIRE_FALSE(a.advance_steps(1));
        REQUIRE_FALSE(b.advance_steps(1));
        CHECK(masses(a)[1].x == masses(b)[1].x);
        CHECK(a.state_hash() != b.state_hash());
    }
    std::set<std::uint64_t> seen;
    Simulation moving(scene);
    for (int n = 0; n < 200; ++n) {
        seen.insert(moving.state_hash());
        REQUIRE_FALSE(moving.advance_steps(1));
    }
    CHECK(seen.size() == 200);
}

TEST_CASE("Float and double agree to float's precision", "[physics]") {
    for (const auto method : all_methods()) {
        Scene narrow = small(Precision::single_precision), wide = small(Precision::double_precision);
        narrow.time.method = wide.time.method = method;
        narrow.time.dt = wide.time.dt = method == method_id<ForwardEuler> ? 1e-5 : 5e-4;
        Simulation a(narrow), b(wide);
        run(a, 12), run(b, 12);  // 0.2 s: before the flag's motion tells the two apart
        // Each of n steps rounds x (1.5 m) by eps/2 and v so that x is off by another eps a step: a random walk of
        // sqrt(n) * 1.5 eps, for 400 steps 3.6e-6 m and for 20000 of them 2.5e-5 m, a few times over.
        CHECK(distance(a, b) < (method == method_id<ForwardEuler> ? 1e-4 : 2e-5));
        CHECK(distance(b, Simulation(wide)) > 0.01);
    }
}

TEST_CASE("A change of settings keeps time, place and velocity", "[physics]") {
    for (const auto precision : {Precision::single_precision, Precision::double_precision}) {
        Simulation simulation(small(precision));
        run(simulation, 10);
        const auto state = masses(simulation);
        const double time = simulation.time();
        const auto steps = simulation.steps();
        Scene changed = small(precision);
        changed.springs->stiffness = 300.0;
        changed.springs->damping.reset();
        changed.springs->diagonal_stiffness.reset();
        changed.wind()->velocity = {0.0, 0.0, 5.0};
        changed.time.method = method_id<ForwardEuler>;
        changed.time.dt = 1e-5;
        simulation.change(changed);
        CHECK(masses(simulation) == state);
        CHECK(simulation.time() == time);
        CHECK(simulation.steps() == steps);
        CHECK(simulation.scene() == changed);
        REQUIRE_FALSE(simulation.advance_batch());
        CHECK(simulation.time() == Approx(time + batch_seconds).epsilon(1e-14));
        CHECK(simulation.steps() == steps + simulation.steps_per_batch());
    }
}

TEST_CASE("Air on faces joins and leaves a run, whatever its method, and its parts are strengths", "[physics]") {
    for (const Method method : all_methods()) {
        Scene scene = small();
        scene.time.method = method;
        scene.time.dt = 1e-4;
        Simulation simulation(scene), without(scene);
        Scene airy = scene;
        airy.terms.add(Air{});
        simulation.change(airy);
        CHECK(masses(simulation) == masses(without));
        run(simulation, 3), run(without, 3);
        CHECK(distance(simulation, without) > 1e-4);
        Scene skin_alone = airy;
        skin_alone.terms.get<Air>()->pressure.reset();
        simulation.change(skin_alone);
        CHECK(simulation.model().air() != nullptr);
        run(simulation, 1);
        const auto state = masses(simulation);
        simulation.change(scene);
        CHECK(masses(simulation) == state);
        run(simulation, 1);
    }
}

TEST_CASE("Bending joins and leaves a run, and so does its damping, whatever the method", "[physics]") {
    for (const Method method : all_methods()) {
        Scene scene = small();
        scene.time.method = method;
        scene.time.dt = 1e-4;
        Simulation simulation(scene), without(scene);
        Scene bent = scene;
        bent.terms.add(Bending{.stiffness = 0.01});
        simulation.change(bent);
        CHECK(masses(simulation) == masses(without));
        run(simulation, 3), run(without, 3);
        CHECK(distance(simulation, without) > 1e-6);
        for (const std::optional<double> damping :
             {std::optional(20.0), std::optional(40.0), std::optional<double>()}) {
            const auto state = masses(simulation);
            bent.terms.get<Bending>()->damping = damping;
            simulation.change(bent);
            CHECK(simulation.model().bending()->damping == damping);
            CHECK(masses(simulation) == state);
            run(simulation, 1);
        }
        // A strength that is changed acts from the next step on.
        Simulation stays(bent), changes(bent);
        Scene stiffer = bent;
        stiffer.terms.get<Bending>()->stiffness *= 2.0;
        run(stays, 1), run(changes, 1);
        changes.change(stiffer);
        run(stays, 1), run(changes, 1);
        CHECK(distance(stays, changes) > 0.0);
        const auto state = masses(simulation);
        simulation.change(scene);
        CHECK(masses(simulation) == state);
        run(simulation, 1);
    }
}

TEST_CASE("An impossible change is refused and changes nothing", "[physics]") {
    Simulation simulation(small());
    run(simulation, 3);
    const auto hash = simulation.state_hash();
    Scene impossible = small();
    impossible.flag.columns = impossible.flag.rows = 1;
    CHECK_THROWS(simulation.change(impossible));
    impossible = small();
    impossible.springs->mass = -1.0;
    CHECK_THROWS(simulation.change(impossible));
    impossible = small();
    impossible.time.method = method_id<ForwardEuler>;
    impossible.springs->drag.reset(), impossible.wind().reset();
    CHECK_THROWS(simulation.change(impossible));
    CHECK(simulation.state_hash() == hash);
    CHECK(simulation.scene() == small());
}

TEST_CASE("Another grid sees the flag as it was: a linear field is carried over exactly", "[physics]") {
    // Loose masses without springs, in steady wind and gravity from a stretched start: x and v stay linear in the
    // flag's own coordinates, whatever the step.
    Scene scene = small();
    scene.flag.attach = Attach::none;
    scene.flag.prestretch = 0.1;
    scene.flag.disturbance = 0.0;
    scene.wind()->gusts = glm::dvec3(0.0);
    Simulation simulation(scene);
    REQUIRE_FALSE(simulation.advance_batch());
    const auto at = [](const Simulation& s, int i, int j) {
        return masses(s)[static_cast<std::size_t>(j) * s.scene().flag.columns + i];
    };
    const auto corner = at(simulation, 10, 6);
    for (const auto& [columns, rows] : {std::pair{11, 7}, {21, 13}, {6, 4}, {40, 3}, {2, 2}, {17, 1}, {1, 9}}) {
        Scene other = scene;
        other.flag.columns = columns, other.flag.rows = rows;
        Simulation carried(scene);
        carried.change(other);  // at rest, stretched by a tenth: linear to the last bit but rounding
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i) {
                const double along = columns > 1 ? 1.0 * i / (columns - 1) : 0.0;
                const double down = rows > 1 ? 1.0 * j / (rows - 1) : 0.0;
                const glm::dvec3 expected{1.1 * 1.5 * along, -1.1 * down, 0.0};
                CHECK(length(at(carried, i, j).x - expected) < 8 * epsilon<double>);  // a few roundings below 2 m
                CHECK(at(carried, i, j).v == glm::dvec3(0.0));
            }
    }
    // In motion: corners are carried over as they are, and back on its own grid every mass is.
    Scene finer = scene;
    finer.flag.columns = 21, finer.flag.rows = 13;
    const auto before = masses(simulation);
    simulation.change(finer);
    CHECK(length(at(simulation, 20, 12).x - corner.x) < 8 * epsilon<double>);
    CHECK(length(at(simulation, 20, 12).v - corner.v) < 8 * epsilon<double> * 10.0);
    simulation.change(scene);
    const auto after = masses(simulation);
    double worst = 0.0;
    for (std::size_t n = 0; n < before.size(); ++n)
        worst = std::max({worst, length(after[n].x - before[n].x), length(after[n].v - before[n].v)});
    CHECK(worst < 100 * epsilon<double>);  // two interpolations of numbers below 10
}

TEST_CASE("Attached masses stand exactly where the start has them, on any grid", "[physics]") {
    for (const auto attach : attachments) {
        Scene scene = small();
        scene.flag.attach = attach;
        scene.flag.prestretch = 0.05;
        Simulation simulation(scene);
        run(simulation, 5);
        Scene other = scene;
        other.flag.columns = 14, other.flag.rows = 9;
        other.flag.width = 1.2;
        simulation.change(other);
        run(simulation, 2);
        const Grid grid = spread(14, 9, 1.2, 1.0);
        const auto all = masses(simulation);
        for (int j = 0; j < 9; ++j)
            for (int i = 0; i < 14; ++i)
                if (is_attached(attach, grid, i, j)) {
                    CHECK(all[j * 14 + i].x == 1.05 * grid.rest(i, j));
                    CHECK(all[j * 14 + i].v == glm::dvec3(0.0));
                }
    }
}

TEST_CASE("Every attachment holds just the masses it names", "[physics]") {
    for (const auto method : all_methods())
        for (const auto precision : {Precision::single_precision, Precision::double_precision})
            for (const auto& [columns, rows] : {std::pair{11, 7}, {17, 2}, {2, 5}, {1, 8}, {9, 1}})
                for (const auto attach : attachments) {
                    Scene scene = small(precision);
                    scene.flag.columns = columns, scene.flag.rows = rows;
                    scene.flag.attach = attach;
                    scene.time.method = method;
                    scene.time.dt = 1e-4;
                    Simulation simulation(scene);
                    const auto start = masses(simulation);
                    REQUIRE_FALSE(simulation.advance_batch());
                    const auto now = masses(simulation);
                    bool as_named = true;
                    for (int j = 0; j < rows; ++j)
                        for (int i = 0; i < columns; ++i) {
                            const bool left = i == 0, top = j == 0, right = i == columns - 1, bottom = j == rows - 1;
                            bool held = false;
                            switch (attach) {
                                case Attach::hoist:
                                    held = left;
                                    break;
                                case Attach::grommets:
                                    held = left && (top || bottom);
                                    break;
                                case Attach::top:
                                    held = top;
                                    break;
                                case Attach::corner:
                                    held = left && top;
                                    break;
                                case Attach::sides:
                                    held = left || right;
                                    break;
                                case Attach::edges:
                                    held = left || top || right || bottom;
                                    break;
                                case Attach::all:
                                    held = true;
                                    break;
                                case Attach::none:
                                    break;
                            }
                            const std::size_t n = static_cast<std::size_t>(j) * columns + i;
                            const bool still = now[n].x == start[n].x && now[n].v == glm::dvec3(0.0);
                            as_named = as_named && still == held;
                        }
                    INFO("attach " << static_cast<int>(attach) << ", " << columns << " x " << rows);
                    CHECK(as_named);
                }
}

TEST_CASE("A halyard hauls the flag to its place on the pole, and there it stays", "[physics]") {
    for (const Method method : all_methods())
        for (const Precision precision : {Precision::single_precision, Precision::double_precision}) {
            Scene scene = small(precision);
            scene.time.method = method;
            if (method == method_id<ForwardEuler>) scene.springs->damping = 0.2;
            scene.limits.add(Ground{-4.0, 0.4});
            scene.flag.halyard = 1.0;
            Simulation simulation(scene);
            run(simulation, 6);
            CHECK(masses(simulation).front().x == glm::dvec3(0.0));
            scene.flag.halyard = 0.9;  // 0.4 m lower: 0.8 s
            simulation.change(scene);
            run(simulation, 24);
            CHECK(masses(simulation).front().x.y == Approx(-0.2).epsilon(1e-3));
            CHECK(simulation.readings().created_share.value_or(0.0) < 0.05);
            scene.flag.rows = 9;  // on its way
            simulation.change(scene);
            CHECK(masses(simulation).front().x.y == Approx(-0.2).epsilon(1e-3));
            run(simulation, 30);
            const auto there = masses(simulation);
            CHECK(there.front().x.y == Approx(-0.4).epsilon(1e-3));
            CHECK(there.front().v == glm::dvec3(0.0));
            run(simulation, 6);
            const auto still = masses(simulation);
            for (std::size_t j = 0; j < 9; ++j) CHECK(still[11 * j].x == there[11 * j].x);
            // As a scene that begins there has it.
            const auto begun = masses(Simulation(scene));
            for (std::size_t j = 0; j < 9; ++j) CHECK(length(begun[11 * j].x - still[11 * j].x) < 4e-4);
            scene.flag.halyard = 0.0;  // its foot stands on the ground
            simulation.change(scene);
            run(simulation, 1);
            scene.flag.halyard.reset();  // let be on its way
            simulation.change(scene);
            run(simulation, 2);
            CHECK(masses(simulation).front().v == glm::dvec3(0.0));
            scene.flag.halyard = 0.0;
            scene.flag.start = Start::crumpled;
            CHECK(masses(Simulation(scene)).front().x.y == Approx(-4.0 + scene.flag.height));
        }
}

TEST_CASE("Ground and pole join and leave a run", "[physics]") {
    for (const Method method : all_methods()) {
        Scene scene = small();
        scene.time.method = method;
        scene.flag.attach = Attach::corner;
        if (method == method_id<ForwardEuler>) scene.springs->damping = 0.2;
        Simulation simulation(scene);
        run(simulation, 6);
        scene.limits.add(Ground{-0.9, 0.4}).add(Pole{});
        const auto before = masses(simulation);
        simulation.change(scene);
        CHECK(masses(simulation) == before);
        run(simulation, 30);  // it comes out of the ground
        const Model held = simulation.model();
        const auto after = masses(simulation);
        for (int n = 0; n < 77; ++n)
            if (!held.held(n % 11, n / 11)) CHECK(after[static_cast<std::size_t>(n)].x.y >= -0.9 - 1e-12);
        scene.limits = {};
        simulation.change(scene);
        CHECK(masses(simulation) == after);
        run(simulation, 60);
        double lowest = 0.0;
        const auto through = masses(simulation);
        for (int n = 0; n < 77; ++n)
            if (!held.held(n % 11, n / 11)) lowest = std::min(lowest, through[static_cast<std::size_t>(n)].x.y);
        CHECK(lowest < -0.9);
    }
}

TEST_CASE("A hanging start is at rest", "[physics]") {
    for (const auto attach : {Attach::hoist, Attach::grommets, Attach::top, Attach::corner}) {
        Scene scene = small();
        scene.flag.attach = attach;
        scene.flag.start = Start::hanging;
        scene.wind().reset();
        Simulation simulation(scene);
        const auto start = masses(simulation);
        for (const auto& mass : start) CHECK(mass.v == glm::dvec3(0.0));
        // Nothing weighs on one spring with more than twice all that hangs: 2 * 77 m g / k over the shorter cell.
        CHECK(simulation.readings().max_stretch < 2.0 * 77.0 * 0.001 * 9.8 / 200.0 / 0.15);
        CHECK(simulation.readings().kinetic_energy == 0.0);
        CHECK(simulation.start_remark().empty());
        // Left alone for a second it stays: within a tenth of a millimetre of rest it swings by as much to the other
        // side, here and there a few times as far.
        run(simulation, 60);
        const auto later = masses(simulation);
        double most = 0.0;
        for (std::size_t n = 0; n < start.size(); ++n) most = std::max(most, length(later[n].x - start[n].x));
        CHECK(most < 1e-3);
        CHECK(simulation.readings().gravity_energy < -0.2 * 77 * 0.001 * 9.8 * 0.5);  // it hangs down
    }
}

TEST_CASE("A crumpled start is folded, the same each time, its rows no longer and no shorter", "[physics]") {
    for (const auto attach : {Attach::hoist, Attach::corner, Attach::none}) {
        Scene scene = small();
        scene.flag.attach = attach;
        scene.flag.start = Start::crumpled;
        const Simulation simulation(scene), again(scene);
        CHECK(masses(simulation) == masses(again));
        const auto all = masses(simulation);
        double depth = 0.0;
        for (int j = 0; j < 7; ++j)
            for (int i = 0; i < 11; ++i) {
                depth = std::max(depth, std::abs(all[j * 11 + i].x.z));
                if (i > 0) CHECK(length(all[j * 11 + i].x - all[j * 11 + i - 1].x) == Approx(0.15).epsilon(1e-12));
            }
        CHECK(depth > 0.05);  // m: not flat
    }
}
