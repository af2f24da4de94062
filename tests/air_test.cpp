// Air on faces: its forces in closed form, what cannot matter, and how it moves and brakes a sheet.
#include "catch.hpp"
#include "physics_reference.hpp"
#include "physics_sheet.hpp"

#include "drapeau/fastest_mode.hpp"

#include <glm/trigonometric.hpp>

using namespace drapeau;
using namespace drapeau::testing;

namespace {

constexpr double rho = 1.2, c_d = 1.3, c_f = 0.07;  // kg/m3
constexpr Air both{.density = rho, .pressure = c_d, .skin = c_f};
constexpr double m = 0.01;  // kg
const Grid grid{6, 5, 0.1, 0.08};
constexpr double area = 0.5 * 0.32;  // m2, of the whole sheet
// As good as none: forces of a millionth of a newton at most, and none in a flat sheet.
const Springs slack{m, 1e-6, 1e-6, {}};

/// A sheet whose masses are shared as its area is, so that the air moves all of it alike.
Model even_sheet(const Terms& terms) {
    return Model(grid, slack, Attach::none, terms, {}, Borders::light);
}
constexpr double whole_mass = m * 5 * 4;  // kg, of the even sheet

/// A flat sheet that spans two directions.
Points flat(const glm::dvec3& fly, const glm::dvec3& up) {
    Points x;
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) x.push_back(i * grid.pitch_x * fly - j * grid.pitch_y * up);
    return x;
}
const Points lying = flat({1, 0, 0}, {0, 0, -1}), standing = flat({1, 0, 0}, {0, 1, 0});

Points all_at(const glm::dvec3& v) {
    return Points(static_cast<std::size_t>(grid.masses()), v);
}

/// The acceleration of every mass of a state.
template <class Real, class Method = SemiImplicitEuler>
Points pushed(const Model& model, const Points& x, const Points& v) {
    Sheet<Real, Method> sheet(model, x, v);
    FieldBuffer<Real> a(model.grid.columns, model.grid.rows);
    sheet.stepper.evaluate(0.0, a);
    return points_of(a);
}

/// Turns by `angle` (rad) about an axis of length 1.
glm::dvec3 turned(const glm::dvec3& p, const glm::dvec3& axis, double angle) {
    return std::cos(angle) * p + std::sin(angle) * cross(axis, p) + (1.0 - std::cos(angle)) * dot(axis, p) * axis;
}

