// Contacts: ground and pole keep masses out without a bounce, brake them by Coulomb's law, and let lie still what lies
// still, to the bit. And what holds the flag, hauled.
#include "catch.hpp"
#include "physics_sheet.hpp"

using namespace drapeau;
using namespace drapeau::testing;

namespace {

constexpr double g = 9.8;
constexpr double radians = M_PI / 180.0;

/// Two masses on a slack spring that nothing holds, on ground at the origin's height, gravity leaning by `angle` (rad)
/// towards x: a slope.
Model slope(double angle, double friction) {
    return Model({2, 1, 0.1, 0.1}, {.mass = 0.01, .stiffness = 1e-6, .diagonal_stiffness = {}, .damping = {}},
                 Attach::none, Terms().add(Gravity{{g * std::sin(angle), -g * std::cos(angle), 0.0}}),
                 Limits().add(Ground{0.0, friction}));
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("On a slope cloth slides as Coulomb says, or rests to the bit", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    constexpr double dt = 1e-3, friction = 0.5;
    constexpr int steps = 200;
    const double critical = std::atan(friction);
    for (const double angle : {20.0 * radians, critical - 1e-3, critical + 1e-3, 40.0 * radians}) {
        CAPTURE(angle);
        const Model model = slope(angle, friction);
        Sheet<Real, Method> sheet(model, {{0, 0, 0}, {0.1, 0, 0}}, Points(2, glm::dvec3(0.0)));
        sheet.advance(dt, 3);
        const auto begin = sheet.positions();
        const auto from = sheet.velocities();
        sheet.advance(dt, steps);
        const double pull = g * (std::sin(angle) - friction * std::cos(angle));
        const double gained = sheet.velocities()[0].x - from[0].x;
        if (pull < 0.0) {
            CHECK(distance(sheet.positions(), begin) == 0.0);
        } else {
            // Every step rounds a velocity of at most 1 m/s, in some methods four times.
            CHECK(std::abs(gained - steps * dt * pull) <= 4 * steps * epsilon<Real>);
            CHECK(sheet.positions()[0].x > begin[0].x);
        }
        for (const auto& x : sheet.positions()) CHECK(std::abs(x.y) <= epsilon<Real>);
    }
}

TEMPLATE_LIST_TEST_CASE("Cloth that is thrown along the ground is braked and stops where Coulomb says", "[physics]",
                        AllCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    constexpr double dt = 1e-3, friction = 0.3, speed = 1.0;
    const Model model = slope(0.0, friction);
    Sheet<Real, Method> sheet(model, {{0, 0, 0}, {0.1, 0, 0}}, Points(2, {0.6 * speed, 0.0, 0.8 * speed}));
    const double seconds = speed / (friction * g), way = 0.5 * speed * seconds;
    sheet.advance(dt, std::lround(0.5 * seconds / dt));
    // A step before friction is felt, a step of it early or late.
    CHECK(std::abs(length(sheet.velocities()[0]) - 0.5 * speed) <= 2 * dt * friction * g);
    sheet.advance(dt, std::lround(0.6 * seconds / dt));
    const auto still = sheet.positions();
    sheet.advance(dt, 100);
    CHECK(distance(sheet.positions(), still) == 0.0);
    CHECK(std::abs(length(still[0]) - way) <= 2 * dt * speed);
    CHECK(still[0].z * 0.6 == Approx(still[0].x * 0.8).epsilon(1e-3));
}

TEMPLATE_LIST_TEST_CASE("What falls on the ground stays there, without a bounce", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    constexpr double dt = 1e-3, height = 0.5;
    const Model model = slope(0.0, 0.0);
    Sheet<Real, Method> sheet(model, {{0, height, 0}, {0.1, height, 0}}, Points(2, glm::dvec3(0.0)));
    const double seconds = std::sqrt(2.0 * height / g);
    sheet.advance(dt, std::lround((seconds - 0.01) / dt));
    CHECK(sheet.positions()[0].y > 0.0);
    double lowest = 1.0, highest = 0.0;
    sheet.advance(dt, 20);
    for (int n = 0; n < 100; ++n) {
        sheet.advance(dt, 1);
        lowest = std::min(lowest, sheet.positions()[0].y), highest = std::max(highest, sheet.positions()[0].y);
    }
    CHECK(std::abs(lowest) <= epsilon<Real>);
    CHECK(std::abs(highest) <= epsilon<Real>);
}

TEMPLATE_LIST_TEST_CASE("What is below ground comes out of it slowly, and not with that speed", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    constexpr double dt = 1e-3, depth = 0.05;
    const Model model = slope(0.0, 0.5);
    Sheet<Real, typename TestType::Method> sheet(model, {{0, -depth, 0}, {0.1, -depth, 0}}, Points(2, glm::dvec3(0.0)));
    sheet.advance(dt, 50);  // forward Euler takes a step to begin
    CHECK(std::abs(sheet.positions()[0].y + depth - 50 * dt * 0.5) <= 1.001 * dt * 0.5 + 50 * epsilon<Real>);
    sheet.advance(dt, 52);
    CHECK(std::abs(sheet.positions()[0].y) <= epsilon<Real>);
    CHECK(sheet.velocities()[0].y <= g * dt);
}

TEMPLATE_LIST_TEST_CASE("A crumpled sheet falls, lies down and lies still", "[physics]", FloatCases) {
    using Method = typename TestType::Method;
    if (Method::solves && Method::order == 1 && Method::passes > 2) return;  // minutes
    const Model model({9, 7, 0.1, 0.1}, {0.001, 40.0, 20.0, 0.01}, Attach::none,
                      Terms().add(Gravity{{0, -g, 0}}).add(AirDrag{0.002}), Limits().add(Ground{-0.8, 0.5}));
    const auto start = crumpled_start(model, 0.0, 3);
    Sheet<float, Method> sheet(model);
    sheet.stepper.set(start);
    const double dt =
        (std::is_same_v<Method, ForwardEuler> ? 0.05 : 0.3) * stable_step(SemiImplicitEuler{}, model).seconds();
    sheet.advance(dt, std::lround(8.0 / dt));
    const auto still = sheet.positions();
    sheet.advance(dt, std::lround(1.0 / dt));
    CHECK(distance(sheet.positions(), still) < 2e-5);  // folds that stand on it may still breathe
    for (const auto& x : still) CHECK(x.y >= -0.8 - epsilon<float>);
    // Methods that synchronise velocities do so by half a kick of gravity, which the ground takes back.
    CHECK(sheet.measure().kinetic_now <= 0.5 * model.total_mass() * (g * dt) * (g * dt));
}

TEST_CASE("A rope over a pole holds what Euler and Eytelwein say", "[physics]") {
    // Its arms hang towards +x, on either side of the pole.
    constexpr double radius = 0.1, friction = 0.3, pitch = 0.02;
    const Pole pole{radius, friction};
    const Grid whole{60, 1, pitch, pitch};
    const double reach = pole.reach(whole), turn = 2.0 * std::asin(0.5 * pitch / reach);  // of each mass
    const int on_arc = static_cast<int>(M_PI / turn) + 1;
    const double m = 0.01;
    // The tension of the longer arm that friction just holds: from the shorter one mass by mass over the arc, each
    // turning the rope by `turn` and pulled by its own weight.
    const auto held = [&](int shorter) {
        double tension = shorter * m * g;
        for (int n = 0; n < on_arc; ++n) {
            const double place = M_PI + (0.5 * (on_arc - 1) - n) * turn, half = 0.5 * turn;  // rad, from +x
            // On the point of sliding, (next - tension) cos(half) + along = mu [(next + tension) sin(half) + pressed].
            const double along = m * g * std::sin(place), pressed = -m * g * std::cos(place);
            tension = (tension * (std::cos(half) + friction * std::sin(half)) - along + friction * pressed) /
                      (std::cos(half) - friction * std::sin(half));
        }
        return tension / (m * g);
    };
    const auto slides = [&](int shorter, int longer) {
        const Grid grid{shorter + on_arc + longer, 1, pitch, pitch};
        const Model model(grid, {m, 2e4, {}, 10.0}, Attach::none, Terms().add(Gravity{{g, 0, 0}}).add(AirDrag{0.1}),
                          Limits().add(pole));
        Points x;
        for (int n = 0; n < grid.columns; ++n) {
            const double along = n - shorter - 0.5 * (on_arc - 1);
            const double half = 0.5 * (on_arc - 1);
            if (std::abs(along) <= half) {
                const double angle = M_PI - along * turn;
                x.push_back({reach * std::cos(angle) - radius, 0.0, reach * std::sin(angle)});
            } else {
                const double side = along < 0.0 ? -1.0 : 1.0, out = std::abs(along) - half;
                const double angle = M_PI - side * half * turn;
                x.push_back({reach * std::cos(angle) - radius + out * pitch, 0.0, reach * std::sin(angle)});
            }
        }
        Sheet<double, SemiImplicitEuler> sheet(model, x, Points(x.size(), glm::dvec3(0.0)));
        const double dt = 0.5 * stable_step(SemiImplicitEuler{}, model).seconds();
        sheet.advance(dt, std::lround(0.8 / dt));
        return sheet.velocities().back().x > 0.02;
    };
    // Loaded at once it slips a little before it holds or goes on.
    const double most = held(8);
    CHECK_FALSE(slides(8, static_cast<int>(0.9 * most)));
    CHECK(slides(8, static_cast<int>(1.05 * most) + 1));
    CHECK(most > 8 * std::exp(friction * M_PI));  // the arc has weight, too
}

TEMPLATE_LIST_TEST_CASE("What contacts take from the energy is counted", "[physics]", DoubleCases) {
    // A net falls on the ground and against the pole.
    using Method = typename TestType::Method;
    if constexpr (Method::passes == 1) {
        const Model model({6, 5, 0.1, 0.1}, {0.01, 200.0, 100.0, {}}, Attach::none, Terms().add(Gravity{{-2.0, -g, 0}}),
                          Limits().add(Ground{-0.42, 0.5}).add(Pole{0.02, 0.5}));
        auto x = scattered(model.grid, 0.003);
        for (auto& p : x) p.x += 0.04;
        Sheet<double, Method> sheet(model, x, noise(30, 0.3));
        const double dt = 0.05 * stable_step(SemiImplicitEuler{}, model).seconds();
        double took = 0.0, most_left = 0.0, most_taken = 0.0;
        for (int n = 0; n < 400; ++n) {
            const double before = sheet.measure().balance();
            const Work work = sheet.accounted_step(dt).work;
            took += work.passes;
            most_taken = std::max(most_taken, std::abs(work.passes));
            most_left = std::max(most_left, std::abs(sheet.measure().balance() - before - work.all()));
        }
        // Of some tenths of a joule that it has and gains by falling. What is left is the methods' own.
        CHECK(took < -1e-3);
        CHECK(took > -0.5);
        CHECK(most_left < 0.1 * most_taken);
    }
}

TEMPLATE_LIST_TEST_CASE("What is hauled moves as it is told, and what hauls does the work", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    const Model model({7, 5, 0.1, 0.1}, {0.01, 200.0, 100.0, 0.05}, Attach::hoist, Terms().add(Gravity{{0, -g, 0}}));
    Sheet<Real, Method> sheet(model);
    const double dt = 0.02 * stable_step(SemiImplicitEuler{}, model).seconds();
    const double speed = -0.5;
    sheet.advance(dt, 100);
    sheet.stepper.haul(sheet.time(), {0.0, speed, 0.0});
    const auto begin = sheet.positions();
    const long long steps = 200;
    double before = sheet.measure().balance(), worked = 0.0;
    const double first = before;
    for (long long n = 0; n < steps; ++n) worked += sheet.accounted_step(dt).work.all();
    for (int j = 0; j < 5; ++j) {
        const auto way = sheet.positions()[7 * j] - begin[7 * j];
        CHECK(std::abs(way.y - steps * dt * speed) <= steps * epsilon<Real>);
        CHECK(way.x == 0.0);
    }
    const double gained = sheet.measure().balance() - first;
    CAPTURE(worked, gained);
    CHECK(std::abs(gained - worked) < 0.02 * std::abs(worked) + 200 * steps * epsilon<Real>);
    sheet.stepper.haul(sheet.time(), glm::dvec3(0.0));
    const auto there = sheet.positions();
    sheet.advance(dt, 100);
    for (int j = 0; j < 5; ++j) CHECK(length(sheet.positions()[7 * j] - there[7 * j]) == 0.0);
}
