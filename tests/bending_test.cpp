// Bending: what a curved sheet holds and feels in closed form, what cannot matter, its modes, limits and buckling.
#include "catch.hpp"
#include "physics_reference.hpp"
#include "physics_sheet.hpp"

#include "drapeau/fastest_mode.hpp"

#include <glm/gtc/constants.hpp>

using namespace drapeau;
using namespace drapeau::testing;

namespace {

constexpr double B = 2e-3, rate = 40.0, rho = 0.11;  // N m, 1/s, kg/m2
constexpr double pi = glm::pi<double>();
const Bending bare{.stiffness = B}, braked{.stiffness = B, .damping = rate};

/// A sheet of light borders of which only bending is felt: its springs push with a millionth of a newton at most.
Model bent_sheet(const Grid& grid, const Bending& bending, Attach attach = Attach::none) {
    return Model(grid, {rho * grid.pitch_x * grid.pitch_y, 1e-9, {}, {}}, attach, Terms().add(bending), {},
                 Borders::light);
}

template <class Shape>
Points shaped(const Grid& grid, Shape&& z) {
    auto x = scattered(grid, 0.0);
    for (auto& p : x) p.z = z(p.x, p.y);
    return x;
}

/// The acceleration of every mass of a state.
template <class Real, class Method = SemiImplicitEuler>
Points felt(const Model& model, const Points& x, const Points& v) {
    Sheet<Real, Method> sheet(model, x, v);
    FieldBuffer<Real> a(model.grid.columns, model.grid.rows);
    sheet.stepper.evaluate(0.0, a);
    return points_of(a);
}

/// What a second difference of coordinates or velocities known to eps `size` accelerates a mass with at most: four such
/// differences a line, on masses that may be half as heavy (a line along a border is half as strong, too).
template <class Real>
double rounding(const Model& model, double size_x, double size_v) {
    const auto b = model.bending_strength();
    return 64.0 * epsilon<Real> * 2.0 * ((b.k_fly + b.k_hoist) * size_x + (b.c_fly + b.c_hoist) * size_v) /
           model.springs.mass;
}

const Grid grids[] = {{9, 7, 0.1, 0.1}, {12, 8, 0.05, 0.08}, {3, 9, 0.1, 0.06},
                      {2, 5, 0.1, 0.1}, {6, 1, 0.1, 0.2},    {17, 3, 0.03, 0.05}};

}  // namespace

TEST_CASE("A sheet bent to a parabola holds B/2 of the curvature's square, on every grid", "[physics]") {
    // Second differences of a parabola are exact. A line of n cells has n - 1 places where it bends.
    const double curvature = 0.4;  // 1/m
    for (const Grid& grid : grids) {
        const Model model = bent_sheet(grid, bare);
        const auto energy = [&](double fly, double hoist) {
            Sheet<double, SemiImplicitEuler> sheet(
                model, shaped(grid, [&](double x, double y) { return 0.5 * (fly * x * x + hoist * y * y); }),
                at_rest(model));
            return sheet.measure().elastic;
        };
        const int across = grid.columns - 1, down = grid.rows - 1;
        const double cell = grid.pitch_x * grid.pitch_y, held = 0.5 * B * curvature * curvature * cell;
        // A chain is a strip as wide as its row's pitch.
        const double along_fly = held * std::max(0, across - 1) * std::max(1, down);
        const double along_hoist = held * std::max(0, down - 1) * std::max(1, across);
        // What springs of a billionth of a N/m hold that are longer by far less than a metre.
        const double nothing = 1e-9;
        INFO(grid.columns << " x " << grid.rows);
        CHECK(energy(curvature, 0.0) == Approx(along_fly).epsilon(1e-9).margin(nothing));
        CHECK(energy(0.0, curvature) == Approx(along_hoist).epsilon(1e-9).margin(nothing));
        CHECK(energy(curvature, -curvature) == Approx(along_fly + along_hoist).epsilon(1e-9).margin(nothing));
        CHECK(std::max(along_fly, along_hoist) > 1000.0 * nothing);
    }
}

