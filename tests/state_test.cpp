// State: what leaves a run is position and velocity at the same time; looking at it alters nothing; a checkpoint goes
// on to the same bits.
#include "catch.hpp"
#include "physics_reference.hpp"
#include "physics_sheet.hpp"

using namespace drapeau;
using namespace drapeau::testing;

namespace {

Model cloth(const Springs& springs, bool limited = false) {
    Limits limits;
    if (limited) limits.add(StretchLimit{0.02});
    return Model({9, 6, 0.1, 0.1}, springs, Attach::grommets,
                 Terms()
                     .add(Gravity{})
                     .add(AirDrag{0.01})
                     .add(Friction{0.005})
                     .add(Wind{{3.0, 0.5, 1.0}, {1.0, 0.5, 1.0}, 0.5, true, 3}),
                 limits);
}
const auto springs_of = all_springs(0.01, 200.0, 100.0, 0.05);

}  // namespace

TEMPLATE_LIST_TEST_CASE("Looking at a run does not alter it", "[physics]", AllCases) {
    using Tested = Sheet<typename TestType::Real, typename TestType::Method>;
    for (const auto& springs : springs_of) {
        const Model model = cloth(springs);
        Tested left_alone(model), looked_at(model);
        left_alone.advance(1e-3, 50);
        for (int n = 0; n < 50; ++n) {
            looked_at.advance(1e-3, 1);
            looked_at.stepper.state(looked_at.time());
            looked_at.measure();
            looked_at.checkpoint();
        }
        CHECK(same_bits(left_alone, looked_at));
    }
}

TEMPLATE_LIST_TEST_CASE("Steps taken one by one or in batches have the same bits", "[physics]", AllCases) {
    using Tested = Sheet<typename TestType::Real, typename TestType::Method>;
    const Model model = cloth(springs_of[3], true);
    Tested batch(model), single(model);
    batch.advance(1e-3, 60);
    for (int n = 0; n < 20; ++n) single.advance(1e-3, 1), single.advance(1e-3, 2);
    CHECK(same_bits(batch, single));
}

TEMPLATE_LIST_TEST_CASE("A checkpoint goes on to the same bits", "[physics]", AllCases) {
    using Tested = Sheet<typename TestType::Real, typename TestType::Method>;
    for (const auto& springs : springs_of)
        for (const bool limited : {false, true})
            for (const int saved_at : {0, 1, 7}) {
                const Model model = cloth(springs, limited);
                Tested sheet(model), other(model, scattered(model.grid, 0.01), noise(masses_of(model), 1.0));
                sheet.advance(1e-3, saved_at);
                const auto saved = sheet.checkpoint();
                sheet.advance(1e-3, 20);
                const auto end = sheet.checkpoint();

                // In the same run
                sheet.stepper.restore(saved);
                sheet.stepper.advance(sheet.clock, saved_at, saved_at + 20);
                const auto again = sheet.checkpoint();
                // In another that was somewhere else, at another step
                other.advance(5e-4, 3);
                other.stepper.restore(saved);
                other.stepper.advance(sheet.clock, saved_at, saved_at + 20);
                const auto elsewhere = other.checkpoint();
                bool same = true;
                for (std::size_t f = 0; f < end.fields.size(); ++f)
                    same = same && same_bits(end.fields[f], again.fields[f]) &&
                           same_bits(end.fields[f], elsewhere.fields[f]);
                CHECK(same);
                CHECK(distance(points_of(saved.fields[0]), points_of(end.fields[0])) > 1e-5);
            }
}

TEMPLATE_LIST_TEST_CASE("The state that was set is the state that is read", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    const Model model = cloth(springs_of[3]);
    const auto x = scattered(model.grid, 0.02);
    auto v = noise(masses_of(model), 1.0);
    for (int n = 0; n < masses_of(model); ++n)
        if (is_held(model, n)) v[n] = glm::dvec3(0.0);
    Sheet<Real, typename TestType::Method> sheet(model, x, v);
    // Rounded to the precision and nothing else
    CHECK(distance(sheet.positions(), x) <= epsilon<Real>);
    CHECK(distance(sheet.velocities(), v) <= 2.0 * epsilon<Real>);
    // Once the method has started too: leapfrog's velocity goes half a kick back, of up to 0.5 ms * 10^4 m/s2, and
    // comes forward again.
    sheet.advance(1e-3, 0);
    CHECK(distance(sheet.velocities(), v) <= 20.0 * epsilon<Real>);
}

TEST_CASE("Leapfrog's synchronised velocity is that of the position's time, to order 2", "[physics]") {
    // The stored one lags by half a step: order 1.
    for (const auto& springs : springs_of) {
        const Model model = cloth(springs);
        const double end = 0.1;
        auto x = scattered(model.grid, 0.0);
        auto v = at_rest(model);
        Reference(model).runge_kutta(x, v, end / 1600, 1600);
        const auto order = [&](auto&& velocity) {
            double errors[2];
            for (int n = 0; n < 2; ++n) {
                Sheet<double, Leapfrog> sheet(model);
                const int steps = 400 << n;
                sheet.advance(end / steps, steps);
                errors[n] = distance(velocity(sheet), v);
            }
            return std::log2(errors[0] / errors[1]);
        };
        CHECK(std::abs(order([](auto& sheet) { return sheet.velocities(); }) - 2.0) < 0.1);
        CHECK(std::abs(order([](auto& sheet) { return sheet.stored_velocities(); }) - 1.0) < 0.1);
    }
}

TEMPLATE_LIST_TEST_CASE("A change of step on the way keeps the order", "[physics]", DoubleCases) {
    // The method starts again from the synchronised state: an error of its own order once, not of the step itself.
    using Method = typename TestType::Method;
    const Model model = cloth(springs_of[3]);
    const double end = 0.1;
    auto x = scattered(model.grid, 0.0);
    auto v = at_rest(model);
    Reference(model).runge_kutta(x, v, end / 3200, 3200);
    std::vector<double> errors;
    const int coarsest = Method::order == 4 ? 200 : 400;
    for (const int n : {coarsest, 2 * coarsest, 4 * coarsest}) {
        Sheet<double, Method> sheet(model);
        for (const int share : {1, 2, 1, 2}) sheet.advance(end / n / share, n / 4 * share);
        errors.push_back(distance(sheet.positions(), x));
        CHECK(sheet.time() == Approx(end).epsilon(1e-12));
    }
    for (int n = 0; n < 2; ++n) {
        const double order = std::log2(errors[n] / errors[n + 1]);
        CHECK(order > Method::order - 0.1);
        CHECK(order < Method::order + 0.1);
    }
}
