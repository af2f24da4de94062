// Fabric: one cloth on every grid. Its springs hold the energy of a membrane whose threads have the modulus Y, its
// masses weigh what the cloth weighs, and what can be said in closed form does not depend on the grid.
#include "catch.hpp"
#include "physics_reference.hpp"
#include "physics_sheet.hpp"

using namespace drapeau;
using namespace drapeau::testing;

namespace {

/// Grids of one cloth, square cells and others, none longer than 1.4 times its width.
const Grid grids[] = {spread(2, 2, 0.9, 0.9), spread(12, 8, 1.1, 0.7), spread(12, 8, 1.5, 0.7), spread(7, 9, 0.6, 1.1)};

std::vector<Fabric> fabrics() {
    std::vector<Fabric> all;
    for (const auto name : {FabricName::knitted_polyester, FabricName::woven_polyester, FabricName::nylon,
                            FabricName::silk, FabricName::canvas})
        all.push_back(fabric_of(name));
    for (const std::optional<double> share : {std::optional<double>(), std::optional(0.5), std::optional(0.9)})
        all.push_back({.density = 0.2, .stretch_modulus = 500.0, .diagonal_share = share});
    return all;
}

Model sheet_of(const Fabric& fabric, const Grid& grid, Attach attach = Attach::none, const Terms& terms = {}) {
    return model_of(fabric, grid, attach, terms);
}

struct Strain {
    double xx, yy, xy;
};

/// J, of the sheet strained alike everywhere, over its area.
double energy_of(const Fabric& fabric, const Grid& grid, const Strain& e) {
    const Model model = sheet_of(fabric, grid);
    auto x = scattered(grid, 0.0);
    for (auto& p : x) p += glm::dvec3{e.xx * p.x + e.xy * p.y, e.xy * p.x + e.yy * p.y, 0.0};
    Sheet<double, SemiImplicitEuler> sheet(model, x, at_rest(model));
    return sheet.measure().elastic / ((grid.columns - 1) * grid.pitch_x * (grid.rows - 1) * grid.pitch_y);
}

}  // namespace

TEST_CASE("A strip of fabric pulled along its threads resists by its modulus, and by its share elsewhere",
          "[physics]") {
    // C11 = k (1 + s), C12 = C66 = k s with k = Y (1 + s)/(1 + 2s): pulled by e while it narrows as it likes, by
    // C12/C11 e, it holds Y e^2/2 an area. Energies are known to the strain's size, lengths to eps over that.
    const double e = 1e-5, known = 4.0 * e;
    for (const Fabric& fabric : fabrics())
        for (const Grid& grid : grids) {
            const double s = fabric.diagonal_share.value_or(0.0), Y = fabric.stretch_modulus;
            const double narrows = s / (1.0 + s), shear = Y * s * (1.0 + s) / (1.0 + 2.0 * s);
            INFO(s << ", cells of " << grid.pitch_x << " x " << grid.pitch_y << " m");
            CHECK(energy_of(fabric, grid, {e, -narrows * e, 0.0}) == Approx(0.5 * Y * e * e).epsilon(known));
            CHECK(energy_of(fabric, grid, {-narrows * e, e, 0.0}) == Approx(0.5 * Y * e * e).epsilon(known));
            // Of the tensor's shear e twice that is the angle's change. Without diagonals only the threads' own stretch
            // is left, of order e^2.
            CHECK(energy_of(fabric, grid, {0.0, 0.0, e}) ==
                  Approx(2.0 * shear * e * e).epsilon(known).margin(Y * std::pow(e, 4)));
        }
}

TEST_CASE("At a share of one half fabric is alike in all directions, on cells that are not square too", "[physics]") {
    const double e = 1e-5;
    const Fabric fabric{.diagonal_share = 0.5}, woven{.diagonal_share = 0.1};
    for (const Grid& grid : grids)
        for (const double degrees : {10.0, 30.0, 45.0, 80.0}) {
            // A stretch along a direction so many degrees from the fly.
            const double angle = degrees * 3.141592653589793 / 180.0, c = std::cos(angle), s = std::sin(angle);
            const Strain turned{e * c * c, e * s * s, e * c * s};
            CHECK(energy_of(fabric, grid, turned) == Approx(energy_of(fabric, grid, {e, 0.0, 0.0})).epsilon(8.0 * e));
            CHECK(energy_of(woven, grid, turned) < 0.99 * energy_of(woven, grid, {e, 0.0, 0.0}));
        }
}

TEST_CASE("Fabric weighs the same on every grid", "[physics]") {
    for (const auto& [columns, rows] : {std::pair{2, 2}, {12, 8}, {45, 30}, {100, 65}, {200, 130}}) {
        const Model model = sheet_of({.density = 0.11}, spread(columns, rows, 1.5, 1.0));
        CHECK(model.total_mass() == Approx(0.165).epsilon(1e-12));
    }
}

