// What a flag is measured to hold, against plain sums over its springs and masses.
#include "catch.hpp"
#include "drapeau/flag.hpp"

#include <cmath>
#include <limits>

using namespace drapeau;

namespace {

/// A rest position moved by up to `size` on each axis, the same for a place in every run.
glm::dvec3 scattered(const Grid& grid, int i, int j, double size) {
    const auto n = static_cast<std::int64_t>(j) * grid.columns + i;
    return grid.rest(i, j) + size * glm::dvec3{random_at(3, 0, n), random_at(3, 1, n), random_at(3, 2, n)};
}

double length(const glm::dvec3& a) {
    return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}

template <class Real>
void check_measure(int columns, int rows) {
    INFO(columns << " x " << rows);
    const Grid grid{columns, rows, 0.1, 0.08};
    const double m = 0.01, k = 200.0, kd = 70.0;
    const bool sheet = columns > 1 && rows > 1;
    Flag<Real, Rk4, DiagonalSprings, Gravity> flag(grid, Attach::corner, {.mass = m, .stiffness = k},
                                                   DiagonalSprings{kd}, Gravity{});
    State<double> state(columns, rows);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            state.position.set(i, j, scattered(grid, i, j, 0.03));
            state.velocity.set(i, j, scattered(grid, j, i, 1.0));
        }
    flag.set_state(state);
    state = flag.state();  // as it is stored: the held corner stands still

    double kinetic = 0.0, elastic = 0.0, stretch = 0.0, max_stretch = -1.0, max_force = 0.0, squares = 0.0;
    int springs = 0;
    const auto spring = [&](int i, int j, int i2, int j2, double stiffness, double rest) {
        const double longer = length(state.position.at(i2, j2) - state.position.at(i, j)) - rest;
        elastic += 0.5 * stiffness * longer * longer;
        stretch += std::abs(longer) / rest;
        max_stretch = std::max(max_stretch, longer / rest);
        max_force = std::max(max_force, std::abs(stiffness * longer));
        squares += std::pow(stiffness * longer, 2);
        ++springs;
    };
    glm::dvec3 moment(0.0);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            kinetic += 0.5 * m * std::pow(length(state.velocity.at(i, j)), 2);
            if (i > 0 || j > 0) moment += m * state.position.at(i, j);
            if (i + 1 < columns) spring(i, j, i + 1, j, k, grid.pitch_x);
            if (j + 1 < rows) spring(i, j, i, j + 1, k, grid.pitch_y);
            if (i + 1 < columns && j + 1 < rows) {
                spring(i, j, i + 1, j + 1, kd, grid.pitch_diagonal());
                spring(i + 1, j, i, j + 1, kd, grid.pitch_diagonal());
            }
        }
    const auto here = flag.measure();
    // Lengths are differences of coordinates below 5 m, rounded by eps of that; stretches here are of 0.03/0.1.
    const double eps = std::numeric_limits<Real>::epsilon();
    const double size = length(grid.rest(columns, rows)) + 0.1, close = 60.0 * eps * size / 0.03;
    CHECK(here.kinetic == Approx(kinetic).epsilon(close));
    CHECK(here.elastic == Approx(elastic).epsilon(close));
    CHECK(here.max_force == Approx(max_force).epsilon(close));
    CHECK(here.rms_force == Approx(std::sqrt(squares / springs)).epsilon(close));
    CHECK(here.max_stretch == Approx(max_stretch).epsilon(close));
    CHECK(here.mean_stretch == Approx(stretch / springs).epsilon(close));
    CHECK(length(here.moment - moment) < close * m * size * columns * rows);
    CHECK(here.max_stretch > 0.01);
    CHECK((sheet || springs == columns + rows - 2));
}

}  // namespace

TEST_CASE("Energy, stretch and forces are the sums over springs and masses", "[physics]") {
    for (const auto& [columns, rows] : {std::pair{2, 2}, {3, 2}, {1, 9}, {9, 1}, {16, 5}, {17, 6}, {33, 12}}) {
        check_measure<float>(columns, rows);
        check_measure<double>(columns, rows);
    }
}

