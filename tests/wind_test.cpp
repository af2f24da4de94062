// Wind: a pure function of seed and absolute time, as strong and as smooth as asked.
#include "catch.hpp"
#include "physics_sheet.hpp"
#include "run/simulation.hpp"

using namespace drapeau;
using namespace drapeau::testing;

namespace {

const Wind gusty{{6.0, 0.0, 1.0}, {2.0, 0.5, 1.5}, 1.5, 42};

}  // namespace

TEST_CASE("Wind does not depend on when, or how often, it is asked for", "[physics]") {
    std::vector<glm::dvec3> forwards;
    for (int n = 0; n < 1000; ++n) forwards.push_back(gusty.velocity(0.0137 * n));
    const Wind another = gusty;
    for (int n = 999; n >= 0; --n) {
        CHECK(another.velocity(0.0137 * n) == forwards[n]);
        another.velocity(-5.0 * n);
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
        const auto a = same.velocity(0.5 * n) - same.mean, b = other.velocity(0.5 * n) - other.mean;
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
                const auto w = wind.velocity(0.173 * period * n) - wind.mean;
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
        const auto once = gusty.velocity(t) - gusty.mean, twice = doubled.velocity(t) - gusty.mean;
        CHECK(length(twice - 2.0 * once) < 1e-14 * 20.0);  // roundings of numbers below 20 m/s
        CHECK(calm.velocity(t) == calm.mean);
        // Two noises bounded by 1.96 each, 0.894 and 0.447 of the strength
        for (int axis = 0; axis < 3; ++axis) CHECK(std::abs(once[axis]) <= 1.9568 * 1.3417 * gusty.gusts[axis]);
    }
}

TEST_CASE("Wind is twice continuously differentiable, across knots too", "[physics]") {
    // The slow gusts have a knot every period/2, the fast ones every period/8.
    const double h = 1e-4, knot = gusty.period / 8.0;
    const auto second_difference = [&](double t) {
        return (gusty.velocity(t - h) - 2.0 * gusty.velocity(t) + gusty.velocity(t + h)) / (h * h);
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
    const auto slope = [&](double t) { return (gusty.velocity(t + h) - gusty.velocity(t - h)) / (2.0 * h); };
    for (int n = 1; n < 400; ++n) jump = std::max(jump, length(slope(n * knot + 2 * h) - slope(n * knot - 2 * h)));
    CHECK(jump < 4.0 * h * 1000.0);
}

TEMPLATE_LIST_TEST_CASE("Runs at any step feel the same wind", "[physics]", AllCases) {
    // Masses with much drag move with the wind: whatever the step, at the same time they have the same velocity, but
    // for the method's own error, which halves with the step.
    Setting s{.grid = {2, 1, 0.1, 0.1}, .material = {0.01, 1.0, {}, {}}, .drag = 0.2, .wind = gusty};
    const double end = 3.0;
    std::vector<glm::dvec3> v;
    for (const int steps : {1500, 3000, 6000}) {
        Sheet<typename TestType::Real, typename TestType::Method> sheet(s);
        sheet.advance(end / steps, steps);
        v.push_back(sheet.velocities()[0]);
    }
    // v follows within m/d = 0.05 s, off by at most dt/2 |dw/dt|, some 2e-3/2 * 20 m/s2; then halved. A wind drawn
    // per step would leave differences of the gusts' own size, 1 m/s.
    CHECK(length(v[0] - v[1]) < 0.02);
    CHECK(length(v[1] - v[2]) < 0.6 * length(v[0] - v[1]) + 1e-5);
}
