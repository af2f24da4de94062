// Threads: any number of them gives the same bits: motion, sums and reports. Run these with the thread sanitizer too.
#include "catch.hpp"
#include "physics_sheet.hpp"
#include "sanitized.hpp"

using namespace drapeau;
using namespace drapeau::testing;

namespace {

constexpr double dt = 1e-4;
/// A step that solves is many sweeps, between which threads meet.
template <class Method>
constexpr int steps_of = sanitized        ? 3
                         : Method::solves ? 4
                                          : 13;

/// Every force, travelling gusts that differ from row to row, and a limit that has work to do.
Model storm(const Grid& grid, const Springs& springs, bool travelling, bool limited) {
    Limits limits;
    if (limited) limits.add(StretchLimit{0.05}).add(Ground{-0.15, 0.3}).add(Pole{0.02, 0.3});
    return Model(grid, springs, Attach::corner,
                 Terms()
                     .add(Gravity{{0.3, -9.81, 0.1}})
                     .add(AirDrag{0.02})
                     .add(Friction{0.01})
                     .add(Wind{{3.0, 0.5, 1.0}, {1.0, 0.5, 1.0}, 0.01, travelling, 3}),
                 limits);
}

bool same(const Measurement& a, const Measurement& b) {
    return a.kinetic == b.kinetic && a.elastic == b.elastic && a.max_stretch == b.max_stretch &&
           a.mean_stretch == b.mean_stretch && a.max_force == b.max_force && a.rms_force == b.rms_force &&
           a.power == b.power && a.moment == b.moment;
}
bool same(const Report& a, const Report& b) {
    return a.work.external == b.work.external && a.work.damping == b.work.damping && a.work.passes == b.work.passes &&
           a.limit.sweeps == b.limit.sweeps && a.limit.max_stretch == b.limit.max_stretch && a.limit.met == b.limit.met;
}

/// Checks that a model's steps and readings have the same bits whoever shares them. Returns what one thread reports.
template <class Case>
Report check_threads(const Model& model) {
    using Tested = Sheet<typename Case::Real, typename Case::Method>;
    constexpr int steps = steps_of<typename Case::Method>;
    // A spring is up to a third longer than at rest.
    const auto x = scattered(model.grid, 0.015), v = noise(masses_of(model), 1.0);
    Tested alone(model, x, v);
    const Report report = alone.advance(dt, steps, steps / 2);
    const Measurement measured = alone.measure();
    const double air_rate = alone.stepper.air_rate(alone.time());
    CHECK((air_rate > 0.0) == (model.air() != nullptr));
    for (const int threads : {1, 2, 3, 5}) {
        if (sanitized && threads != 2 && threads != 5) continue;
        Tested shared(model, x, v);
        shared.stepper.use_threads(threads);
        CHECK(same(shared.advance(dt, steps, steps / 2), report));
        CHECK(same_bits(alone, shared));
        CHECK(same(shared.measure(), measured));
        CHECK(shared.stepper.air_rate(shared.time()) == air_rate);
    }
    return report;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("Any number of threads gives the same bits", "[physics][threads]", AllCases) {
    for (const auto& [columns, rows] : {std::pair{5, 2}, {5, 3}, {17, 7}, {33, 12}, {4, 41}, {1, 9}})
        for (const auto& springs : all_springs(0.01, 200.0, 100.0, 0.05))
            for (const auto& [travelling, limited] : {std::pair{false, false}, {true, false}, {true, true}}) {
                const Report report =
                    check_threads<TestType>(storm({columns, rows, 0.1, 0.08}, springs, travelling, limited));
                CHECK((!limited || report.limit.sweeps > 0));
            }
}

TEMPLATE_LIST_TEST_CASE("Any number of threads gives the same bits with air on faces", "[physics][threads]", AllCases) {
    for (const auto& [columns, rows] : {std::pair{5, 2}, {17, 7}, {33, 12}, {4, 41}})
        for (const std::optional<double> damping : {std::optional<double>(), std::optional(0.05)})
            for (const auto& [travelling, limited] : {std::pair{false, false}, {true, true}}) {
                Model model = storm({columns, rows, 0.1, 0.08}, {0.01, 200.0, 100.0, damping}, travelling, limited);
                model.terms.add(Air{});
                check_threads<TestType>(model);
            }
}

TEMPLATE_LIST_TEST_CASE("Any number of threads gives the same bits with bending, which looks two rows away",
                        "[physics][threads]", AllCases) {
    for (const auto& [columns, rows] : {std::pair{5, 4}, {17, 7}, {4, 41}})
        for (const auto& [travelling, with_air, limited] :
             {std::tuple{false, false, false}, {true, false, true}, {true, true, false}}) {
            Model model = storm({columns, rows, 0.1, 0.08}, {0.01, 200.0, 100.0, {}}, travelling, limited);
            model.terms.add(Bending{.stiffness = 0.02, .damping = 50.0});
            if (with_air) model.terms.add(Air{});
            check_threads<TestType>(model);
        }
}

TEMPLATE_LIST_TEST_CASE("The number of threads may change on the way", "[physics][threads]", AllCases) {
    using Tested = Sheet<typename TestType::Real, typename TestType::Method>;
    constexpr int steps = steps_of<typename TestType::Method>;
    const Model model = storm({17, 12, 0.1, 0.08}, {0.01, 200.0, 100.0, 0.05}, true, false);
    const auto x = scattered(model.grid, 0.02), v = noise(masses_of(model), 1.0);
    Tested alone(model, x, v), changing(model, x, v);
    for (const int threads : {3, 1, 5, 2, 100}) {
        changing.stepper.use_threads(threads);
        CHECK(changing.stepper.threads() <= 6);  // two rows each at least
        alone.advance(dt, steps), changing.advance(dt, steps);
        CHECK(same_bits(alone, changing));
        CHECK(points_of(alone.stepper.state(alone.time()).velocity) ==
              points_of(changing.stepper.state(changing.time()).velocity));
    }
}