TEST_CASE("Hung without shear springs fabric sags by rho g H^2 / 2Y, whatever the grid", "[physics]") {
    // Every thread carries what hangs below it, and half a border mass hangs at the end: the sum over springs is the
    // integral. So hung it stays: a step from rest gives no mass more speed than rounding does.
    const double rho = 0.11, g = 9.8, Y = 300.0, H = 0.7, dt = 1e-4;
    const Fabric fabric{.density = rho, .stretch_modulus = Y, .diagonal_share = {}, .damping_time = {}};
    for (const auto& [columns, rows] : {std::pair{2, 2}, {12, 8}, {45, 30}, {200, 130}, {60, 9}}) {
        const Grid grid = spread(columns, rows, 1.5, H);
        const Model model = sheet_of(fabric, grid, Attach::top, Terms().add(Gravity{{0.0, -g, 0.0}}));
        auto x = scattered(grid, 0.0);
        for (auto& p : x) {
            const double s = -p.y;  // down the thread, at rest
            p.y -= rho * g * (H * s - 0.5 * s * s) / Y;
        }
        CHECK(-x.back().y - H == Approx(rho * g * H * H / (2.0 * Y)).epsilon(1e-12));
        Sheet<double, SemiImplicitEuler> sheet(model, x, at_rest(model));
        sheet.advance(dt, 1);
        // Forces of two springs, each known to 8 eps k H, on half a mass at least.
        const double k = model.springs.stiffest(), rounding = 2.0 * 8.0 * epsilon<double> * k * H * dt;
        CHECK(distance(sheet.velocities(), at_rest(model)) < rounding / (0.5 * model.springs.mass));
    }
}

TEST_CASE("Fabric falls at rho g / d_A in still air, borders and corners as the inside", "[physics]") {
    const double rho = 0.11, g = 9.8, d = 0.53, speed = rho * g / d;  // 2.03 m/s
    const Fabric fabric{.density = rho, .drag_per_area = d};
    for (const Grid& grid : grids) {
        const Model model = sheet_of(fabric, grid, Attach::none, Terms().add(Gravity{{0.0, -g, 0.0}}));
        const Points falling(static_cast<std::size_t>(masses_of(model)), glm::dvec3{0.0, -speed, 0.0});
        Sheet<double, Leapfrog> sheet(model, scattered(grid, 0.0), falling);
        sheet.advance(1e-4, 1000);
        // Each step's kicks cancel to eps of g dt; places are rounded to eps of a metre and feed springs of k/m.
        const double rounding =
            1000 * epsilon<double> * (g * 1e-4 + 8.0 * model.springs.stiffest() / (0.25 * model.springs.mass) * 1e-4);
        CHECK(distance(sheet.velocities(), falling) < rounding);
    }
}

TEMPLATE_LIST_TEST_CASE("Every mass of a fabric is accelerated as springs, dampers and drag of its cells say",
                        "[physics]", Precisions) {
    const Terms weather = Terms().add(Gravity{}).add(Wind{.velocity = {3.0, 0.5, 1.0}});
    for (Fabric fabric : fabrics())
        for (const auto& [columns, rows] : awkward_sizes) {
            fabric.drag_per_area = 0.5;
            const Grid grid{columns, rows, 0.05, 0.04};
            const Model model = sheet_of(fabric, grid, Attach::corner, weather);
            const Reference reference(model, Borders::light);
            const double dt = 1e-4;
            Sheet<TestType, ForwardEuler> sheet(model, scattered(grid, 0.005), noise(masses_of(model), 0.5));
            const auto x = sheet.positions(), v = sheet.velocities();
            sheet.advance(dt, 1);
            auto expected = v;
            const auto a = reference.acceleration(x, v, 0.0);
            for (std::size_t n = 0; n < v.size(); ++n) expected[n] += dt * a[n];
            // Forces of eight springs, each known to 8 eps (k l + k L), on a quarter of the mass at worst.
            const double rounding =
                8.0 * 8.0 * epsilon<TestType> * model.springs.stiffest() * 0.15 * dt / (0.25 * model.springs.mass);
            CHECK(distance(sheet.velocities(), expected) < rounding);
        }
}

TEST_CASE("The bound holds for cells that are not square and is sharp", "[physics][stability]") {
    // Semi-implicit Euler is stable if and only if 4M - dt^2 K - 2 dt C is positive definite. With all springs in one
    // line every one resists along it with all of its stiffness; the fastest wave of n cells a side is slower than the
    // bound says by a share (pi/2n)^2 of lambda at most, 4 % here.
    for (const Fabric& fabric : fabrics())
        for (const double longer : {0.8, 1.25}) {
            const int n = 8;
            const Grid grid{n + 1, n + 1, 0.05 * longer, 0.05};
            const Model model = sheet_of(fabric, grid);
            const Reference reference(model, Borders::light);
            const double limit = stable_step(SemiImplicitEuler{}, model).seconds();
            const auto is_stable = [&](const Points& x, double dt) {
                return reference.combined(x, 4.0, -dt * dt, -2.0 * dt, 0.0).is_positive_definite();
            };
            Points in_line = scattered(grid, 0.0);
            for (auto& p : in_line) p = {2.0 * p.x - 0.7 * p.y, 0.0, 0.0};
            INFO("share " << fabric.diagonal_share.value_or(0.0) << ", cells " << longer);
            for (const Points& x : {scattered(grid, 0.0), scattered(grid, 0.04), in_line})
                CHECK(is_stable(x, 0.9999 * limit));
            CHECK_FALSE(is_stable(in_line, 1.05 * limit));
        }
}
