// The benchmark's baseline, the report's own arrangement, moves as the core does: what is compared in speed is the same
// motion.
#include "catch.hpp"

#include "physics_reference.hpp"
#include "physics_sheet.hpp"
#include "report_arrangement.hpp"

using namespace drapeau;
using namespace drapeau::testing;

namespace {

const Springs springs{.mass = 1e-4, .stiffness = 200.0, .diagonal_stiffness = 100.0, .damping = 0.002};
const ReportSurroundings around{.wind = {6.0, 0.5, 1.0}, .drag = 6e-4};

/// The greatest distance (m) between masses moved by both for `steps` steps, and the greatest compression on the way.
struct Difference {
    double distance = 0.0;
    double compression = 0.0;  // share
};

Difference fly_both(const Grid& grid, Attach attach, const Springs& of, double prestretch, double dt, int steps) {
    const Model model(
        grid, of, attach,
        Terms().add(Gravity{around.gravity}).add(AirDrag{around.drag}).add(Wind{.velocity = around.wind}));
    const auto start = points_of(flat_start(grid, prestretch).position);
    Sheet<double, SemiImplicitEuler> core(model, start, at_rest(model));
    ReportArrangement<double> report(grid, attach, of, around);
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i)
            report.set(i, j, start[static_cast<std::size_t>(j) * grid.columns + i], glm::dvec3(0.0));

    const Reference reference(model);
    Difference difference;
    for (int step = 0; step < steps; ++step) {
        core.advance(dt, 1);
        report.advance(dt, 1);
        const auto x = core.positions();
        for (const auto& spring : reference.springs())
            difference.compression =
                std::max(difference.compression, 1.0 - length(x[spring.b] - x[spring.a]) / spring.rest);
    }
    const auto x = core.positions(), v = core.stored_velocities();
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            const auto n = static_cast<std::size_t>(j) * grid.columns + i;
            difference.distance = std::max(difference.distance, length(x[n] - report.position(i, j)));
            difference.distance = std::max(difference.distance, dt * length(v[n] - report.velocity(i, j)));
        }
    return difference;
}

/// How far rounding alone can part them (m). Of the eight springs of a mass each carries k times lengths of about L,
/// through some ten roundings of both programs, so a step's forces differ by at most 20 u 8 k L, and as much again
/// from positions rounded at their own size, |x| u k. Unless springs are compressed this grows with the square of time:
/// n^2 dt^2 / m times that. A compressed spring pushes aside with stiffness k s, s its compression, so growth is at
/// most by exp(t sqrt(2 * 8 k s / m)): a mass and its neighbours, each with eight such springs.
double rounding_bound(const Grid& grid, double dt, int steps, double compression) {
    const double u = epsilon<double> / 2;
    const double size = 1.2 * (grid.columns * grid.pitch_x + grid.rows * grid.pitch_y);
    const double force = 8.0 * springs.stiffness * u * (20.0 * grid.pitch_diagonal() + size);
    const double time = steps * dt;
    const double growth = std::exp(time * std::sqrt(16.0 * springs.stiffness * compression / springs.mass));
    return time * time / springs.mass * force * growth;
}

}  // namespace

TEST_CASE("the report's arrangement moves as the core does", "[report-arrangement]") {
    constexpr double dt = 3e-4;
    Springs plain = springs;
    plain.diagonal_stiffness.reset();

    SECTION("a taut sheet, all edges held") {
        const Grid grid{19, 14, 0.034, 0.031};
        const auto d = fly_both(grid, Attach::edges, springs, 0.2, dt, 400);
        CHECK(d.compression == 0.0);
        CHECK(d.distance < rounding_bound(grid, dt, 400, d.compression));
        CHECK(rounding_bound(grid, dt, 400, d.compression) < 1e-10);
    }
    SECTION("a taut sheet without diagonals") {
        const Grid grid{9, 21, 0.034, 0.034};
        const auto d = fly_both(grid, Attach::edges, plain, 0.2, dt, 400);
        CHECK(d.distance < rounding_bound(grid, dt, 400, d.compression));
        CHECK(rounding_bound(grid, dt, 400, d.compression) < 1e-10);
    }
    SECTION("a flag at the hoist") {
        const Grid grid{19, 14, 0.034, 0.031};
        const auto d = fly_both(grid, Attach::hoist, springs, 0.0, dt, 100);
        CHECK(d.distance < rounding_bound(grid, dt, 100, d.compression));
        CHECK(rounding_bound(grid, dt, 100, d.compression) < 1e-6);  // small beside what one wrong force does
    }
    SECTION("chains") {
        for (const Grid& grid : {Grid{1, 12, 0.034, 0.034}, Grid{12, 1, 0.034, 0.034}}) {
            const auto d = fly_both(grid, Attach::corner, springs, 0.0, dt, 100);
            CHECK(d.distance < rounding_bound(grid, dt, 100, d.compression));
            CHECK(rounding_bound(grid, dt, 100, d.compression) < 1e-6);  // small beside what one wrong force does
        }
    }
}
