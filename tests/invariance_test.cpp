// Invariance: what physics says cannot matter, and what it says is kept.
#include "catch.hpp"
#include "physics_reference.hpp"
#include "physics_sheet.hpp"

using namespace drapeau;
using namespace drapeau::testing;

namespace {

constexpr double m = 0.01, k = 200.0, kd = 100.0, c = 0.05;

/// Every awkward size, with and without diagonals and damping, unattached and without any force but the springs'.
template <class Visit>
void for_each_sheet(Visit&& visit) {
    for (const auto& [columns, rows] : awkward_sizes)
        for (const auto& material : all_materials(m, k, kd, c))
            visit(Setting{.grid = {columns, rows, 0.1, 0.08}, .material = material});
}

/// A step at which a hundred steps of forward Euler too stay tame (it lets an undamped mode grow by
/// sqrt(1 + (omega dt)^2) a step: 1.005 at a twentieth of the limit).
template <class Method>
double tame_step(const Setting& s) {
    const double limit = largest_step(SemiImplicitEuler{}, s.rates());
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

template <class Change>
Points changed(Points points, Change&& change) {
    for (auto& p : points) p = change(p);
    return points;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("Springs pull both their ends equally", "[physics]", Precisions) {
    for_each_sheet([](const Setting& s) {
        const auto x = scattered(s.grid, 0.04), v = noise(s.masses(), 1.0);
        Sheet<TestType, SemiImplicitEuler> sheet(s, x, v);
        glm::dvec3 sum(0.0);
        for (const auto& f : sheet.forces()) sum += f;
        std::vector<double> sizes;
        Reference(s).forces(x, v, &sizes);
        double met = 0.0;
        for (const double size : sizes) met += size;
        // The same number is added at one end and taken at the other; only sums of up to eight terms are rounded, by
        // half an eps of at most all that met there each.
        CHECK(length(sum) < 4.0 * epsilon<TestType> * met);
    });
}

TEMPLATE_LIST_TEST_CASE("Springs and their dampers keep the momentum of a free sheet", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    for_each_sheet([](const Setting& s) {
        const auto v = noise(s.masses(), 1.0);
        Sheet<Real, typename TestType::Method> sheet(s, scattered(s.grid, 0.02), v);
        const auto before = momentum(sheet.velocities());
        sheet.advance(tame_step<typename TestType::Method>(s), steps);
        // Each step rounds every velocity, up to 5 m/s, by a few halves of eps.
        CHECK(length(momentum(sheet.velocities()) - before) < steps * s.masses() * m * 5.0 * 2.0 * epsilon<Real>);
        CHECK(distance(sheet.velocities(), v) > 0.1);  // momentum did pass between masses
    });
}

TEMPLATE_LIST_TEST_CASE("Semi-implicit Euler keeps the angular momentum, dampers or not", "[physics]", Precisions) {
    // x' x v' = (x + dt v') x v' = x x (v + dt a), and the torque of central forces at x is zero. Damping that acted on
    // the whole relative velocity would brake the rotation: it loses a quarter in a second.
    for_each_sheet([](const Setting& s) {
        const glm::dvec3 spin{0.3, -0.2, 2.0};
        const auto x = scattered(s.grid, 0.02);
        auto v = noise(s.masses(), 0.3);
        for (std::size_t n = 0; n < v.size(); ++n) v[n] += cross(spin, x[n]);
        Sheet<TestType, SemiImplicitEuler> sheet(s, x, v);
        const auto before = angular_momentum(sheet.positions(), sheet.velocities());
        sheet.advance(tame_step<SemiImplicitEuler>(s), steps);
        const auto after = angular_momentum(sheet.positions(), sheet.velocities());
        const double reach = length(s.grid.rest(s.grid.columns, s.grid.rows)), fastest = 1.0 + length(spin) * reach;
        // Each step rounds x and v, at most `reach` and `fastest`, a few times by eps/2.
        CHECK(length(after - before) < steps * s.masses() * m * reach * fastest * 4.0 * epsilon<TestType>);
        CHECK(length(before) > 0.0);
    });
}

TEST_CASE("A damper leaves a rigid rotation alone", "[physics]") {
    for_each_sheet([](const Setting& s) {
        if (!s.material.damping) return;
        Setting undamped = s;
        undamped.material.damping.reset();
        const auto x = scattered(s.grid, 0.02);
        auto v = x;
        for (auto& p : v) p = cross({0.3, -0.2, 2.0}, p);
        Sheet<double, SemiImplicitEuler> with(s, x, v), without(undamped, x, v);
        // (w x d) . d = 0 up to the rounding of three products of up to |w| l^2, times c/l.
        CHECK(distance(with.forces(), without.forces()) < 8 * 20 * (k + c * 2.1) * 4.0 * epsilon<double>);
    });
}

TEMPLATE_LIST_TEST_CASE("Wind is gravity: drag in wind w is still air under g + d w/m", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    for_each_sheet([](Setting windy) {
        windy.attach = Attach::grommets;
        windy.gravity = {0.0, -9.81, 0.0};
        windy.drag = 0.02;
        windy.wind = {{3.0, 1.0, -2.0}, {1.0, 0.5, 2.0}, 0.05, 5};
        Setting still = windy;
        still.wind = {};
        const auto x = scattered(windy.grid, 0.02), v = noise(windy.masses(), 0.3);
        Sheet<Real, typename TestType::Method> a(windy, x, v), b(still, x, v);
        const double dt = tame_step<typename TestType::Method>(windy);
        for (int n = 0; n < steps; ++n) {
            b.setting.gravity = windy.gravity + windy.drag / m * windy.wind.velocity(n * dt);
            a.advance(dt, 1), b.advance(dt, 1);
        }
        // The two sums may differ in the last bit of an acceleration below 30 m/s2: steps^2/2 dt^2 * 30 eps.
        CHECK(distance(a.positions(), b.positions()) <= rounding<Real>(30.0 * dt * dt) + rounding<Real>(1e-2));
    });
}

TEMPLATE_LIST_TEST_CASE("A free sheet moves the same from a moving place", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    for_each_sheet([](const Setting& s) {
        const glm::dvec3 along{0.7, -0.4, 0.2};
        const auto x = scattered(s.grid, 0.02), v = noise(s.masses(), 0.3);
        Sheet<Real, typename TestType::Method> at_rest(s, x, v),
            moving(s, x, changed(v, [&](const glm::dvec3&p) { return p + along; }));
        const double dt = tame_step<typename TestType::Method>(s);
        at_rest.advance(dt, steps), moving.advance(dt, steps);
        const auto expected = changed(at_rest.positions(), [&](const glm::dvec3& p) { return p + steps * dt * along; });
        const double size = length(s.grid.rest(s.grid.columns, s.grid.rows)) + steps * dt;
        CHECK(distance(moving.positions(), expected) < rounding<Real>(size));
    });
}

TEMPLATE_LIST_TEST_CASE("No direction is special: everything turned moves turned", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    // A third of a turn and a bit about (1, 2, 3)
    const glm::dvec3 axis = glm::dvec3{1.0, 2.0, 3.0} / std::sqrt(14.0);
    const auto turned = [&](const glm::dvec3& p) {
        return std::cos(2.2) * p + std::sin(2.2) * cross(axis, p) + (1.0 - std::cos(2.2)) * dot(axis, p) * axis;
    };
    for_each_sheet([&](Setting s) {
        s.attach = Attach::grommets;
        s.gravity = {0.0, -9.81, 0.0};
        s.drag = 0.02, s.friction = 0.01;
        s.wind.mean = {3.0, 1.0, -2.0};
        Setting other = s;
        other.gravity = turned(s.gravity);
        other.wind.mean = turned(s.wind.mean);
        const auto x = scattered(s.grid, 0.02), v = noise(s.masses(), 0.3);
        Sheet<Real, typename TestType::Method> a(s, x, v), b(other, changed(x, turned), changed(v, turned));
        const double dt = tame_step<typename TestType::Method>(s);
        a.advance(dt, steps), b.advance(dt, steps);
        const double size = length(s.grid.rest(s.grid.columns, s.grid.rows));
        CHECK(distance(b.positions(), changed(a.positions(), turned)) < rounding<Real>(size));
        CHECK(distance(a.positions(), x) > 1e-4);
    });
}

TEMPLATE_LIST_TEST_CASE("Front and back are the same, bit for bit", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    const auto mirrored = [](const glm::dvec3& p) { return glm::dvec3{p.x, p.y, -p.z}; };
    for_each_sheet([&](Setting s) {
        s.attach = Attach::hoist;
        s.gravity = {0.0, -9.81, 0.5};
        s.drag = 0.02;
        s.wind.mean = {3.0, 1.0, -2.0};
        Setting other = s;
        other.gravity = mirrored(s.gravity);
        other.wind.mean = mirrored(s.wind.mean);
        const auto x = scattered(s.grid, 0.02), v = noise(s.masses(), 0.3);
        Sheet<Real, typename TestType::Method> a(s, x, v), b(other, changed(x, mirrored), changed(v, mirrored));
        const double dt = tame_step<typename TestType::Method>(s);
        a.advance(dt, steps), b.advance(dt, steps);
        // A sign changes no rounding: squares, sums and differences of z only change sign or nothing.
        CHECK(distance(b.positions(), changed(a.positions(), mirrored)) == 0.0);
    });
}

TEMPLATE_LIST_TEST_CASE("Top and bottom, hoist and fly are the same, mirrored", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    for (const bool upside_down : {true, false})
        for_each_sheet([&](Setting s) {
            const int columns = s.grid.columns, rows = s.grid.rows;
            const glm::dvec3 corner = s.grid.rest(columns - 1, rows - 1);
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
            s.attach = upside_down ? Attach::hoist : Attach::top;  // the mirror maps these onto themselves
            s.gravity = {1.0, -9.81, 0.5};
            s.drag = 0.02;
            Setting other = s;
            other.gravity = flipped_direction(s.gravity);
            const auto x = scattered(s.grid, 0.02), v = noise(s.masses(), 0.3);
            Sheet<Real, typename TestType::Method> a(s, x, v),
                b(other, reordered(changed(x, flipped)), reordered(changed(v, flipped_direction)));
            const double dt = tame_step<typename TestType::Method>(s);
            a.advance(dt, steps), b.advance(dt, steps);
            CHECK(distance(b.positions(), reordered(changed(a.positions(), flipped))) < rounding<Real>(length(corner)));
        });
}