TEMPLATE_LIST_TEST_CASE("A sheet that lies flat, wherever, however stretched and spinning, is not bent", "[physics]",
                        Precisions) {
    const glm::dvec3 fly{0.7, 0.2, -0.5}, up{-0.3, 1.2, 0.4}, spin{3.0, -2.0, 1.0};
    for (const Grid& grid : grids) {
        const Model model = bent_sheet(grid, braked);
        Points x, v;
        for (const auto& p : scattered(grid, 0.0)) {
            x.push_back(glm::dvec3{1.0, -0.5, 0.3} + p.x * fly + p.y * up);
            v.push_back(cross(spin, x.back()));
        }
        // The springs' own, of a billionth of a N/m.
        const double springs = 8.0 * 1e-9 * 1.0 / (0.25 * model.springs.mass);
        for (const auto& a : felt<TestType>(model, x, v))
            CHECK(length(a) <= rounding<TestType>(model, 2.0, 8.0) + springs);
    }
}

TEMPLATE_LIST_TEST_CASE("Bent in any shape and motion masses feel what the plain equations say", "[physics]",
                        Precisions) {
    for (const auto borders : {Borders::alike, Borders::light})
        for (const Bending& bending : {Bending{.stiffness = 0.2}, Bending{.stiffness = 0.2, .damping = 1e4}})
            for (const auto& [columns, rows] :
                 {std::pair{2, 2}, {3, 2}, {2, 3}, {5, 4}, {16, 3}, {17, 5}, {33, 7}, {9, 1}, {1, 9}}) {
                const Grid grid{columns, rows, 0.1, 0.08};
                const Model model(grid, {0.01, 20.0, 10.0, 0.01}, Attach::hoist,
                                  Terms().add(Gravity{}).add(bending).add(Air{}).add(Wind{.travelling = true}), {},
                                  borders);
                const auto x = scattered(grid, 0.03);
                auto v = noise(masses_of(model), 1.0);
                for (int n = 0; n < masses_of(model); ++n)
                    if (is_held(model, n)) v[n] = glm::dvec3(0.0);
                const auto expected = Reference(model, borders).acceleration(x, v, 0.0);
                const auto found = felt<TestType>(model, x, v);
                // Springs and air: forces of up to 20 N on a quarter of 0.01 kg, some forty roundings each; normals of
                // faces as in their own test.
                const double others = (40.0 + 16.0 * 3.3 / 0.05) * epsilon<TestType> * 20.0 * 3.3 / 0.0025;
                INFO(columns << " x " << rows);
                CHECK(distance(found, expected) <= rounding<TestType>(model, 3.3, 2.0) + others);
            }
}

TEMPLATE_LIST_TEST_CASE("Held at its sides a strip bends in lattice modes, and is braked in them", "[physics]",
                        Precisions) {
    // Second differences with both ends at 0 have the modes sin(q pi i/N) with -4 sin^2(q pi/2N), and what they resist
    // is that squared.
    constexpr int cells = 20;
    const Grid grid = spread(cells + 1, 4, 1.0, 0.2);
    const Model model = bent_sheet(grid, braked, Attach::sides);
    for (const int q : {1, 2, 7, cells - 1}) {
        const auto mode = shaped(grid, [&](double x, double) { return 1e-3 * std::sin(q * pi * x); });
        Points moving = at_rest(model);
        for (std::size_t n = 0; n < mode.size(); ++n) moving[n].z = mode[n].z;
        const double share = std::pow(std::sin(q * pi / (2.0 * cells)), 4);
        const double square = 16.0 * share * B / (rho * std::pow(grid.pitch_x, 4));  // 1/s2
        const auto bent = felt<TestType>(model, mode, at_rest(model));
        const auto slowed = felt<TestType>(model, scattered(grid, 0.0), moving);
        for (std::size_t n = 0; n < mode.size(); ++n) {
            if (is_held(model, static_cast<int>(n))) continue;
            // Only z is known: x and y are places along the strip, whose second differences are rounding.
            CHECK(bent[n].z == Approx(-square * mode[n].z).margin(rounding<TestType>(model, 1e-3, 0.0) + 1e-9));
            CHECK(slowed[n].z ==
                  Approx(-rate * share * moving[n].z).margin(rounding<TestType>(model, 0.0, 1e-3) + 1e-9));
        }
    }
}

