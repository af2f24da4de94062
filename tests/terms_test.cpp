// Terms: what a flag does not list has no member and is not executed. The kernels are templates over their lane type,
// so a lane that counts shows what the very code of a composition does to a mass.
#include "catch.hpp"
#include "counted_lane.hpp"
#include "physics_sheet.hpp"

#include "drapeau/flag.hpp"

namespace drapeau::bench {

static Counts operator-(const Counts& a, const Counts& b) {
    return {a.multiplications - b.multiplications, a.additions - b.additions, a.others - b.others, a.loads - b.loads,
            a.stores - b.stores};
}
static bool operator==(const Counts& a, const Counts& b) {
    return a.multiplications == b.multiplications && a.additions == b.additions && a.others == b.others &&
           a.loads == b.loads && a.stores == b.stores;
}
static std::ostream& operator<<(std::ostream& out, const Counts& c) {
    return out << c.multiplications << " multiplications, " << c.additions << " additions, " << c.others << " others, "
               << c.loads << " loads, " << c.stores << " stores";
}

}  // namespace drapeau::bench

using namespace drapeau;
using namespace drapeau::testing;
using drapeau::bench::CountedLane;
using drapeau::bench::Counts;

namespace {

// What is not listed has no member.
template <class T>
concept HasAcceleration = requires(T t) {
    t.acceleration;
};
template <class T>
concept HasRate = requires(T t) {
    t.rate;
};

template <class... Terms>
using Folded = decltype(fold<float>(1.0, 0.0, std::declval<Terms>()...));

static_assert(std::is_empty_v<Folded<>>);
static_assert(HasAcceleration<Folded<Gravity>> && !HasRate<Folded<Gravity>>);
static_assert(!HasAcceleration<Folded<AirDrag>> && HasRate<Folded<AirDrag>>);
static_assert(!HasAcceleration<Folded<Friction>> && HasRate<Folded<Friction>>);
static_assert(HasAcceleration<Folded<AirDrag, UniformWind>> && HasRate<Folded<AirDrag, UniformWind>>);
static_assert(sizeof(Folded<Gravity>) == 3 * sizeof(float));
static_assert(sizeof(Folded<AirDrag>) == sizeof(float));
static_assert(sizeof(Folded<Gravity, AirDrag, Friction, UniformWind>) == 4 * sizeof(float));

template <class... More>
using FlagOf = Flag<float, StructuralSprings, More...>;
static_assert(std::is_same_v<FlagOf<>::Pair, SpringForce<false>> && !FlagOf<>::diagonals);
static_assert(std::is_same_v<FlagOf<SpringDamping>::Pair, SpringForce<true>> && !FlagOf<SpringDamping>::diagonals);
static_assert(std::is_same_v<FlagOf<DiagonalSprings>::Pair, SpringForce<false>> && FlagOf<DiagonalSprings>::diagonals);
static_assert(sizeof(FlagOf<>) < sizeof(FlagOf<Gravity>));
static_assert(sizeof(FlagOf<Gravity>) < sizeof(FlagOf<Gravity, AirDrag, UniformWind>));

template <class Work>
Counts counted(Work&& work) {
    const Counts before = Counts::now();
    work();
    return Counts::now() - before;
}

/// What a step does to a mass between the borders: the difference that one more row makes, by its masses.
template <class Real, bool diagonals, bool damped, bool has_acceleration, bool has_rate>
Counts per_mass() {
    constexpr int columns = 16;  // a whole number of the widest registers: no padding is counted
    const auto of_rows = [](int rows) {
        const Grid grid{columns, rows, 0.1, 0.1};
        Material material{0.01, 200.0, {}, {}};
        if (diagonals) material.diagonal_stiffness = 100.0;
        if (damped) material.damping = 0.0;  // zero, but listed
        Cloth<Real> cloth(grid);
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i) cloth.set_position(i, j, grid.rest(i, j));
        const Fabric<Real> fabric(grid, Attach::hoist, material);
        SweepBuffers<Real> buffers(cloth.width());
        const Uniform<Real, has_acceleration, has_rate> uniform{};
        return counted([&] {
            advance_cloth<CountedLane<Real>, SpringForce<damped>, diagonals, SemiImplicitEuler>(
                cloth.view(), fabric.view(), uniform, Real(1e-4), buffers);
        });
    };
    const Counts row = of_rows(6) - of_rows(5);
    return {row.multiplications / columns, row.additions / columns, row.others / columns, row.loads / columns,
            row.stores / columns};
}

