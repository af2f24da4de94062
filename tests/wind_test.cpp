// Wind: a pure function of seed and absolute time, as strong and as smooth as asked.
#include "catch.hpp"
#include "physics_sheet.hpp"

using namespace drapeau;
using namespace drapeau::testing;

namespace {

const Wind gusty{{6.0, 0.0, 1.0}, {2.0, 0.5, 1.5}, 1.5, false, 42};

}  // namespace

TEST_CASE("Wind does not depend on when, or how often, it is asked for", "[physics]") {
    std::vector<glm::dvec3> forwards;
    for (int n = 0; n < 1000; ++n) forwards.push_back(gusty.at(0.0137 * n));
    const Wind another = gusty;
    for (int n = 999; n >= 0; --n) {
        CHECK(another.at(0.0137 * n) == forwards[n]);
        another.at(-5.0 * n);
    }
}

TEST_CASE("Seeds and axes blow independently", "[physics]") {
    Wind other = gusty;
    other.seed = 43;
    other.gusts = {2.0, 2.0, 2.0};
    Wind same = other;
    same.seed = 42;
    // Correlations over 20000 s, that is some 2 * 20000/1.5 knots of slow gusts: 1/sqrt(26667) = 0.006 each; 5 sigma.
    double seeds = 0.0, axes = 0.0, neighbours = 0.0;
    const int count = 40000;
    for (int n = 0; n < count; ++n) {
        const auto a = same.at(0.5 * n) - same.velocity, b = other.at(0.5 * n) - other.velocity;
        seeds += a.x * b.x / (4.0 * count);
        axes += a.x * a.z / (4.0 * count);
        neighbours += a.x * a.y / (4.0 * count);
    }
    CHECK(std::abs(seeds) < 0.03);
    CHECK(std::abs(axes) < 0.03);
    CHECK(std::abs(neighbours) < 0.03);
}

TEST_CASE("Gusts have the mean and the root mean square asked for", "[physics]") {
    for (const std::uint64_t seed : {0, 1, 7, 1000000007})
        for (const double period : {0.1, 1.5, 20.0}) {
            Wind wind = gusty;
            wind.seed = seed, wind.period = period;
            glm::dvec3 sum(0.0), squares(0.0);
            const int count = 200000;
            for (int n = 0; n < count; ++n) {
                const auto w = wind.at(0.173 * period * n) - wind.velocity;
                sum += w, squares += w * w;
            }
            // 0.173 * 2 * 200000 = 69200 knots: the mean is known to sigma/sqrt(69200) * sqrt(1.3) or so, 0.4 % of
            // sigma; the square's own deviation is below sigma^2: 0.4 % of the variance. Five deviations each.
            for (int axis = 0; axis < 3; ++axis) {
                CHECK(std::abs(sum[axis] / count) < 0.02 * wind.gusts[axis]);
                CHECK(std::sqrt(squares[axis] / count) == Approx(wind.gusts[axis]).epsilon(0.02));
            }
        }
}

TEST_CASE("Gusts scale with their strength, and none are none", "[physics]") {
    Wind doubled = gusty, calm = gusty;
    doubled.gusts *= 2.0;
    calm.gusts = glm::dvec3(0.0);
    for (int n = 0; n < 200; ++n) {
        const double t = 0.31 * n;
        const auto once = gusty.at(t) - gusty.velocity, twice = doubled.at(t) - gusty.velocity;
        CHECK(length(twice - 2.0 * once) < 1e-14 * 20.0);  // roundings of numbers below 20 m/s
        CHECK(calm.at(t) == calm.velocity);
        // Two noises bounded by 1.96 each, 0.894 and 0.447 of the strength
        for (int axis = 0; axis < 3; ++axis) CHECK(std::abs(once[axis]) <= 1.9568 * 1.3417 * gusty.gusts[axis]);
    }
}

