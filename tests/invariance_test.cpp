// Invariance: what physics says cannot matter, and what it says is kept.
#include "catch.hpp"
#include "physics_reference.hpp"
#include "physics_sheet.hpp"

using namespace drapeau;
using namespace drapeau::testing;

namespace {

constexpr double m = 0.01, k = 200.0, kd = 100.0, c = 0.05;

/// Every awkward size, with and without diagonals and damping.
template <class Visit>
void for_each_sheet(Visit&& visit) {
    for (const auto& [columns, rows] : awkward_sizes)
        for (const auto& springs : all_springs(m, k, kd, c)) visit(Grid{columns, rows, 0.1, 0.08}, springs);
}

/// A step at which a hundred steps of forward Euler too stay tame (it lets an undamped mode grow by
/// sqrt(1 + (omega dt)^2) a step: 1.005 at a twentieth of the limit).
template <class Method>
double tame_step(const Model& model) {
    const double limit = stable_step(SemiImplicitEuler{}, model).seconds();
    return (std::is_same_v<Method, ForwardEuler> ? 0.05 : 0.35) * limit;
}

constexpr int steps = 100;

/// What `steps` steps may differ by when each differs by a few roundings of numbers of `size` metres: such an error is
/// a change of velocity of a few eps size/dt times (omega dt)^2 <= 0.5, which then acts for the rest of the run:
/// steps^2/2 * 0.5 * a few eps size.
template <class Real>
double rounding(double size) {
    return steps * steps * epsilon<Real> * size;
}

glm::dvec3 momentum(const Points& v) {
    glm::dvec3 sum(0.0);
    for (const auto& p : v) sum += m * p;
    return sum;
}
glm::dvec3 angular_momentum(const Points& x, const Points& v) {
    glm::dvec3 sum(0.0);
    for (std::size_t n = 0; n < x.size(); ++n) sum += m * cross(x[n], v[n]);
    return sum;
}

constexpr auto identity = [](const glm::dvec3& p) { return p; };
/// Gravity, drag, friction and steady wind, their directions as `turn` has them.
template <class Turn>
Terms blown(Turn&& turn) {
    return Terms()
        .add(Gravity{turn(glm::dvec3{1.0, -9.81, 0.5})})
        .add(AirDrag{0.02})
        .add(Friction{0.01})
        .add(Wind{.velocity = turn(glm::dvec3{3.0, 1.0, -2.0})});
}

template <class Change>
Points changed(Points points, Change&& change) {
    for (auto& p : points) p = change(p);
    return points;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("Springs and their dampers keep the momentum of a free sheet", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    for_each_sheet([](const Grid& grid, const Springs& springs) {
        const Model model(grid, springs, Attach::none);
        const auto v = noise(masses_of(model), 1.0);
        Sheet<Real, Method> sheet(model, scattered(grid, 0.02), v);
        const auto before = momentum(sheet.velocities());
        sheet.advance(tame_step<Method>(model), steps);
        // Each evaluation rounds every velocity, up to 5 m/s, by a few halves of eps; the sum at one end of a spring
        // and the other differ by no more.
        CHECK(length(momentum(sheet.velocities()) - before) <
              steps * Method::passes * masses_of(model) * m * 5.0 * 2.0 * epsilon<Real>);
        CHECK(distance(sheet.velocities(), v) > 0.1);  // momentum did pass between masses
    });
}

TEMPLATE_LIST_TEST_CASE("Springs pull both their ends equally", "[physics]", Precisions) {
    for_each_sheet([](const Grid& grid, Springs springs) {
        springs.mass = 1.0;  // kg: accelerations are forces
        const Model model(grid, springs, Attach::none);
        const auto x = scattered(grid, 0.04), v = noise(masses_of(model), 1.0);
        Sheet<TestType, SemiImplicitEuler> sheet(model, x, v);
        Rows<TestType> rows(model, sheet.checkpoint().fields);
        kernels_for<Vector<TestType>, SemiImplicitEuler>(model).evaluate(rows.whole());
        glm::dvec3 sum(0.0);
        for (const auto& f : points_of(rows.out)) sum += f;
        std::vector<double> sizes;
        Reference(model).forces(x, v, &sizes);
        double met = 0.0;
        for (const double size : sizes) met += size;
        // The same number is added at one end and taken at the other; only sums of up to eight terms are rounded, by
        // half an eps of at most all that met there each.
        CHECK(length(sum) < 4.0 * epsilon<TestType> * met);
    });
}

TEMPLATE_LIST_TEST_CASE("Methods that kick at x and then move keep the angular momentum, dampers or not", "[physics]",
                        AllCases) {
    // x' x v' = (x + dt v') x v' = x x (v + dt a), and the torque of central forces at x is zero. Damping that acted on
    // the whole relative velocity would brake the rotation: it loses a quarter in a second.
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    if constexpr (Method::staggered)
        for_each_sheet([](const Grid& grid, const Springs& springs) {
            const Model model(grid, springs, Attach::none);
            const glm::dvec3 spin{0.3, -0.2, 2.0};
            const auto x = scattered(grid, 0.02);
            auto v = noise(masses_of(model), 0.3);
            for (std::size_t n = 0; n < v.size(); ++n) v[n] += cross(spin, x[n]);
            Sheet<Real, Method> sheet(model, x, v);
            const auto before = angular_momentum(x, v);
            sheet.advance(tame_step<Method>(model), steps);
            const auto after = angular_momentum(sheet.positions(), sheet.stored_velocities());
            // The velocity at the position's time gives the same, for a kick has no torque.
            const auto synchronised = angular_momentum(sheet.positions(), sheet.velocities());
            const double reach = length(grid.rest(grid.columns, grid.rows)), fastest = 1.0 + length(spin) * reach;
            // Each step rounds x and v, at most `reach` and `fastest`, a few times by eps/2.
            const double rounding = steps * masses_of(model) * m * reach * fastest * 4.0 * epsilon<Real>;
            CHECK(length(after - before) < rounding);
            CHECK(length(synchronised - before) < rounding);
            CHECK(length(before) > 0.0);
        });
}

TEST_CASE("Other methods lose angular momentum with their order", "[physics]") {
    // Forward Euler and implicit Euler see forces at one end of a step, velocities at the other: x' x v' changes by
    // dt^2 v x a a step. XPBD moves along springs as they are on the way.
    for (const auto damping : {std::optional<double>(), std::optional(c)}) {
        const Model model({5, 4, 0.1, 0.08}, {m, k, kd, damping}, Attach::none);
        const auto x = scattered(model.grid, 0.02);
        auto v = noise(20, 0.3);
        for (std::size_t n = 0; n < v.size(); ++n) v[n] += cross({0.3, -0.2, 2.0}, x[n]);
        const auto before = angular_momentum(x, v);
        const auto lost = [&]<class Method>(Method, double dt, int count) {
            Sheet<double, Method> sheet(model, x, v);
            sheet.advance(dt, count);
            return length(angular_momentum(sheet.positions(), sheet.velocities()) - before);
        };
        const auto order = [&](auto method, double dt, int count) {
            return std::log2(lost(method, dt, count) / lost(method, 0.5 * dt, 2 * count));
        };
        INFO("damped " << damping.has_value());
        CHECK(order(ForwardEuler{}, 2e-5, 2000) == Approx(1.0).margin(0.1));
        CHECK(order(ImplicitEuler{}, 4e-5, 500) == Approx(1.0).margin(0.1));
        CHECK(order(Xpbd{}, 4e-5, 500) == Approx(1.0).margin(0.1));
        CHECK(order(Rk4{}, 1e-3, 40) > 3.9);
        CHECK(lost(ImplicitEuler{}, 1e-3, 300) > 1e-3 * length(before));  // where leapfrog keeps it to rounding
    }
}

TEST_CASE("A damper leaves a rigid rotation alone", "[physics]") {
    for_each_sheet([](const Grid& grid, Springs springs) {
        if (!springs.damping) return;
        springs.mass = 1.0;  // kg: accelerations are forces
        Springs undamped = springs;
        undamped.damping.reset();
        auto v = scattered(grid, 0.02);
        for (auto& p : v) p = cross({0.3, -0.2, 2.0}, p);
        const auto forces = [&](const Springs& of) {
            const Model model(grid, of, Attach::none);
            Sheet<double, SemiImplicitEuler> sheet(model, scattered(grid, 0.02), v);
            Rows<double> rows(model, sheet.checkpoint().fields);
            kernels_for<Vector<double>, SemiImplicitEuler>(model).evaluate(rows.whole());
            return points_of(rows.out);
        };
        // (w x d) . d = 0 up to the rounding of three products of up to |w| l^2, times c/l.
        CHECK(distance(forces(springs), forces(undamped)) < 8 * 20 * (k + c * 2.1) * 4.0 * epsilon<double>);
    });
}

TEMPLATE_LIST_TEST_CASE("Wind is gravity: drag in wind w is still air under g + d w/m", "[physics]", AllCases) {
    // Light borders too: their drag is as light as their mass.
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    const double drag = 0.02;
    for (const Borders borders : {Borders::alike, Borders::light})
        for_each_sheet([&](const Grid& grid, const Springs& springs) {
            const Gravity gravity{{0.0, -9.81, 0.0}};
            // A step that looks at the wind more than once has no one gravity that stands for gusts.
            Wind wind{{3.0, 1.0, -2.0}, glm::dvec3(0.0), 0.05, false, 5};
            if (Method::passes == 1) wind.gusts = {1.0, 0.5, 2.0};
            const Model windy(grid, springs, Attach::grommets, Terms().add(gravity).add(AirDrag{drag}).add(wind), {},
                              borders);
            Model still(grid, springs, Attach::grommets, Terms().add(gravity).add(AirDrag{drag}), {}, borders);
            const auto x = scattered(grid, 0.02), v = noise(masses_of(windy), 0.3);
            Sheet<Real, Method> a(windy, x, v), b(still, x, v);
            const double dt = tame_step<Method>(windy);
            for (int n = 0; n < steps; ++n) {
                still.terms.add(Gravity{gravity.acceleration + drag / m * wind.at((n + Method::stage_time[0]) * dt)});
                b.stepper.refill(still);
                a.advance(dt, 1), b.advance(dt, 1);
            }
            // The two sums may differ in the last bit of an acceleration below 30 m/s2, and from then on positions do
            // in theirs.
            const double size = 30.0 * dt * dt + length(grid.rest(grid.columns, grid.rows));
            CHECK(distance(a.positions(), b.positions()) <= rounding<Real>(size));
        });
}

TEMPLATE_LIST_TEST_CASE("A free sheet moves the same from a moving place", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    for_each_sheet([](const Grid& grid, const Springs& springs) {
        const Model model(grid, springs, Attach::none);
        const glm::dvec3 along{0.7, -0.4, 0.2};
        const auto x = scattered(grid, 0.02), v = noise(masses_of(model), 0.3);
        Sheet<Real, Method> at_rest(model, x, v),
            moving(model, x, changed(v, [&](const glm::dvec3&p) { return p + along; }));
        const double dt = tame_step<Method>(model);
        at_rest.advance(dt, steps), moving.advance(dt, steps);
        const auto expected = changed(at_rest.positions(), [&](const glm::dvec3& p) { return p + steps * dt * along; });
        const double size = length(grid.rest(grid.columns, grid.rows)) + steps * dt;
        CHECK(distance(moving.positions(), expected) < rounding<Real>(size));
    });
}

TEMPLATE_LIST_TEST_CASE("No direction is special: everything turned moves turned", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    // A third of a turn and a bit about (1, 2, 3)
    const glm::dvec3 axis = glm::dvec3{1.0, 2.0, 3.0} / std::sqrt(14.0);
    const auto turned = [&](const glm::dvec3& p) {
        return std::cos(2.2) * p + std::sin(2.2) * cross(axis, p) + (1.0 - std::cos(2.2)) * dot(axis, p) * axis;
    };
    for_each_sheet([&](const Grid& grid, const Springs& springs) {
        const Model model(grid, springs, Attach::grommets, blown(identity)),
            other(grid, springs, Attach::grommets, blown(turned));
        const auto x = scattered(grid, 0.02), v = noise(masses_of(model), 0.3);
        Sheet<Real, Method> a(model, x, v), b(other, changed(x, turned), changed(v, turned));
        const double dt = tame_step<Method>(model);
        a.advance(dt, steps), b.advance(dt, steps);
        const double size = length(grid.rest(grid.columns, grid.rows));
        CHECK(distance(b.positions(), changed(a.positions(), turned)) < rounding<Real>(size));
        CHECK(distance(a.positions(), x) > 1e-4);
    });
}

TEMPLATE_LIST_TEST_CASE("Front and back are the same, bit for bit", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    const auto mirrored = [](const glm::dvec3& p) { return glm::dvec3{p.x, p.y, -p.z}; };
    for_each_sheet([&](const Grid& grid, const Springs& springs) {
        const Model model(grid, springs, Attach::hoist, blown(identity)),
            other(grid, springs, Attach::hoist, blown(mirrored));
        const auto x = scattered(grid, 0.02), v = noise(masses_of(model), 0.3);
        Sheet<Real, Method> a(model, x, v), b(other, changed(x, mirrored), changed(v, mirrored));
        const double dt = tame_step<Method>(model);
        a.advance(dt, steps), b.advance(dt, steps);
        // A sign changes no rounding: squares, sums and differences of z only change sign or nothing.
        CHECK(distance(b.positions(), changed(a.positions(), mirrored)) == 0.0);
    });
}

TEMPLATE_LIST_TEST_CASE("Top and bottom, hoist and fly are the same, mirrored", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    if (std::is_same_v<Method, Xpbd>) return;  // springs that are corrected first give way more
    for (const bool upside_down : {true, false})
        for_each_sheet([&](const Grid& grid, const Springs& springs) {
            const int columns = grid.columns, rows = grid.rows;
            const glm::dvec3 corner = grid.rest(columns - 1, rows - 1);
            // The mirror of a place, and of which mass stands there; y or x turns about the middle of the flag.
            const auto flipped = [&](const glm::dvec3& p) {
                return upside_down ? glm::dvec3{p.x, corner.y - p.y, p.z} : glm::dvec3{corner.x - p.x, p.y, p.z};
            };
            const auto flipped_direction = [&](const glm::dvec3& p) {
                return upside_down ? glm::dvec3{p.x, -p.y, p.z} : glm::dvec3{-p.x, p.y, p.z};
            };
            const auto reordered = [&](const Points& from) {
                Points to = from;
                for (int j = 0; j < rows; ++j)
                    for (int i = 0; i < columns; ++i)
                        to[j * columns + i] =
                            upside_down ? from[(rows - 1 - j) * columns + i] : from[j * columns + columns - 1 - i];
                return to;
            };
            const Attach attach = upside_down ? Attach::hoist : Attach::top;  // the mirror maps these onto themselves
            const Model model(grid, springs, attach, blown(identity)),
                other(grid, springs, attach, blown(flipped_direction));
            const auto x = scattered(grid, 0.02), v = noise(masses_of(model), 0.3);
            Sheet<Real, Method> a(model, x, v),
                b(other, reordered(changed(x, flipped)), reordered(changed(v, flipped_direction)));
            const double dt = tame_step<Method>(model);
            a.advance(dt, steps), b.advance(dt, steps);
            CHECK(distance(b.positions(), reordered(changed(a.positions(), flipped))) < rounding<Real>(length(corner)));
        });
}