/// Differences of neighbours (0.08 m) in coordinates of up to `size` (m) are known to eps size each, so a normal is
/// known to four times that over their length, and forces are products of two of its components; a few roundings of
/// their own.
template <class Real>
double rounding(double size) {
    return (16.0 * size / 0.08 + 40.0) * epsilon<Real>;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("A plate at an angle feels sin2 of it across and cos2 along its face", "[physics]",
                        Precisions) {
    const double speed = 7.0;  // m/s
    for (const double degrees : {0.0, 1.0, 20.0, 45.0, 70.0, 90.0}) {
        const double angle = glm::radians(degrees);  // between the wind and the plate
        const glm::dvec3 along{std::cos(angle), 0.0, std::sin(angle)}, normal{-std::sin(angle), 0.0, std::cos(angle)};
        const Model model(grid, slack, Attach::none, Terms().add(both).add(Wind{.velocity = {speed, 0.0, 0.0}}));
        const auto a = pushed<TestType>(model, flat(along, {0, 1, 0}), all_at(glm::dvec3(0.0)));
        const glm::dvec3 of_area =
            0.5 * rho * speed * speed *
            (c_f * std::pow(std::cos(angle), 2) * along - c_d * std::pow(std::sin(angle), 2) * normal);
        glm::dvec3 sum(0.0);
        for (int n = 0; n < static_cast<int>(a.size()); ++n) {
            const int i = n % grid.columns, j = n / grid.columns;
            const double share = (i == 0 || i == 5 ? 0.5 : 1.0) * (j == 0 || j == 4 ? 0.5 : 1.0);
            INFO(degrees << " degrees, mass " << n);
            CHECK(length(m * a[n] - share * 0.1 * 0.08 * of_area) <
                  rounding<TestType>(0.6) * 0.1 * 0.08 * 0.5 * rho * c_d * speed * speed);
            sum += m * a[n];
        }
        CHECK(length(sum - area * of_area) < rounding<TestType>(0.6) * area * 0.5 * rho * c_d * speed * speed);
    }
}

TEMPLATE_LIST_TEST_CASE("In any shape and motion masses feel what the plain equations say", "[physics]", Precisions) {
    for (const auto& [columns, rows] : awkward_sizes)
        for (const Borders borders : {Borders::alike, Borders::light})
            for (const Air& air : {both, Air{.pressure = c_d, .skin = {}}, Air{.pressure = {}, .skin = c_f}}) {
                const Model model({columns, rows, 0.1, 0.08}, {m, 1e-6, {}, {}}, Attach::corner,
                                  Terms().add(air).add(Wind{{3.0, 0.5, 1.0}, {1.0, 0.5, 1.0}, 1.5, true, 3}), {},
                                  borders);
                const auto x = scattered(model.grid, 0.02), v = noise(masses_of(model), 2.0);
                const auto a = pushed<TestType>(model, x, v),
                           expected = Reference(model, borders).acceleration(x, v, 0.0);
                const double most = 0.5 * rho * (c_d + c_f) * 0.1 * 0.08 * 100.0 / m;  // at 10 m/s
                INFO(columns << " x " << rows);
                CHECK(distance(a, expected) < rounding<TestType>(columns * 0.1 + rows * 0.08) * most);
            }
}

TEMPLATE_LIST_TEST_CASE("The air pushes alike whichever way everything is turned or mirrored", "[physics]",
                        Precisions) {
    const auto x = scattered(grid, 0.02), v = noise(static_cast<int>(grid.masses()), 2.0);
    const glm::dvec3 wind{3.0, 1.0, -2.0}, axis = glm::dvec3{2.0, -1.0, 2.0} / 3.0;
    const auto in_wind = [](const glm::dvec3& w) {
        return Model(grid, slack, Attach::none, Terms().add(both).add(Wind{.velocity = w}));
    };
    const auto a = pushed<TestType>(in_wind(wind), x, v);
    const double most = 0.5 * rho * (c_d + c_f) * 0.1 * 0.08 * 60.0 / m;
    const auto check = [&](auto&& change, auto&& place) {
        Points x_there(x.size()), v_there(x.size()), expected(x.size());
        for (int n = 0; n < static_cast<int>(x.size()); ++n) {
            x_there[place(n)] = change(x[n]), v_there[place(n)] = change(v[n]), expected[place(n)] = change(a[n]);
        }
        CHECK(distance(pushed<TestType>(in_wind(change(wind)), x_there, v_there), expected) <
              2.0 * rounding<TestType>(0.8) * most);
    };
    const auto same = [](int n) { return n; };
    check([&](const glm::dvec3& p) { return turned(p, axis, 2.1); }, same);
    check([](const glm::dvec3& p) { return glm::dvec3{p.x, p.y, -p.z}; }, same);
    // Columns, and rows, counted from the other side.
    check([](const glm::dvec3& p) { return p; }, [](int n) { return n - n % 6 + 5 - n % 6; });
    check([](const glm::dvec3& p) { return p; }, [](int n) { return n % 6 + 6 * (4 - n / 6); });
}

TEMPLATE_LIST_TEST_CASE("A sheet falls broadside and edge-on at its terminal speeds", "[physics]", DoubleCases) {
    // Where rho/2 C A v^2 = m g, whatever the method: there no velocity changes. A deviation shrinks at the rate 2g/v.
    using Method = typename TestType::Method;
    const double g = 9.81;
    const Model model = even_sheet(Terms().add(Gravity{{0.0, -g, 0.0}}).add(both));
    for (const bool broadside : {true, false}) {
        const double terminal = std::sqrt(2.0 * whole_mass * g / (rho * (broadside ? c_d : c_f) * area));
        const double dt = 0.02 * terminal / g;
        Sheet<double, Method> sheet(model, broadside ? lying : standing, all_at(glm::dvec3(0.0)));
        sheet.advance(dt, 400);  // of the deviation (1 - 0.04)^400 = 1e-7 is left
        INFO((broadside ? "broadside" : "edge-on"));
        CHECK(distance(sheet.velocities(), all_at({0.0, -terminal, 0.0})) < 1e-6 * terminal);
    }
}

TEMPLATE_LIST_TEST_CASE("Broadside speed decays as 1/(1 + t/tau), with the method's order", "[physics]", DoubleCases) {
    // tau = 2 m / (rho C_d A v): after tau half the speed is left, and v tau ln 2 is how far it went.
    using Method = typename TestType::Method;
    const double speed = 3.0, tau = 2.0 * whole_mass / (rho * c_d * area * speed), end = tau;
    const Model model = even_sheet(Terms().add(both));
    std::vector<double> in_velocity, in_position;
    for (const int n : {20, 40, 80}) {
        Sheet<double, Method> sheet(model, lying, all_at({0.0, speed, 0.0}));
        sheet.advance(end / n, n);
        in_velocity.push_back(std::abs(sheet.velocities()[7].y - 0.5 * speed));
        in_position.push_back(std::abs(sheet.positions()[7].y - speed * tau * std::log(2.0)));
    }
    for (const auto& errors : {in_velocity, in_position}) {
        INFO("errors " << errors[0] << ", " << errors[1] << ", " << errors[2]);
        // The next term of the error is dt/tau of it, a twentieth in the coarsest run.
        CHECK(std::log2(errors[1] / errors[2]) == Approx(Method::order).margin(0.15));
    }
}

TEMPLATE_LIST_TEST_CASE("The work that is counted is what the air takes, its power for so long", "[physics]",
                        DoubleCases) {
    using Method = typename TestType::Method;
    const double speed = 3.0, wind = 1.0, u = wind - speed;  // m/s, upwards
    const Model model = even_sheet(Terms().add(both).add(Wind{.velocity = {0.0, wind, 0.0}}));
    Sheet<double, Method> sheet(model, lying, all_at({0.0, speed, 0.0}));
    const double dt = 1e-6, power = 0.5 * rho * c_d * area * std::abs(u) * u * speed;
    sheet.advance(dt, 0);
    const auto kinetic = [&] {
        const double v = sheet.velocities()[7].y;
        return 0.5 * whole_mass * v * v;
    };
    const double before = kinetic();
    const Work work = sheet.accounted_step(dt).work;
    // In a step the speed changes by the share dt power / (m v^2) = 6e-6 of itself.
    CHECK(work.external == Approx(power * dt).epsilon(4e-5));
    CHECK(work.damping == 0.0);
    // Of 0.9 J, rounded some thirty times; staggered velocities change by as much half a step later.
    CHECK(kinetic() - before == Approx(work.external).margin(30.0 * epsilon<double> * before).epsilon(4e-5));
    CHECK(model.most_power() >= 0.0);
}

TEST_CASE("No speed lets a wind bring in more power than is said", "[physics]") {
    // Of F v with u = w - v, greatest at v = w/3.
    const double w = 5.0;
    const Model model = even_sheet(Terms().add(both).add(Wind{.velocity = {0.0, w, 0.0}}));
    double most = 0.0;
    for (double v = 0.0; v < w; v += 0.01) most = std::max(most, 0.5 * rho * c_d * (w - v) * (w - v) * v);
    const double node = (c_d + c_f) / c_d * most * model.cell();  // as if both were at their greatest
    CHECK(model.most_power() == Approx(node * static_cast<double>(grid.masses())).epsilon(1e-4));
}

TEMPLATE_LIST_TEST_CASE("A method is stable up to the limit that it says for the air alone", "[physics]", DoubleCases) {
    // At the terminal speed a deviation decays at the rate rho C_d A v / m: linear, as long as it is small.
    using Method = typename TestType::Method;
    const double g = 9.81, terminal = std::sqrt(2.0 * whole_mass * g / (rho * c_d * area)), rate = 2.0 * g / terminal;
    const Model model = even_sheet(Terms().add(Gravity{{0.0, -g, 0.0}}).add(both));
    const double limit = Method::stable_step({1.0, 0.0, 0.0, 0.0, rate}).seconds();
    REQUIRE(std::isfinite(limit));
    for (const double share : {0.97, 1.03}) {
        const double deviation = 1e-7 * terminal;
        Sheet<double, Method> sheet(model, lying, all_at({0.0, -terminal + deviation, 0.0}));
        // Of rk4 0.97^4 and less is what remains of slowest decays; 400 steps multiply it by 1e-5 at least.
        sheet.advance(share * limit, 400);
        const double left = std::abs(sheet.stored_velocities()[7].y + terminal);
        INFO("at " << share << " of the limit");
        CHECK((left < 0.1 * deviation) == (share < 1.0));
    }
}

TEST_CASE("The closed bound and the live limit know how fast the air brakes", "[physics]") {
    const Springs springs{m, 300.0, 150.0, 0.02};
    const Terms windy = Terms().add(Gravity{{0.0, -9.81, 0.0}}).add(both).add(Wind{.velocity = {0.0, 0.0, 12.0}});
    const Model model(grid, springs, Attach::none, windy);
    Terms airless = windy;
    airless.get<Air>().reset();
    const Model still(grid, springs, Attach::none, airless);
    // The wind's speed and that of a fall over the diagonal, on the area of a mass inside.
    const double speed = 12.0 + std::sqrt(2.0 * 9.81 * std::hypot(0.5, 0.32));
    const auto bounds = model.bounds();
    for (const auto& o : bounds) CHECK(o.air == Approx(rho * c_d * 0.1 * 0.08 * speed));
    for (const auto& o : still.bounds()) CHECK(o.air == 0.0);
    // a + 2b < 4 with b of the air too.
    const double k = 4.0 * 300.0 + 8.0 * 150.0, damping = 2.0 * (12.0 * 0.02 + bounds[0].air);
    const double expected = (-damping + std::sqrt(damping * damping + 16.0 * k * m)) / (2.0 * k);
    CHECK(stable_step(SemiImplicitEuler{}, model).seconds() == Approx(expected).epsilon(1e-12));
    CHECK(automatic_step(SemiImplicitEuler{}, model) < automatic_step(SemiImplicitEuler{}, still));
    CHECK(stable_step(ImplicitEuler{}, still).is_unlimited());
    CHECK(stable_step(ImplicitEuler{}, model).seconds() == Approx(2.0 * m / bounds[0].air));

    // Now: at rest the wind passes at its own speed.
    Sheet<double, SemiImplicitEuler> sheet(model, standing, all_at(glm::dvec3(0.0)));
    FastestMode<double> mode;
    const auto look = [&] { return mode.look(sheet.stepper, 2.0, 2.0, expected, 300, 0.0); };
    CHECK(look().air == Approx(rho * c_d * 0.1 * 0.08 * 12.0 / m).epsilon(1e-9));
    sheet.set(standing, all_at({0.0, 0.0, 15.0}));
    CHECK(look().air == Approx(rho * c_d * 0.1 * 0.08 * 3.0 / m).epsilon(1e-9));
    sheet.set(standing, all_at({9.0, 0.0, 12.0}));
    CHECK(look().air == Approx(rho * c_f * 0.1 * 0.08 * 9.0 / m).epsilon(1e-9));
}

TEMPLATE_LIST_TEST_CASE("Air that is not listed, or of which nothing is, leaves every bit as it is", "[physics]",
                        AllCases) {
    using Tested = Sheet<typename TestType::Real, typename TestType::Method>;
    const Terms terms =
        Terms().add(Gravity{}).add(AirDrag{0.02}).add(Wind{{3.0, 0.5, 1.0}, {1.0, 0.5, 1.0}, 0.1, true});
    const Model without(grid, {m, 200.0, 100.0, 0.05}, Attach::hoist, terms);
    const auto x = scattered(grid, 0.01), v = noise(masses_of(without), 1.0);
    Tested bare(without, x, v);
    bare.advance(1e-4, 5, 2);
    for (const Air& nothing :
         {Air{.pressure = {}, .skin = {}}, Air{.density = 0.0}, Air{.pressure = 0.0, .skin = 0.0}}) {
        Model model = without;
        model.terms.add(nothing);
        Tested listed(model, x, v);
        listed.advance(1e-4, 5, 2);
        CHECK(same_bits(bare, listed));
    }
}

TEMPLATE_LIST_TEST_CASE("A chain has no faces, and faces that are squashed to nothing stay finite", "[physics]",
                        Precisions) {
    for (const auto& [columns, rows] : {std::pair{1, 5}, {5, 1}}) {
        const Model chain({columns, rows, 0.1, 0.1}, slack, Attach::none,
                          Terms().add(both).add(Wind{.velocity = {5.0, 3.0, 1.0}}));
        for (const auto& a : pushed<TestType>(chain, scattered(chain.grid, 0.0), at_rest(chain)))
            CHECK(length(a) < 1e-9);  // m/s2, of slack springs whose lengths are rounded
    }
    const Model model(grid, slack, Attach::none, Terms().add(both).add(Wind{.velocity = {5.0, 3.0, 1.0}}));
    const double most = 2.0 * 0.5 * rho * (c_d + c_f) * 0.1 * 0.08 * 35.0 / m;
    // All in one point, in one line, and folded so that both neighbours meet.
    Points folded = standing;
    for (int n = 0; n < static_cast<int>(folded.size()); ++n) folded[n].x = n % 2 == 0 ? 0.0 : 0.1;
    for (const auto& x : {all_at({1.0, 2.0, 3.0}), flat({1, 0, 0}, {1, 0, 0}), folded})
        for (const auto& a : pushed<TestType>(model, x, all_at(glm::dvec3(0.0)))) CHECK(length(a) <= most);
}

TEST_CASE("A flag made of types feels the wind through the air on its faces", "[physics]") {
    Flag<double, Leapfrog, Gravity, Air, Wind> flag(grid, Attach::hoist, {.mass = m, .stiffness = 200.0}, Gravity{},
                                                    both, Wind{.velocity = {3.0, 0.0, 2.0}});
    flag.advance_batches(6);
    CHECK(flag.position(5, 2).z > 1e-3);
    static_assert(Flag<double, Leapfrog, Air>::damped && !Flag<double, SemiImplicitEuler, Air>::damped);
}
