// Terms: what a flag does not list is not executed. The kernels are templates over their lane type, so a lane that
// counts shows what the very code of a composition does to a mass.
#include "catch.hpp"
#include "counted_lane.hpp"
#include "physics_sheet.hpp"

namespace drapeau::bench {

static bool operator==(const Counts& a, const Counts& b) {
    return a.multiplications == b.multiplications && a.additions == b.additions && a.divisions == b.divisions &&
           a.others == b.others && a.loads == b.loads && a.stores == b.stores;
}
static std::ostream& operator<<(std::ostream& out, const Counts& c) {
    return out << c.multiplications << " multiplications, " << c.additions << " additions, " << c.divisions
               << " divisions, " << c.others << " others, " << c.loads << " loads, " << c.stores << " stores";
}

}  // namespace drapeau::bench

using namespace drapeau;
using namespace drapeau::testing;
using drapeau::bench::CountedLane;
using drapeau::bench::Counts;

namespace {

template <class... More>
using FlagOf = Flag<float, SemiImplicitEuler, More...>;
static_assert(!FlagOf<>::damped && !FlagOf<>::diagonals && !FlagOf<>::rated);
static_assert(FlagOf<SpringDamping>::damped && !FlagOf<SpringDamping>::diagonals && !FlagOf<SpringDamping>::rated);
static_assert(FlagOf<DiagonalSprings>::diagonals && !FlagOf<DiagonalSprings>::damped);
static_assert(FlagOf<AirDrag>::rated && FlagOf<Friction>::rated && !FlagOf<Gravity, StretchLimit>::rated);

/// What `pass` does to a mass between the borders: the difference that one more row makes, by its masses. `fields`: as
/// many as its method has; `watched`: the field whose loads are counted apart.
template <class Real>
Counts per_mass(const Springs& springs, int fields, int watched, void (*pass)(const Pass<Real>&)) {
    constexpr int columns = 16;  // a whole number of the widest registers: no padding is counted
    const auto of_rows = [&](int rows) {
        const Model model({columns, rows, 0.1, 0.1}, springs, Attach::hoist);
        Rows<Real> cloth(
            model, std::vector<FieldBuffer<Real>>(static_cast<std::size_t>(fields), FieldBuffer<Real>(columns, rows)));
        auto given = cloth.whole(1e-4);
        given.accelerate = nullptr;
        Counts& now = Counts::now();
        now = {};
        const auto& seen = cloth.fields[static_cast<std::size_t>(watched)].component(0);
        now.watched_from = seen.begin(), now.watched_to = seen.end();
        pass(given);
        return now;
    };
    const Counts more = of_rows(6), fewer = of_rows(5);
    const auto each = [&](double Counts::*of) { return (more.*of - fewer.*of) / columns; };
    Counts mass;
    for (const auto of : {&Counts::multiplications, &Counts::additions, &Counts::divisions, &Counts::others,
                          &Counts::loads, &Counts::stores, &Counts::watched_loads})
        mass.*of = each(of);
    return mass;
}

/// The first pass of a step of a composition.
template <class Real, class Method, bool diagonals, bool damped, bool rated>
Counts per_mass(int watched = 1) {
    Springs springs{0.01, 200.0, {}, {}};
    if (diagonals) springs.diagonal_stiffness = 100.0;
    if (damped) springs.damping = 0.0;  // zero, but listed
    return per_mass<Real>(springs, Method::template fields<damped>, watched,
                          &advance_rows<CountedLane<Real>, Method, 0, damped, diagonals, rated>);
}

double arithmetic(const Counts& c) {
    return c.multiplications + c.additions + c.divisions + c.others;
}

/// What a mass costs with nothing listed and with more.
struct Costs {
    Counts bare, rated, damped, diagonals, both;  // both: damped, with diagonals
};

void check(const Costs& cost) {
    const auto& [bare, rated, damped, diagonals, both] = cost;
    for (const Counts& listed : {rated, damped, diagonals}) {
        CHECK(arithmetic(listed) > arithmetic(bare));
        CHECK(listed.loads > bare.loads);
    }
    // Drag and friction are one rate however many of them there are; braking by it takes at most a product and a
    // difference of three components, and what leapfrog centres them by. None stores anything.
    CHECK(rated.loads == bare.loads + 1);
    CHECK(rated.stores == bare.stores);
    CHECK(diagonals.stores == bare.stores);
    // A damper costs the same whatever else is listed: what it adds for two springs a mass it adds twice for four, but
    // for velocities that are looked at once for several springs.
    const double for_two = damped.multiplications - bare.multiplications,
                 for_four = both.multiplications - diagonals.multiplications;
    CHECK(for_four - for_two > 0.0);
    CHECK(for_four <= 2.0 * for_two);
    // Structural springs and diagonals alike: two more springs a mass cost as much as the two there were, the move of
    // the mass apart.
    CHECK(diagonals.multiplications - bare.multiplications < bare.multiplications);
    CHECK(2.0 * (diagonals.multiplications - bare.multiplications) > bare.multiplications);
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("What is listed costs, what is not costs nothing", "[physics]", SweptCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    check({.bare = per_mass<Real, Method, false, false, false>(),
           .rated = per_mass<Real, Method, false, false, true>(),
           .damped = per_mass<Real, Method, false, true, false>(),
           .diagonals = per_mass<Real, Method, true, false, false>(),
           .both = per_mass<Real, Method, true, true, false>()});
}

TEMPLATE_LIST_TEST_CASE("Without damping no neighbour's velocity is read", "[physics]", SweptCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    constexpr int seen = Method::template seen_velocity<true>, kept = Method::template seen_velocity<false>;
    const Counts bare = per_mass<Real, Method, true, false, true>(kept);
    const Counts damped = per_mass<Real, Method, true, true, true>(seen);
    CHECK(bare.watched_loads == 1.0);    // of each component: a mass's own, to move it
    CHECK(damped.watched_loads >= 4.0);  // the four masses of its cell
}

TEMPLATE_LIST_TEST_CASE("Without damping no mass feels how its neighbours move", "[physics]", SweptCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    for (const bool diagonals : {false, true}) {
        const Springs springs{0.01, 200.0, diagonals ? std::optional(100.0) : std::nullopt, {}};
        const Model model({5, 4, 0.1, 0.1}, springs, Attach::none);
        const auto kernels = kernels_for<Vector<Real>, Method>(model);
        Sheet<Real, Method> sheet(model, scattered(model.grid, 0.02), noise(20, 1.0));
        sheet.advance(1e-4, 1);  // the method has started
        for (int n = 0; n < 20; ++n) {
            Rows<Real> calm(model, sheet.checkpoint().fields), wild = calm.copy();
            auto& v = wild.fields[static_cast<std::size_t>(kernels.seen_velocity)];
            for (int other = 0; other < 20; ++other)
                if (other != n) v.set(other % 5, other / 5, glm::dvec3(NAN));
            kernels.advance[0](calm.whole(1e-4)), kernels.advance[0](wild.whole(1e-4));
            for (int f = 0; f < kernels.fields; ++f)
                CHECK(calm.fields[static_cast<std::size_t>(f)].at(n % 5, n / 5) ==
                      wild.fields[static_cast<std::size_t>(f)].at(n % 5, n / 5));
        }
    }
}

TEMPLATE_LIST_TEST_CASE("Without damping leapfrog keeps and stores what semi-implicit Euler does", "[physics]",
                        Precisions) {
    using Real = TestType;
    CHECK(kernels_of<Vector<Real>, Leapfrog, false, true>().fields == 2);
    CHECK(kernels_of<Vector<Real>, Leapfrog, true, true>().fields == 3);
    CHECK(per_mass<Real, Leapfrog, true, false, false>() == per_mass<Real, SemiImplicitEuler, true, false, false>());
    CHECK(per_mass<Real, Leapfrog, true, false, true>().stores ==
          per_mass<Real, SemiImplicitEuler, true, false, true>().stores);
    // With it three components more, and nothing more is read: damping looks at these instead of the velocity.
    CHECK(per_mass<Real, Leapfrog, true, true, false>().stores ==
          per_mass<Real, SemiImplicitEuler, true, true, false>().stores + 3.0);
}

TEMPLATE_LIST_TEST_CASE("A term of zero strength moves a flag as its absence does", "[physics]", DoubleCases) {
    using Method = typename TestType::Method;
    const Grid grid = spread(7, 5, 0.6, 0.4);
    Flag<double, Method, Gravity> bare(grid, Attach::grommets, {0.01, 200.0}, Gravity{});
    Flag<double, Method, DiagonalSprings, SpringDamping, Gravity, AirDrag, Friction, Wind> zero(
        grid, Attach::grommets, {0.01, 200.0}, DiagonalSprings{0.0}, SpringDamping{0.0}, Gravity{}, AirDrag{0.0},
        Friction{0.0}, Wind{.velocity = {5.0, 0.0, 1.0}});
    bare.set_step(1e-3), zero.set_step(1e-3);
    bare.advance(100), zero.advance(100);
    // x + 0 and 0 * x change no bit of a finite x
    CHECK(points_of(bare.state().position) == points_of(zero.state().position));
    CHECK(points_of(bare.state().velocity) == points_of(zero.state().velocity));
    CHECK(bare.time() == Approx(0.1));
    CHECK(bare.largest_stable_step() == zero.largest_stable_step());
}

TEMPLATE_LIST_TEST_CASE("A flag moves as its terms say", "[physics]", FloatCases) {
    // The same composition through the interface for who embeds the core and through kernels chosen by the model
    using Method = typename TestType::Method;
    const Grid grid = spread(9, 6, 0.8, 0.5);
    const Wind wind{{3.0, 0.5, 1.0}, {1.0, 0.5, 1.0}, 0.2, false, 3};
    Flag<float, Method, DiagonalSprings, SpringDamping, Gravity, AirDrag, Friction, Wind> flag(
        grid, Attach::hoist, {0.01, 150.0}, DiagonalSprings{70.0}, SpringDamping{0.02}, Gravity{}, AirDrag{0.01},
        Friction{0.005}, wind);
    const Model model(grid, {0.01, 150.0, 70.0, 0.02}, Attach::hoist,
                      Terms().add(Gravity{}).add(AirDrag{0.01}).add(Friction{0.005}).add(wind));
    Sheet<float, Method> sheet(model);
    flag.set_step(1e-3);
    flag.advance(100), sheet.advance(1e-3, 100);
    CHECK(points_of(flag.state().position) == sheet.positions());
    CHECK(points_of(flag.state().velocity) == sheet.velocities());
    CHECK(flag.largest_stable_step() == stable_step(Method{}, model));
    // A strength that is set while it flies is that strength.
    Model stronger = model;
    stronger.terms.add(AirDrag{0.03});
    stronger.springs.stiffness = 160.0;
    flag.set(AirDrag{0.03}), flag.set(Cloth{0.01, 160.0});
    sheet.stepper.synchronise(flag.time());
    sheet.stepper.refill(stronger);
    flag.advance(100), sheet.advance(1e-3, 100);
    CHECK(points_of(flag.state().position) == sheet.positions());
}