TEST_CASE("Wind is twice continuously differentiable, across knots too", "[physics]") {
    // The slow gusts have a knot every period/2, the fast ones every period/8.
    const double h = 1e-4, knot = gusty.period / 8.0;
    const auto second_difference = [&](double t) {
        return (gusty.at(t - h) - 2.0 * gusty.at(t) + gusty.at(t + h)) / (h * h);
    };
    double greatest = 0.0, greatest_jump = 0.0;
    for (int n = 1; n < 400; ++n) {
        greatest = std::max(greatest, length(second_difference((n + 0.2) * knot)));
        greatest_jump =
            std::max(greatest_jump, length(second_difference(n * knot + 2 * h) - second_difference(n * knot - 2 * h)));
    }
    // A jump of the second derivative would be of its own size, some 10^3 m/s3. What 4h allows is 4h times the third,
    // 60 * 2 * 1.957 * 0.447 * |gusts| / knot^3 at most on fast gusts: |gusts| = 2.6 m/s: 270 / 6.6e-3 * 4e-4 = 17,
    // and rounding of the differences 4 eps 10 m/s / h^2 = 1.
    CHECK(greatest > 200.0);
    CHECK(greatest_jump < 20.0);

    // The first derivative alike: its jump is at most 4h times the second.
    double jump = 0.0;
    const auto slope = [&](double t) { return (gusty.at(t + h) - gusty.at(t - h)) / (2.0 * h); };
    for (int n = 1; n < 400; ++n) jump = std::max(jump, length(slope(n * knot + 2 * h) - slope(n * knot - 2 * h)));
    CHECK(jump < 4.0 * h * 1000.0);
}

TEMPLATE_LIST_TEST_CASE("Runs at any step feel the same wind, travelling or not", "[physics]", AllCases) {
    // Masses with much drag move with the wind: whatever the step, at the same time they have the same velocity, but
    // for the method's own error, which halves with the step.
    for (const bool travelling : {false, true}) {
        Wind wind = gusty;
        wind.travelling = travelling;
        const Model model({2, 2, 3.0, 3.0}, {0.01, 1.0, {}, {}}, Attach::none, Terms().add(AirDrag{0.2}).add(wind));
        const double end = 3.0;
        std::vector<Points> v;
        for (const int steps : {1500, 3000, 6000}) {
            Sheet<typename TestType::Real, typename TestType::Method> sheet(model);
            sheet.advance(end / steps, steps);
            v.push_back(sheet.velocities());
        }
        // v follows within m/d = 0.05 s, off by at most dt/2 |dw/dt|, some 2e-3/2 * 20 m/s2; then halved. A wind drawn
        // per step would leave differences of the gusts' own size, 1 m/s. What is below 1e-4 m/s is rounding: in float
        // a step's increment is known to eps v/2, 4e-7 m/s, and 25 to 100 of these act at a time (m/d over dt).
        CHECK(distance(v[0], v[1]) < 0.02);
        CHECK(distance(v[1], v[2]) < 0.6 * distance(v[0], v[1]) + 1e-4);
        // Between masses 3 m apart along the wind, the gust arrives half a second later.
        CHECK((length(v[2][0] - v[2][1]) > 0.05) == travelling);
    }
}

