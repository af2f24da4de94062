// Borders and held masses: what stands for half a strip of cloth has half its mass, drag and stiffness; a held mass
// stays where it is, whatever pulls.
#include "catch.hpp"
#include "physics_reference.hpp"
#include "physics_sheet.hpp"

#include <string>

using namespace drapeau;
using namespace drapeau::testing;

namespace {

const auto springs_of = all_springs(0.01, 200.0, 100.0, 0.05);
const Terms weather =
    Terms().add(Gravity{}).add(AirDrag{0.02}).add(Friction{0.01}).add(Wind{.velocity = {3.0, 0.5, 1.0}});

}  // namespace

TEST_CASE("Light borders weigh what the cloth inside them weighs", "[physics]") {
    // (columns - 1) (rows - 1) cells of one inner mass each; a chain: (N - 1) springs' worth.
    for (const auto& [columns, rows] : {std::pair{2, 2}, {5, 4}, {17, 3}, {1, 6}, {6, 1}}) {
        const Model model({columns, rows, 0.1, 0.1}, springs_of[3], Attach::hoist, {}, {}, Borders::light);
        double sum = 0.0;
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i) sum += model.mass(i, j);
        CHECK(sum == Approx(0.01 * std::max(columns - 1, 1) * std::max(rows - 1, 1)).epsilon(1e-14));
        CHECK(model.mass(columns > 2 ? 1 : 0, rows > 2 ? 1 : 0) ==
              Approx(0.01 * (columns == 2 ? 0.5 : 1.0) * (rows == 2 ? 0.5 : 1.0)));
    }
}

TEMPLATE_LIST_TEST_CASE("Every mass of a cloth with light borders is accelerated as its share says", "[physics]",
                        Precisions) {
    for (const auto& [columns, rows] : awkward_sizes)
        for (const auto& springs : springs_of) {
            const Model model({columns, rows, 0.1, 0.08}, springs, Attach::corner, weather, {}, Borders::light);
            const Reference reference(model, Borders::light);
            // A step of forward Euler changes velocities by dt a, drag and friction included.
            const double dt = 1e-3;
            Sheet<TestType, ForwardEuler> sheet(model, scattered(model.grid, 0.02), noise(masses_of(model), 0.5));
            const auto x = sheet.positions(), v = sheet.velocities();
            sheet.advance(dt, 1);
            const auto v_next = sheet.velocities();
            auto expected = v;
            const auto a = reference.acceleration(x, v, 0.0);
            for (std::size_t n = 0; n < v.size(); ++n) expected[n] += dt * a[n];
            // Forces of eight springs, each known to 8 eps (k l + k L), on a quarter of the mass at worst
            const double rounding = 8.0 * 8.0 * epsilon<TestType> * 200.0 * 0.3 * dt / (0.25 * 0.01);
            CHECK(distance(v_next, expected) < rounding);
        }
}

TEMPLATE_LIST_TEST_CASE("A held mass stays and is pulled at in vain, and the others feel it as any neighbour",
                        "[physics]", AllCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    for (const auto& springs : springs_of) {
        Model model({7, 6, 0.1, 0.08}, springs, Attach::none, weather);
        model.hold(3, 2), model.hold(5, 2), model.hold(0, 5);
        int held = 0;
        for (int n = 0; n < 42; ++n) held += is_held(model, n);
        CHECK(held == 3);  // and no other of their rows, nor of rows alike
        CHECK(is_held(model, 2 * 7 + 3));

        const auto start = scattered(model.grid, 0.02);
        auto v = noise(42, 0.5);
        Sheet<Real, Method> sheet(model, start, v);
        const auto x = sheet.positions();
        v = sheet.velocities();
        const double dt = 1e-4;
        const int steps = 100;
        sheet.advance(dt, steps);
        const auto x_next = sheet.positions();
        auto exact = x, exact_v = v;
        Reference(model).runge_kutta(exact, exact_v, dt, steps);
        for (int n = 0; n < 42; ++n)
            if (is_held(model, n)) {
                CHECK(x_next[n] == x[n]);
                CHECK(sheet.velocities()[n] == glm::dvec3(0.0));
            }
        // Methods of order 1 are off by half a step's kick for the whole time, 0.5 dt |a| t with |a| up to
        // 200 N/m * 0.1 m / 0.01 kg; one free mass in the place of a held one would be by t^2 |a|/2, 1000 times as far.
        CHECK(distance(x_next, exact) < dt * 2000.0 * dt * steps);
        CHECK(distance(x_next, x) > 1e-3);
    }
}

TEST_CASE("Every way to attach a flag holds the masses it says", "[physics]") {
    const Grid grid{4, 3, 0.1, 0.1};
    const std::pair<Attach, std::string> patterns[] = {
        {Attach::hoist, "#...#...#..."},  {Attach::grommets, "#.......#..."}, {Attach::top, "####........"},
        {Attach::corner, "#..........."}, {Attach::sides, "#..##..##..#"},    {Attach::edges, "#####..#####"},
        {Attach::all, "############"},    {Attach::none, "............"}};
    for (const auto& [attach, pattern] : patterns) {
        const Model model(grid, springs_of[3], attach);
        std::string held;
        for (int n = 0; n < 12; ++n) held += is_held(model, n) ? '#' : '.';
        CHECK(held == pattern);
    }
}
