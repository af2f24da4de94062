// A hanging start: where it is known where a flag hangs it hangs there, and no flag takes longer than it may.
#include "catch.hpp"

#include "run/settle.hpp"
#include "run/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

using namespace drapeau;

namespace {

Scene chain(int columns, int rows, Attach attach) {
    Scene scene;
    scene.flag.columns = columns, scene.flag.rows = rows;
    scene.flag.width = scene.flag.height = 1.5;
    scene.flag.attach = attach;
    scene.flag.start = Start::hanging;
    scene.springs->mass = 1e-4;
    scene.springs->stiffness = 200.0;
    scene.gravity() = Gravity{};
    return scene;
}

/// How far mass n of a hanging chain is below its first: n L + m g/k (n N - n (n - 1)/2), N masses below the first.
double depth(const Scene& scene, int count, int n) {
    const double below = count - 1, weight = scene.springs->mass * 9.8;
    return 1.5 * n / below + weight / scene.springs->stiffness * (n * below - 0.5 * n * (n - 1.0));
}

bool same_places(const State<double>& a, const State<double>& b) {
    for (int j = 0; j < a.rows(); ++j)
        for (int i = 0; i < a.columns(); ++i)
            if (a.position.at(i, j) != b.position.at(i, j)) return false;
    return a.rows() == b.rows() && a.columns() == b.columns();
}

double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

TEST_CASE("A chain hangs straight down, each spring stretched by what it carries", "[physics]") {
    for (const int count : {2, 3, 20, 301, 2000})
        for (const bool turned : {false, true}) {
            if (turned && count > 1000) continue;  // a row for each mass takes longer than it may
            CAPTURE(count, turned);
            const Scene scene = turned ? chain(1, count, Attach::top) : chain(count, 1, Attach::hoist);
            const Simulation simulation(scene);
            CHECK(simulation.start_remark().empty());
            const State<double> state = simulation.state();
            double worst = 0.0;
            for (int n = 0; n < count; ++n) {
                const auto x = turned ? state.position.at(0, n) : state.position.at(n, 0);
                worst = std::max(worst, std::hypot(x.x, x.y + depth(scene, count, n), x.z));
            }
            // A tenth of a millimetre for a swing of 2 s; this one takes up to six, and its end swings widest.
            CHECK(worst < 3e-3);
        }
}

TEST_CASE("The way a flag hangs does not depend on what only slows it down", "[physics]") {
    Scene scene = chain(13, 9, Attach::grommets);
    scene.time.precision = Precision::double_precision;
    const State<double> free = Simulation(scene).state();
    scene.springs->damping = 0.01, scene.springs->drag = 1.0, scene.springs->friction = 1.0;
    CHECK(same_places(Simulation(scene).state(), free));
}

TEST_CASE("A flag that cannot move, or that nothing pulls, starts hanging at once and as it lies", "[physics]") {
    Scene held = chain(400, 300, Attach::all);
    Scene weightless = chain(400, 300, Attach::hoist), no_pull = weightless, free = chain(400, 300, Attach::none);
    weightless.gravity().reset();
    no_pull.gravity()->acceleration = glm::dvec3(0.0);
    const Scene bar = chain(2, 1, Attach::sides);
    for (Scene scene : {held, weightless, no_pull, free, bar}) {
        const double begin = processor_seconds();
        const State<double> hanging = Simulation(scene).state();
        const double hung = processor_seconds() - begin;
        scene.flag.start = Start::flat;
        scene.flag.disturbance = 0.0;
        const double flat = processor_seconds();
        CHECK(same_places(Simulation(scene).state(), hanging));
        // Settling would take two thousand steps of them all, a flat start some ten looks at them.
        CHECK(hung < 10.0 * (processor_seconds() - flat) + 0.1);
    }
}

TEST_CASE("A flag that does not come to rest within the work allowed starts all the same, and says how far from rest") {
    Scene scene = chain(200, 200, Attach::grommets);
    scene.springs->mass = 1e-5;
    scene.springs->stiffness = 1000.0;
    scene.springs->diagonal_stiffness = 500.0;
    const double begin = processor_seconds();
    const Simulation simulation(scene);
    const double settling = processor_seconds() - begin;

    // It takes as long as 2.5e8 masses moved by a step, of this flag with damped springs, and up to twice that for what
    // goes with them. Without a bound it would take hundreds of times as long.
    Scene moved = scene;
    moved.flag.start = Start::flat;
    moved.springs->damping = 0.01;
    moved.time.precision = Precision::double_precision;
    Simulation plain(moved);
    const double first = processor_seconds();
    CHECK_FALSE(plain.advance_steps(625));
    const double allowed = 2.5e8 / (625.0 * 200.0 * 200.0) * (processor_seconds() - first);
    INFO("settled in " << settling << " s, work as long as " << allowed << " s is allowed");
    CHECK(settling < 2.0 * allowed);
    CHECK(simulation.start_remark().find("had not come to rest when it started") != std::string::npos);
    CHECK(simulation.readings().kinetic_energy == 0.0);
    CHECK(simulation.readings().gravity_energy < 0.0);
}

TEST_CASE("Settling with a stretch limit is bounded too, and the limit holds") {
    Scene scene = chain(200, 1, Attach::hoist);
    scene.limits.add(StretchLimit{0.05});
    const double begin = processor_seconds();
    const Simulation simulation(scene);
    CHECK(processor_seconds() - begin < 15.0);
    CHECK(simulation.readings().max_stretch < 0.05 + 2.0 * StretchLimit::tolerance);
}