TEST_CASE("A step is one number of seconds however its calls are grouped, and time drifts nowhere", "[physics]") {
    using Small = Flag<double, Leapfrog, SpringDamping, Gravity, AirDrag, Wind>;
    const auto make = [] {
        return Small(Grid{5, 4, 0.1, 0.1}, Attach::hoist, {.mass = 0.001, .stiffness = 50}, SpringDamping{0.001},
                     Gravity{}, AirDrag{0.001}, Wind{.velocity = {4, 0, 1}, .gusts = {1, 1, 1}, .travelling = true});
    };
    Small at_once = make(), one_by_one = make();
    at_once.set_step(1e-4), one_by_one.set_step(1e-4);
    at_once.advance(10000);
    for (int n = 0; n < 10000; ++n) one_by_one.advance(1);
    CHECK(at_once.time() == one_by_one.time());
    CHECK(at_once.time() == 10000 * 1e-4);
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 5; ++i) CHECK(at_once.position(i, j) == one_by_one.position(i, j));

    Small batches = make();
    for (int n = 0; n < 60; ++n) batches.advance_batches(1);
    CHECK(std::abs(batches.time() - 1.0) < 1e-14);
}

TEST_CASE("A strength set while a flag flies acts from the next step on, and nothing else changes", "[physics]") {
    using Free = Flag<double, SemiImplicitEuler, Gravity>;
    Free flag(Grid{4, 3, 0.1, 0.1}, Attach::none, {.mass = 0.01, .stiffness = 100}, Gravity{{0, -10, 0}});
    flag.set_step(1e-3);
    flag.advance(100);  // every mass falls alike: v = -1 m/s, y = -dt^2 g n (n + 1) / 2
    const double fallen = flag.position(2, 1).y + 0.1;
    CHECK(fallen == Approx(-10e-6 * 100 * 101 / 2).epsilon(1e-12));
    flag.set(Gravity{{0, 10, 0}});
    CHECK(flag.position(2, 1).y + 0.1 == fallen);
    flag.advance(100);  // thrown up again: v back to zero
    CHECK(std::abs(flag.state().velocity.at(2, 1).y) < 1e-13);
    CHECK(flag.time() == 200 * 1e-3);
}

TEST_CASE("A strength that is set changes neither where masses are nor how fast they move", "[physics]") {
    using Windy = Flag<double, Leapfrog, DiagonalSprings, SpringDamping, Gravity, AirDrag>;
    Windy flag(Grid{12, 9, 0.05, 0.05}, Attach::sides, {.mass = 1e-3, .stiffness = 200}, DiagonalSprings{100},
               SpringDamping{0.002}, Gravity{}, AirDrag{6e-4});
    for (const bool given : {false, true}) {
        if (given) flag.set_step(flag.dt());
        flag.advance(1000);
        const auto before = flag.state();
        flag.set(Cloth{.mass = 1e-3, .stiffness = given ? 200.0 : 3200.0});
        const auto after = flag.state();
        for (int j = 0; j < 9; ++j)
            for (int i = 0; i < 12; ++i) {
                CHECK(after.position.at(i, j) == before.position.at(i, j));
                CHECK(after.velocity.at(i, j) == before.velocity.at(i, j));
            }
    }
}

TEST_CASE("An automatic step follows the strengths that are set, a given one does not", "[physics]") {
    Flag<double, SemiImplicitEuler, AirDrag> flag(Grid{4, 3, 0.1, 0.1}, Attach::hoist, {.mass = 0.01, .stiffness = 100},
                                                  AirDrag{0.01});
    const double before = flag.dt();
    flag.set(Cloth{.mass = 0.01, .stiffness = 1e6});
    CHECK(flag.dt() < 0.011 * before);  // the bound is proportional to 1/sqrt(k)
    CHECK(flag.largest_stable_step().allows(flag.dt()));
    flag.set_step(1e-5);
    flag.set(Cloth{.mass = 0.01, .stiffness = 1e4});
    CHECK(flag.dt() == 1e-5);
}