/// What the force of one spring takes, from its two masses' difference on.
template <class Real, bool damped>
Counts per_spring() {
    using V = CountedLane<Real>;
    const Real one[] = {1};
    const SpringRow<Real> spring{one, one, one};
    const Triple<V> d{V(1), V(2), V(3)};
    return counted([&] { SpringForce<damped>::template pull<V>(spring, 0, d, d); });
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("A listed term costs what it does and an unlisted one nothing", "[physics]", Precisions) {
    using Real = TestType;
    const Counts bare = per_mass<Real, false, false, false, false>();
    const Counts spring = per_spring<Real, false>(), damped = per_spring<Real, true>();

    // c r (dv . d): a dot product and two products; c is read.
    CHECK(damped - spring == Counts{5, 2, 0, 1, 0});

    // An acceleration is a sum of three components, a rate three products and sums; neither touches memory.
    CHECK(per_mass<Real, false, false, true, false>() - bare == Counts{0, 3, 0, 0, 0});
    CHECK(per_mass<Real, false, false, false, true>() - bare == Counts{3, 3, 0, 0, 0});
    CHECK(per_mass<Real, false, false, true, true>() - bare == Counts{3, 6, 0, 0, 0});

    // Two diagonal springs a mass: their forces, their masses' differences (3 each) and what sums them up: two forces
    // each at two ends (12), one of which waits a register's width (3 others). A fourth mass is looked at.
    CHECK(per_mass<Real, true, false, false, false>() - bare == Counts{2 * spring.multiplications,
                                                                       2 * spring.additions + 6 + 12,
                                                                       2 * spring.others + 3, 2 * spring.loads + 3, 0});

    // Damping: two springs' share of it and their masses' relative velocities, from the velocities of three masses.
    CHECK(per_mass<Real, false, true, false, false>() - bare == Counts{2 * 5, 2 * (2 + 3), 0, 2 * 1 + 3 * 3, 0});
    // With diagonals: four springs', from four masses.
    CHECK(per_mass<Real, true, true, false, false>() - per_mass<Real, true, false, false, false>() ==
          Counts{4 * 5, 4 * (2 + 3), 0, 4 * 1 + 4 * 3, 0});
}

TEMPLATE_LIST_TEST_CASE("Without damping a step reads no neighbour's velocity", "[physics]", Precisions) {
    // Positions here, to the right and below (9), two springs of k and k L (4), the force that waits (3); for the move
    // the inverse mass, x and v (7). Stored: x and v (6) and the force that waits (3).
    const Counts bare = per_mass<TestType, false, false, false, false>();
    CHECK(bare.loads == 9 + 4 + 3 + 7);
    CHECK(bare.stores == 6 + 3);
}

TEST_CASE("A term of zero strength moves a flag as its absence does", "[physics]") {
    const Grid grid = spread(7, 5, 0.6, 0.4);
    Flag<double, StructuralSprings, Gravity> bare(grid, Attach::grommets, 0.01, StructuralSprings{200}, Gravity{});
    Flag<double, StructuralSprings, DiagonalSprings, SpringDamping, Gravity, AirDrag, Friction, UniformWind> zero(
        grid, Attach::grommets, 0.01, StructuralSprings{200}, DiagonalSprings{0}, SpringDamping{0}, Gravity{},
        AirDrag{0}, Friction{0}, UniformWind{Wind{{5.0, 0.0, 1.0}}});
    bare.advance(SemiImplicitEuler{}, 1e-3, 100);
    zero.advance(SemiImplicitEuler{}, 1e-3, 100);
    bool same = true;
    for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 7; ++i) same = same && bare.cloth().position(i, j) == zero.cloth().position(i, j);
    CHECK(same);  // x + 0 and 0 * x change no bit of a finite x
    CHECK(bare.time() == Approx(0.1));
    CHECK(bare.largest_stable_step(SemiImplicitEuler{}) == zero.largest_stable_step(SemiImplicitEuler{}));
}

TEST_CASE("A flag moves as its terms say", "[physics]") {
    // The same composition through the interface for who embeds the core and through kernels put together by hand
    const Grid grid = spread(9, 6, 0.8, 0.5);
    const Wind wind{{3.0, 0.5, 1.0}, {1.0, 0.5, 1.0}, 0.2, 3};
    Flag<float, StructuralSprings, DiagonalSprings, SpringDamping, Gravity, AirDrag, Friction, UniformWind> flag(
        grid, Attach::hoist, 0.01, StructuralSprings{150}, DiagonalSprings{70}, SpringDamping{0.02}, Gravity{},
        AirDrag{0.01}, Friction{0.005}, UniformWind{wind});
    Setting s{.grid = grid, .attach = Attach::hoist, .material = {0.01, 150.0, 70.0, 0.02}};
    s.gravity = {0.0, -9.8, 0.0}, s.drag = 0.01, s.friction = 0.005, s.wind = wind;
    Sheet<float, SemiImplicitEuler> sheet(s);
    flag.advance(SemiImplicitEuler{}, 1e-3, 100);
    sheet.advance(1e-3, 100);
    CHECK(same_bits(flag.cloth(), sheet.cloth));
    CHECK(flag.largest_stable_step(SemiImplicitEuler{}) == largest_step(SemiImplicitEuler{}, s.rates()));
    CHECK(flag.largest_stable_step(ForwardEuler{}) == largest_step(ForwardEuler{}, s.rates()));
}
