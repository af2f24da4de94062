// The benchmark's baseline, the report's own arrangement, moves as the core does: what is compared in speed is the same
// motion.
#include "catch.hpp"

#include "report_arrangement.hpp"

#include "drapeau/drapeau.hpp"

#include <limits>

using namespace drapeau;

namespace {

const Material material{.mass = 1e-4, .stiffness = 200.0, .diagonal_stiffness = 100.0, .damping = 0.002};
const ReportSurroundings around{.wind = {6.0, 0.5, 1.0}, .drag = 6e-4};

/// The greatest distance (m) between masses moved by both for `steps` steps, and the greatest compression on the way.
struct Difference {
    double distance = 0.0;
    double compression = 0.0;  // share
};

template <class... Springs>
Difference fly_both(const Grid& grid, Attach attach, const Material& m, double prestretch, double dt, int steps,
                    const Springs&... springs) {
    Flag<double, Springs..., AirDrag, UniformWind, Gravity> core(grid, attach, m.mass, springs..., AirDrag{around.drag},
                                                                 UniformWind{{.mean = around.wind}}, Gravity{});
    ReportArrangement<double> report(grid, attach, m, around);
    const auto start = flat_start(grid, prestretch);
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            const auto& x = start[static_cast<std::size_t>(j) * grid.columns + i];
            core.cloth().set_position(i, j, x);
            report.set(i, j, x, glm::dvec3(0.0));
        }

    Difference difference;
    for (int step = 0; step < steps; ++step) {
        core.advance(SemiImplicitEuler{}, dt, 1);
        report.advance(dt, 1);
        for_each_spring(grid, m, [&](int i, int j, int i2, int j2, double, double length) {
            const double l = glm::length(core.cloth().position(i2, j2) - core.cloth().position(i, j));
            difference.compression = std::max(difference.compression, 1.0 - l / length);
        });
    }
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            difference.distance =
                std::max(difference.distance, glm::length(core.cloth().position(i, j) - report.position(i, j)));
            difference.distance =
                std::max(difference.distance, dt * glm::length(core.cloth().velocity(i, j) - report.velocity(i, j)));
        }
    return difference;
}

/// How far rounding alone can part them (m). Of the eight springs of a mass each carries k times lengths of about L,
/// through some ten roundings of both programs, so a step's forces differ by at most 20 u 8 k L, and as much again
/// from positions rounded at their own size, |x| u k. Unless springs are compressed this grows with the square of time:
/// n^2 dt^2 / m times that. A compressed spring pushes aside with stiffness k s, s its compression, so growth is at
/// most by exp(t sqrt(2 * 8 k s / m)): a mass and its neighbours, each with eight such springs.
double rounding_bound(const Grid& grid, double dt, int steps, double compression) {
    const double u = std::numeric_limits<double>::epsilon() / 2;
    const double size = 1.2 * (grid.columns * grid.pitch_x + grid.rows * grid.pitch_y);
    const double force = 8.0 * material.stiffness * u * (20.0 * grid.pitch_diagonal() + size);
    const double time = steps * dt;
    const double growth = std::exp(time * std::sqrt(16.0 * material.stiffness * compression / material.mass));
    return time * time / material.mass * force * growth;
}

}  // namespace

TEST_CASE("the report's arrangement moves as the core does", "[report-arrangement]") {
    constexpr double dt = 3e-4;
    const StructuralSprings structural{material.stiffness};
    const DiagonalSprings diagonal{*material.diagonal_stiffness};
    const SpringDamping damping{*material.damping};
    Material plain = material;
    plain.diagonal_stiffness.reset();

    SECTION("a taut sheet, all edges held") {
        const Grid grid{19, 14, 0.034, 0.031};
        const auto d = fly_both(grid, Attach::edges, material, 0.2, dt, 400, structural, diagonal, damping);
        CHECK(d.compression == 0.0);
        CHECK(d.distance < rounding_bound(grid, dt, 400, d.compression));
        CHECK(rounding_bound(grid, dt, 400, d.compression) < 1e-10);
    }
    SECTION("a taut sheet without diagonals") {
        const Grid grid{9, 21, 0.034, 0.034};
        const auto d = fly_both(grid, Attach::edges, plain, 0.2, dt, 400, structural, damping);
        CHECK(d.distance < rounding_bound(grid, dt, 400, d.compression));
        CHECK(rounding_bound(grid, dt, 400, d.compression) < 1e-10);
    }
    SECTION("a flag at the hoist") {
        const Grid grid{19, 14, 0.034, 0.031};
        const auto d = fly_both(grid, Attach::hoist, material, 0.0, dt, 100, structural, diagonal, damping);
        CHECK(d.distance < rounding_bound(grid, dt, 100, d.compression));
        CHECK(rounding_bound(grid, dt, 100, d.compression) < 1e-6);  // small beside what one wrong force does
    }
    SECTION("chains") {
        for (const Grid& grid : {Grid{1, 12, 0.034, 0.034}, Grid{12, 1, 0.034, 0.034}}) {
            const auto d = fly_both(grid, Attach::corner, material, 0.0, dt, 100, structural, diagonal, damping);
            CHECK(d.distance < rounding_bound(grid, dt, 100, d.compression));
            CHECK(rounding_bound(grid, dt, 100, d.compression) < 1e-6);  // small beside what one wrong force does
        }
    }
}