TEST_CASE("Refined, a bending strip tends to the beam's frequencies with order 2", "[physics]") {
    // sqrt(B/rho) (q pi/L)^2, of which sin^2(a)/a^2 = 1 - a^2/3 + 2a^4/45 with a = q pi/2N is there on N cells.
    for (const int q : {1, 3}) {
        const double beam = std::sqrt(B / rho) * std::pow(q * pi / 1.0, 2);
        std::vector<double> off;
        for (const int cells : {16, 32, 64}) {
            const Grid grid = spread(cells + 1, 3, 1.0, 0.1);
            const Model model = bent_sheet(grid, bare, Attach::sides);
            const auto mode = shaped(grid, [&](double x, double) { return 1e-3 * std::sin(q * pi * x); });
            const auto a = felt<double>(model, mode, at_rest(model));
            const auto n = static_cast<std::size_t>(cells / (2 * q));  // near a crest
            off.push_back(1.0 - std::sqrt(-a[n].z / mode[n].z) / beam);
        }
        for (int n = 0; n < 2; ++n) {
            const double a = q * pi / (2.0 * (16 << n));
            // Four times, but for the next term, (1 - 2/15 a^2) over (1 - 1/30 a^2).
            CHECK(off[n] / off[n + 1] == Approx(4.0).epsilon(0.11 * a * a));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("What bending stores is no work of others, and staggered methods keep it", "[physics]",
                        DoubleCases) {
    using Method = typename TestType::Method;
    const Grid grid{12, 8, 0.05, 0.08};
    const Model model = bent_sheet(grid, bare, Attach::hoist);
    const auto x = shaped(grid, [](double along, double down) { return 0.1 * std::sin(7.0 * along + 5.0 * down); });
    const double limit = StableStep(stable_step(SemiImplicitEuler{}, model)).seconds();
    Sheet<double, Method> sheet(model, x, at_rest(model));
    const double dt = 0.2 * limit;
    sheet.advance(dt, 1);
    const double before = sheet.measure().total(), most = before * (std::is_same_v<Method, ForwardEuler> ? 1e3 : 10.0);
    for (int n = 0; n < 100; ++n) {
        const Work work = sheet.accounted_step(dt).work;
        // The springs' own forces are counted for themselves; a step moves no more energy than there is.
        REQUIRE(std::abs(work.external) <= 1e-12 * most);
        REQUIRE(work.damping == 0.0);
    }
    // m v-.v+ / 2 + x K x / 2 is constant in linear motion; 100 steps, each rounded some 40 times.
    if (Method::staggered) CHECK(sheet.measure().total() == Approx(before).epsilon(4000.0 * epsilon<double>));
    CHECK(sheet.measure().kinetic > 0.01 * before);
}

TEMPLATE_LIST_TEST_CASE("Bending damping takes what the ledger says", "[physics]", DoubleCases) {
    using Method = typename TestType::Method;
    const Grid grid{12, 8, 0.05, 0.08};
    const Model model = bent_sheet(grid, braked);
    Points v = at_rest(model);
    for (std::size_t n = 0; n < v.size(); ++n) v[n].z = 0.3 * ((n + n / 12) % 2 == 0 ? 1.0 : -1.0);
    Sheet<double, Method> sheet(model, scattered(grid, 0.0), v);
    // In so short a step that bending has no time to store anything: of v by rate dt = 4e-8 each way.
    const double dt = 1e-9;
    sheet.advance(dt, 0);
    const double before = sheet.measure().kinetic_now;
    const Work work = sheet.accounted_step(dt).work;
    CHECK(work.external < 0.0);
    CHECK(sheet.measure().kinetic_now - before ==
          Approx(work.external).epsilon(1e-6).margin(100 * epsilon<double> * before));
    // Of a checkerboard each triple brakes with r m/16 (4v)^2, border ones with half; a row of n masses has n - 2 of
    // them, and weighs as much as n - 1.
    CHECK(-work.external == Approx(2.0 * before * rate * dt * (10.0 / 11.0 + 6.0 / 7.0)).epsilon(1e-6));
}

TEMPLATE_LIST_TEST_CASE("A method is stable up to the limit that it says for bending", "[physics]", DoubleCases) {
    // Held at its edges the sheet's fastest mode is that of both shortest waves, sin^4(pi/2 (1 - 1/N)) of the bound:
    // the limit is (pi/2N)^2 = 0.0016 further on, and more along the shorter side. Damped by a rate, limits are half
    // way.
    using Method = typename TestType::Method;
    constexpr int cells = 40;
    for (const std::optional<double> damping : {std::optional<double>(), std::optional(500.0)}) {
        const Grid grid = spread(cells + 1, cells + 1, 1.0, 1.0);
        const Model model = bent_sheet(grid, {.stiffness = B, .damping = damping}, Attach::edges);
        const StableStep limit = stable_step(Method{}, model);
        if (std::is_same_v<Method, ForwardEuler>) {
            CHECK(limit.is_none());
            continue;
        }
        REQUIRE(limit.is_finite());
        CHECK(damping_needed(model, 1e-3) == Approx(1e-3 * 32.0 * B / (grid.pitch_x * grid.pitch_x)).epsilon(1e-6));
        const double largest =
            Method::bound_is_safe_only ? exact_step(Method{}, model.bounds().front()).seconds() : limit.seconds();
        for (const double share : {0.98, 1.03}) {
            auto x = scattered(grid, 0.0);
            const auto shaken = noise(masses_of(model), 1e-9);
            for (std::size_t n = 0; n < x.size(); ++n)
                if (!is_held(model, static_cast<int>(n))) x[n].z = shaken[n].z;
            Sheet<double, Method> sheet(model, x, at_rest(model));
            sheet.advance(share * (share < 1.0 ? limit.seconds() : largest), 300);
            auto off = sheet.positions();
            for (auto& p : off) p.x = p.y = 0.0;
            const double most = root_mean_square(off);
            INFO("damping " << damping.value_or(0.0) << " at " << share << " of the limit");
            CHECK((most < 1e-7) == (share < 1.0));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("The limit here and now is that of the sheet's own fastest bending mode", "[physics]",
                        Precisions) {
    // Held at its edges: the shortest wave both ways, sin^4(pi/2 (1 - 1/N)) of the bound. Power iteration tends to it
    // from below; the next mode is sin^4 of 1 - 2/N away, 10 % here, so 300 products leave 0.9^600 of it.
    const Grid grid{9, 7, 0.1, 0.08};
    const Model model = bent_sheet(grid, braked, Attach::edges);
    Sheet<TestType, SemiImplicitEuler> sheet(model);
    FastestMode<TestType> mode;
    const auto found = mode.look(sheet.stepper, 2.0, 2.0, 1e-3, 300, 0.0);
    const double fly = std::pow(std::cos(pi / 16.0), 4), hoist = std::pow(std::cos(pi / 12.0), 4);
    CHECK(found.mass == 1.0);
    CHECK(found.stiffness ==
          Approx(16.0 * B * (fly * std::pow(0.1, -4) + hoist * std::pow(0.08, -4)) / rho).epsilon(1e-5));
    CHECK(found.damping == Approx(rate * (fly + hoist)).epsilon(1e-5));
    const StableStep limit = exact_step(SemiImplicitEuler{}, found);
    CHECK(limit.seconds() > stable_step(SemiImplicitEuler{}, model).seconds());
}

TEST_CASE("The Hessian with bending is the derivative of the forces, for any number of threads", "[physics][threads]") {
    for (const auto& [columns, rows] : {std::pair{9, 7}, {17, 5}, {7, 1}, {1, 9}})
        for (const std::optional<double> damping : {std::optional<double>(), std::optional(rate)}) {
            const Grid grid{columns, rows, 0.1, 0.08};
            const Model model(grid, {0.01, 20.0, 10.0, 0.01}, Attach::corner,
                              Terms().add(Bending{.stiffness = 0.02, .damping = damping}));
            const auto x = scattered(grid, 0.01);
            auto u = noise(masses_of(model), 1.0);
            for (int n = 0; n < masses_of(model); ++n)
                if (is_held(model, n)) u[n] = glm::dvec3(0.0);
            const auto moved = [&](double by) {
                auto to = x;
                for (std::size_t n = 0; n < to.size(); ++n) to[n] += by * u[n];
                return to;
            };
            const double h = 1e-6, k = 3.0, c = 7.0;
            const auto rest = at_rest(model);
            const auto ahead = felt<double>(model, moved(h), rest), behind = felt<double>(model, moved(-h), rest);
            const auto still = felt<double>(model, x, rest), moving = felt<double>(model, x, u);
            Points expected = rest;
            double most = 0.0;
            for (std::size_t n = 0; n < x.size(); ++n) {
                expected[n] = -k / (2.0 * h) * (ahead[n] - behind[n]) - c * (moving[n] - still[n]);
                most = std::max(most, length(expected[n]));
            }
            std::vector<Points> found;
            for (const int threads : {1, 2, 3}) {
                Sheet<double, SemiImplicitEuler> sheet(model, x, rest);
                sheet.stepper.use_threads(threads);
                FieldBuffer<double> direction(columns, rows), out(columns, rows);
                set_points(direction, u);
                sheet.stepper.stiffness(k, c, 0.0, direction, out);
                found.push_back(points_of(out));
                CHECK(found.back() == found.front());
            }
            // Springs of 8 cm turn by h/0.08 at most, whose square is nothing; forces known to a few eps of k 2 m are
            // divided by h.
            INFO(columns << " x " << rows << ", damping " << damping.value_or(0.0));
            CHECK(distance(found.front(), expected) <
                  (100.0 * epsilon<double> / h + 100.0 * h * h / (0.06 * 0.06)) * 1e3 * most);
        }
}

TEMPLATE_LIST_TEST_CASE("Bending of no stiffness changes no bit", "[physics]", AllCases) {
    using Tested = Sheet<typename TestType::Real, typename TestType::Method>;
    const Grid grid{17, 5, 0.1, 0.08};
    const Terms terms =
        Terms().add(Gravity{}).add(AirDrag{0.02}).add(Wind{{3.0, 0.5, 1.0}, {1.0, 0.5, 1.0}, 0.1, true});
    const Model without(grid, {0.01, 200.0, 100.0, 0.05}, Attach::hoist, terms);
    Model model = without;
    model.terms.add(Bending{.stiffness = 0.0});
    const auto x = scattered(grid, 0.01), v = noise(masses_of(without), 1.0);
    Tested bare_sheet(without, x, v), listed(model, x, v);
    bare_sheet.advance(1e-4, 5), listed.advance(1e-4, 5);
    CHECK(same_bits(bare_sheet, listed));
}

TEST_CASE("A strip pressed together buckles in the same folds on every grid that is fine enough", "[physics]") {
    // A fold of wave number q grows with sigma^2 = (P s - B s^2)/rho, s = 4/a^2 sin^2(q a/2), under the push P an edge
    // (N/m): fastest where s = P/2B, with P^2/4B rho, whatever the grid; without bending at the shortest wave, twice as
    // fast on cells half as long.
    const double Y = 300.0, shorter = 0.99, push = Y * (1.0 / shorter - 1.0),
                 stiff = push / (2.0 * std::pow(12.3 * pi, 2));
    const double fastest_of_all = push / std::sqrt(4.0 * stiff * rho);
    double without_before = 0.0;
    for (const int cells : {32, 64, 128}) {
        const Grid grid = spread(cells + 1, 3, 1.0, 0.1);
        const auto fastest = [&](const Terms& terms) {
            const Fabric cloth{.density = rho, .stretch_modulus = Y, .diagonal_share = {}, .damping_time = {}};
            const Model model = model_of(cloth, grid, Attach::sides, terms);
            double most = 0.0;
            for (int q = 1; q < cells; ++q) {
                auto x = shaped(grid, [&](double along, double) { return 1e-9 * std::sin(q * pi * along); });
                for (auto& p : x) p.x *= shorter;
                const auto a = felt<double>(model, x, at_rest(model));
                double grows = 0.0, size = 0.0;
                for (std::size_t n = 0; n < x.size(); ++n) grows += a[n].z * x[n].z, size += x[n].z * x[n].z;
                const double s = std::pow(2.0 / grid.pitch_x * std::sin(0.5 * q * pi * grid.pitch_x), 2);
                const double resists = terms.get<Bending>() ? stiff * s : 0.0;
                // Lengths are shorter by a hundredth of themselves, known to eps of 1 m over a cell.
                CHECK(grows / size == Approx(s * (push - resists) / rho).epsilon(1e-9).margin(1e-9 * s * push / rho));
                most = std::max(most, grows / size);
            }
            return std::sqrt(most);
        };
        INFO(cells << " cells");
        // Waves are whole numbers of halves, s of the 12th and 13th 17 % apart: the nearest is at most half of that
        // off, sigma^2 by its square.
        CHECK(fastest(Terms().add(Bending{.stiffness = stiff})) == Approx(fastest_of_all).epsilon(0.5 * 0.085 * 0.085));
        const double without = fastest({});
        if (without_before > 0.0) CHECK(without / without_before == Approx(2.0).epsilon(0.01));
        without_before = without;
    }
}

TEST_CASE("A strip that buckled rests in the elastica's shape, nearer with order 2 on finer grids", "[physics]") {
    // Inextensible, between hinges that came nearer by the share e of its length: with the modulus k of the end's slope
    // (k = sin(slope/2)), e = 2 (1 - E(k)/K(k)) and its height is L k/K(k); its push is B (2K/L)^2. The threads are so
    // stiff that this push shortens them by next to nothing, which e is made smaller by.
    const double e = 0.05, stiff = 0.05, Y = 3e4;
    const auto nearer = [](double k) { return 2.0 * (1.0 - std::comp_ellint_2(k) / std::comp_ellint_1(k)); };
    const double shortened =
        stiff * std::pow(2.0 * std::comp_ellint_1(last_where(0.0, 0.9, [&](double k) { return nearer(k) < e; })), 2) /
        Y;
    const double k = last_where(0.0, 0.9, [&](double at) { return nearer(at) < e - shortened; });
    const double height = k / std::comp_ellint_1(k);
    std::vector<double> off;
    for (const int cells : {8, 16, 32}) {
        const Grid grid = spread(cells + 1, 2, 1.0, 0.1);
        const Fabric cloth{.density = 0.1, .stretch_modulus = Y, .diagonal_share = {}, .damping_time = {}};
        Model model = model_of(cloth, grid, Attach::sides, Terms().add(Bending{.stiffness = stiff}));
        model.terms.add(Friction{20.0 * model.springs.mass});
        auto x = shaped(grid, [&](double along, double) { return 0.95 * height * std::sin(pi * along); });
        for (auto& p : x) p.x *= 1.0 - e;
        Sheet<double, SemiImplicitEuler> sheet(model, x, at_rest(model));
        const double dt = 0.5 * stable_step(SemiImplicitEuler{}, model).seconds();
        sheet.advance(dt, std::llround(3.0 / dt));  // s: whatever swings has died down by exp(-30)
        REQUIRE(root_mean_square(sheet.velocities()) < 1e-9);
        off.push_back(sheet.positions()[static_cast<std::size_t>(cells / 2)].z / height - 1.0);
    }
    INFO("heights off by " << off[0] << ", " << off[1] << ", " << off[2]);
    // The next term of the error is (pi/N)^2 of the first. What the push shortens is known to a tenth, of a height that
    // goes with the root of e: the same share of the height.
    CHECK(off[0] / off[1] == Approx(4.0).epsilon(std::pow(pi / 8.0, 2)));
    CHECK(off[1] / off[2] == Approx(4.0).epsilon(std::pow(pi / 16.0, 2) + 2.0 * shortened / off[2]));
}

TEST_CASE("A flag made of types has the bound of its bending", "[physics]") {
    const Grid grid = spread(9, 7, 0.8, 0.6);
    Flag<double, Leapfrog, Bending> flag(grid, Attach::hoist, {0.001, 50.0}, {.stiffness = 0.5, .damping = 20.0});
    Flag<double, Leapfrog> limp(grid, Attach::hoist, {0.001, 50.0});
    CHECK(flag.damped);
    CHECK(stable_step(Leapfrog{}, flag.model()).seconds() < stable_step(Leapfrog{}, limp.model()).seconds());
}
