// Sweep: one pass over the rows gives what looking at every pair of masses gives, for any size, precision and register,
// and the same bits however the pass is cut up.
#include "catch.hpp"
#include "physics_reference.hpp"
#include "physics_sheet.hpp"

using namespace drapeau;
using namespace drapeau::testing;

namespace {

const std::pair<int, int> many_sizes[] = {{1, 2},  {2, 1},  {1, 40}, {40, 1}, {2, 2},  {3, 3},  {5, 7},
                                          {7, 5},  {8, 9},  {9, 8},  {15, 4}, {16, 5}, {17, 6}, {31, 3},
                                          {32, 2}, {33, 9}, {2, 33}, {3, 17}, {40, 39}};

const auto springs_of = all_springs(0.01, 200.0, 100.0, 0.05);

Grid grid_of(const std::pair<int, int>& size) {
    return {size.first, size.second, 0.1, 0.08};
}

/// Every force, so that a step's every number is in play.
Model in_the_wind(const Grid& grid, const Springs& springs) {
    return Model(grid, springs, Attach::corner,
                 Terms()
                     .add(Gravity{{0.3, -9.81, 0.1}})
                     .add(AirDrag{0.02})
                     .add(Friction{0.01})
                     .add(Wind{{3.0, 0.5, 1.0}, {1.0, 0.5, 1.0}, 0.01, true, 3}));
}

/// Lane types to run the sweep on: one mass at a time, and registers of 16, 32 and 64 bytes.
template <class Real, class Visit>
void for_each_lane_type(Visit&& visit) {
    visit.template operator()<Real>();
    visit.template operator()<Vector<Real, 16>>();
    visit.template operator()<Vector<Real, 32>>();
    visit.template operator()<Vector<Real, 64>>();
}

template <class V>
void evaluate(const Model& model, const Pass<typename Lanes<V>::Real>& pass) {
    if (model.is_damped())
        model.has_diagonals() ? evaluate_rows<V, SemiImplicitEuler, true, true>(pass)
                              : evaluate_rows<V, SemiImplicitEuler, true, false>(pass);
    else
        model.has_diagonals() ? evaluate_rows<V, SemiImplicitEuler, false, true>(pass)
                              : evaluate_rows<V, SemiImplicitEuler, false, false>(pass);
}

/// Masses at x that move with v, in the precision of Real.
template <class Real>
Rows<Real> rows_at(const Model& model, const Points& x, const Points& v) {
    std::vector<FieldBuffer<Real>> fields(2, FieldBuffer<Real>(model.grid.columns, model.grid.rows));
    set_points(fields[0], x), set_points(fields[1], v);
    return {model, fields};
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("The sweep sums every spring's force on every mass", "[physics]", Precisions) {
    for (const auto& size : many_sizes)
        for (Springs springs : springs_of) {
            springs.mass = 1.0;  // kg: accelerations are forces
            const Model model(grid_of(size), springs, Attach::none);
            auto rows = rows_at<TestType>(model, scattered(model.grid, 0.05), noise(masses_of(model), 2.0));
            std::vector<double> met;
            // The reference gets the very numbers that the fields hold, so only the arithmetic differs.
            const auto exact = Reference(model).forces(points_of(rows.fields[0]), points_of(rows.fields[1]), &met);
            for_each_lane_type<TestType>([&]<class V>() {
                evaluate<V>(model, rows.whole());
                const auto f = points_of(rows.out);
                double worst = 0.0;
                for (std::size_t n = 0; n < f.size(); ++n) {
                    const double off = length(f[n] - exact[n]) / (epsilon<TestType> * met[n]);
                    worst = std::isnan(off) ? off : std::max(worst, off);
                }
                // In units of eps (k l + k L + c |dv|) summed over a mass's springs. Differences of positions are
                // rounded by eps/2 each and 1/l by 2 eps or so; products, sums and k, kL, c as stored add some more
                // halves: below 8 in all.
                CHECK(worst < 8.0);
            });
        }
}

TEMPLATE_LIST_TEST_CASE("Padding feels nothing and keeps still", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    for (const auto& size : many_sizes) {
        const Model model = in_the_wind(grid_of(size), springs_of[3]);
        Sheet<Real, typename TestType::Method> sheet(model, scattered(model.grid, 0.02), noise(masses_of(model), 1.0));
        sheet.advance(1e-4, 16);
        const auto now = sheet.checkpoint();
        // Positions and velocities; what a method keeps may be anything there, as nobody reads it.
        for (int f = 0; f < 2; ++f) {
            const auto& field = now.fields[f];
            bool still = true;
            for (int c = 0; c < 3; ++c)
                for (int j = 0; j < size.second; ++j)
                    for (int i = size.first; i < field.stride(); ++i)
                        still = still && field.component(c)[static_cast<std::size_t>(j) * field.stride() + i] == 0;
            CHECK(still);
        }
    }
}

TEMPLATE_LIST_TEST_CASE("Blocks of rows with halos of any depth have the bits of the whole", "[physics]", SweptCases) {
    using Real = typename TestType::Real;
    using Method = typename TestType::Method;
    constexpr int steps = 4, rows = 7;
    const Clock clock{0.0, 0, 1e-4};
    for (const auto& springs : springs_of)
        for (const int halo : {1, 2, 3})
            for (int border = halo; border <= rows - halo; ++border) {
                const Model model = in_the_wind({17, rows, 0.1, 0.08}, springs);
                Sheet<Real, Method> whole(model, scattered(model.grid, 0.02), noise(masses_of(model), 1.0));
                whole.advance(clock.dt, 1);  // the method has started
                Rows<Real> cut(model, whole.checkpoint().fields);
                whole.advance(clock.dt, steps - 1);

                const auto kernels = kernels_for<Vector<Real>, Method>(model);
                for (int step = 1; step < steps; ++step)
                    for (int n = 0; n < kernels.passes; ++n) {
                        // The rows on either side of the border as they are before the pass
                        auto above = cut.fields, below = cut.fields;
                        const double t = clock.at(step) + kernels.stage_time[n] * clock.dt;
                        auto upper = cut.pass(0, border, clock.dt, t), lower = cut.pass(border, rows, clock.dt, t);
                        upper.halo = lower.halo = halo;
                        for (int f = 0; f < kernels.fields; ++f) {
                            upper.below[f] = below[f].view().row(border);
                            lower.above[f] = above[f].view().row(border - halo);
                        }
                        kernels.advance[n](upper);
                        kernels.advance[n](lower);
                    }
                const auto expected = whole.checkpoint();
                bool same = true;
                for (int f = 0; f < kernels.fields; ++f) same = same && same_bits(cut.fields[f], expected.fields[f]);
                CHECK(same);
            }
}

TEMPLATE_LIST_TEST_CASE("1/sqrt is right to a few units in the last place wherever a spring may be", "[physics]",
                        Precisions) {
    using V = Vector<TestType, 16>;
    // Squares of lengths: from below the floor (1e-30 m^2) to as far as s y^2 and a force can be told from infinity.
    const int least = std::is_same_v<TestType, float> ? -125 : -1021,
              most = std::is_same_v<TestType, float> ? 126 : 1022;
    double worst = 0.0;
    for (int exponent = least; exponent <= most; ++exponent)
        for (int n = 0; n < 64; ++n) {
            const auto s = static_cast<TestType>(std::ldexp(1.5 + 0.5 * random_at(9, exponent + 2000, n), exponent));
            const long double exact = 1.0L / std::sqrt(static_cast<long double>(s));
            const double ulp =
                std::nextafter(static_cast<TestType>(exact), TestType(INFINITY)) - static_cast<TestType>(exact);
            for (const TestType y : {inverse_sqrt(s), inverse_sqrt(Lanes<V>::broadcast(s))[0]}) {
                const double off = static_cast<double>(std::abs(y - exact)) / ulp;
                worst = std::isnan(off) ? off : std::max(worst, off);
            }
        }
    CHECK(worst < 4.0);
}

TEMPLATE_LIST_TEST_CASE("Masses on top of each other pull each other nowhere", "[physics]", Precisions) {
    for (Springs springs : springs_of) {
        springs.mass = 1.0;  // kg: accelerations are forces
        const Model model({9, 5, 0.1, 0.08}, springs, Attach::none);
        // All in one place, far from the origin too
        for (const glm::dvec3& place : {glm::dvec3{0.0}, glm::dvec3{1.0, -2.0, 3.0}}) {
            auto rows = rows_at<TestType>(model, Points(45, place), noise(45, 1.0));
            for_each_lane_type<TestType>([&]<class V>() {
                evaluate<V>(model, rows.whole());
                for (const auto& f : points_of(rows.out)) CHECK(f == glm::dvec3(0.0));
            });
        }
        // Two of them in one place: the others' springs still pull
        auto x = scattered(model.grid, 0.02);
        x[21] = x[22] = x[30];
        auto rows = rows_at<TestType>(model, x, noise(45, 1.0));
        std::vector<double> met;
        const auto exact = Reference(model).forces(points_of(rows.fields[0]), points_of(rows.fields[1]), &met);
        evaluate<Vector<TestType>>(model, rows.whole());
        const auto f = points_of(rows.out);
        for (int n = 0; n < 45; ++n) CHECK(length(f[n] - exact[n]) < 8.0 * epsilon<TestType> * met[n]);
    }
}

TEMPLATE_LIST_TEST_CASE("Every method moves masses that are on top of each other to finite places", "[physics]",
                        AllCases) {
    for (const auto& springs : springs_of) {
        const Model model({9, 5, 0.1, 0.08}, springs, Attach::corner);
        const Points here(45, glm::dvec3{1.0, -2.0, 3.0});
        Sheet<typename TestType::Real, typename TestType::Method> sheet(model, here, noise(45, 1.0));
        sheet.advance(1e-4, 50);
        CHECK(distance(sheet.positions(), here) < 1.0);  // false for NaN
    }
}