namespace {

/// Steady winds along the fly, slow, fast and none, with and without a component along the rows' order, and across.
const glm::dvec3 means[] = {{6.0, 0.0, 1.0}, {6.0, -2.0, 1.0}, {0.3, 0.2, 0.0}, {0.0, 0.0, 4.0}, {0.0, 0.0, 0.0}};

/// Gusts carried along by the mean wind U, written as the formula stands: gust(t - s/max(|U|, 1)), s along U.
glm::dvec3 carried(const Wind& wind, double t, const glm::dvec3& rest) {
    Wind uniform = wind;
    uniform.travelling = false;
    const double speed = length(wind.velocity);
    const double s = speed > 0.0 ? dot(rest, wind.velocity) / speed : 0.0;
    return uniform.at(t - s / std::max(speed, 1.0));
}

Wind travelling_with(const glm::dvec3& mean) {
    return {mean, {2.0, 0.5, 1.5}, 0.2, true, 42};
}

/// The acceleration of every mass that a wind gives, row by row.
template <class Real>
Points pushed(const Wind& wind, const Grid& grid, const std::vector<Real>& drag_rate, double t) {
    Points all;
    for (int j = 0; j < grid.rows; ++j) {
        FieldBuffer<Real> a(grid.columns, 1);
        wind.accelerate(PushedRow<Real>{grid, j, padded<Real>(grid.columns), drag_rate.data()}, t, a.view());
        for (int i = 0; i < grid.columns; ++i) all.push_back(a.at(i, 0));
    }
    return all;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("Travelling gusts push every mass by what the formula says of its place", "[physics]",
                        Precisions) {
    const Grid grid{37, 5, 0.05, 0.06};
    for (const auto& mean : means) {
        const Wind wind = travelling_with(mean);
        std::vector<TestType> drag_rate(static_cast<std::size_t>(padded<TestType>(grid.columns)));
        for (std::size_t i = 0; i < drag_rate.size(); ++i) drag_rate[i] = TestType(1) + TestType(0.01) * TestType(i);
        for (const double t : {0.0, 0.37, 12.3456, -2.0}) {
            const auto a = pushed(wind, grid, drag_rate, t);
            double worst = 0.0, worst_place = 0.0;
            for (int j = 0; j < grid.rows; ++j)
                for (int i = 0; i < grid.columns; ++i) {
                    const auto exact = carried(wind, t, grid.rest(i, j));
                    const auto rate = static_cast<double>(drag_rate[static_cast<std::size_t>(i)]);
                    worst = std::max(worst, length(a[static_cast<std::size_t>(j * grid.columns + i)] - rate * exact));
                    worst_place = std::max(worst_place, length(wind.at(t, grid.rest(i, j)) - exact));
                }
            // A speed below 15 m/s rounded once to Real, and a product with a rate below 1.4/s; the place among a
            // gust's knots, up to 500 of them, is known to 500 eps, which its slope of some 10 m/s a knot passes on.
            CHECK(worst < 2.0 * 15.0 * 1.4 * epsilon<TestType> + 1e4 * epsilon<double>);
            CHECK(worst_place < 1e4 * epsilon<double>);
        }
    }
}

TEST_CASE("Travelling gusts differ from row to row only where the mean wind blows along it", "[physics]") {
    const Grid grid{5, 4, 0.1, 0.1};
    for (const auto& mean : means) {
        const Wind wind = travelling_with(mean);
        CHECK(wind.varies_by_row(grid) == (mean.y != 0.0));
        bool differ = false;
        for (int n = 0; n < 50; ++n)
            differ = differ || wind.at(0.1 * n, grid.rest(2, 0)) != wind.at(0.1 * n, grid.rest(2, 3));
        CHECK(differ == wind.varies_by_row(grid));
    }
}

TEMPLATE_LIST_TEST_CASE("Travelling wind is the uniform one where it has not gone any way yet", "[physics]",
                        Precisions) {
    // At the origin whatever the mean; everywhere where it blows across the flag, or not at all.
    const Grid grid{19, 3, 0.05, 0.06};
    const std::vector<TestType> drag_rate(static_cast<std::size_t>(padded<TestType>(grid.columns)), TestType(1));
    for (const auto& mean : means) {
        const Wind wind = travelling_with(mean);
        Wind uniform = wind;
        uniform.travelling = false;
        for (const double t : {0.0, 0.37, 12.3456}) {
            const auto a = pushed(wind, grid, drag_rate, t), b = pushed(uniform, grid, drag_rate, t);
            const bool across = mean.x == 0.0 && mean.y == 0.0;
            // The same sums in another order, rounded to Real: below 15 m/s.
            for (std::size_t n = 0; n < (across ? a.size() : 1); ++n)
                CHECK(length(a[n] - b[n]) < 2.0 * 15.0 * epsilon<TestType>);
        }
    }
}

TEST_CASE("Travelling gusts have the mean and the root mean square asked for at every place", "[physics]") {
    const Wind wind = travelling_with({6.0, -2.0, 1.0});
    for (const glm::dvec3& place : {glm::dvec3{0.0}, glm::dvec3{1.5, -0.7, 0.0}}) {
        glm::dvec3 sum(0.0), squares(0.0);
        const int count = 100000;
        for (int n = 0; n < count; ++n) {
            const auto w = wind.at(0.173 * wind.period * n, place) - wind.velocity;
            sum += w, squares += w * w;
        }
        // As above, for half as many knots
        for (int axis = 0; axis < 3; ++axis) {
            CHECK(std::abs(sum[axis] / count) < 0.03 * wind.gusts[axis]);
            CHECK(std::sqrt(squares[axis] / count) == Approx(wind.gusts[axis]).epsilon(0.03));
        }
    }
}

TEST_CASE("A gust arrives downwind later by the way over the speed", "[physics]") {
    const Wind wind = travelling_with({3.0, 0.0, 4.0});
    // 1 m along the fly is 0.6 m along the wind, which does 5 m/s.
    for (int n = 0; n < 100; ++n) {
        const double t = 0.137 * n;
        CHECK(length(wind.at(t + 0.12, {1.0, 0.0, 0.0}) - wind.at(t, {0.0, 0.0, 0.0})) < 1e4 * epsilon<double>);
    }
    // A wind of less than 1 m/s carries them with 1 m/s.
    const Wind slow = travelling_with({0.5, 0.0, 0.0});
    CHECK(length(slow.at(1.0 + 1.0, {1.0, 0.0, 0.0}) - slow.at(1.0, {0.0, 0.0, 0.0})) < 1e4 * epsilon<double>);
}
