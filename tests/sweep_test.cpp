// Sweep: one pass over the rows gives what looking at every pair of masses gives, for any size, precision and register,
// and the same bits however the pass is cut up.
#include "catch.hpp"
#include "physics_reference.hpp"
#include "physics_sheet.hpp"

#include "drapeau/team.hpp"

namespace drapeau::testing {

template class Sheet<float, ForwardEuler>;
template class Sheet<float, SemiImplicitEuler>;
template class Sheet<double, ForwardEuler>;
template class Sheet<double, SemiImplicitEuler>;

}  // namespace drapeau::testing

using namespace drapeau;
using namespace drapeau::testing;

namespace {

const std::pair<int, int> many_sizes[] = {{1, 2},  {2, 1},  {1, 40}, {40, 1}, {2, 2},  {3, 3},  {5, 7},
                                          {7, 5},  {8, 9},  {9, 8},  {15, 4}, {16, 5}, {17, 6}, {31, 3},
                                          {32, 2}, {33, 9}, {2, 33}, {3, 17}, {40, 39}};

Setting sheet_of(const std::pair<int, int>& size, const Material& material) {
    return {.grid = {size.first, size.second, 0.1, 0.08}, .attach = Attach::corner, .material = material};
}
const auto materials = all_materials(0.01, 200.0, 100.0, 0.05);

/// A setting with every force, so that a step's every number is in play.
Setting in_the_wind(const std::pair<int, int>& size, const Material& material) {
    Setting s = sheet_of(size, material);
    s.gravity = {0.3, -9.81, 0.1};
    s.drag = 0.02;
    s.wind = {{3.0, 0.5, 1.0}, {1.0, 0.5, 1.0}, 0.01, 3};
    return s;
}

/// Lane types to run the sweep on: one mass at a time, and registers of 16, 32 and 64 bytes.
template <class Real, class Visit>
void for_each_lane_type(Visit&& visit) {
    visit.template operator()<Real>();
    visit.template operator()<Vector<Real, 16>>();
    visit.template operator()<Vector<Real, 32>>();
    visit.template operator()<Vector<Real, 64>>();
}

/// The forces of the setting's springs by a sweep in registers V.
template <class V>
Points swept_forces(Sheet<typename Lanes<V>::Real, SemiImplicitEuler>& sheet) {
    using Real = typename Lanes<V>::Real;
    Cloth<Real> force(sheet.setting.grid);
    sheet.composed([&](auto pair, auto diagonals) {
        spring_forces<V, decltype(pair), decltype(diagonals)::value>(
            sheet.cloth.view(), sheet.fabric.view(),
            ForceRow<Real>{force.component(0).data(), force.component(1).data(), force.component(2).data()},
            sheet.buffers[0]);
    });
    Points f;
    for (int j = 0; j < sheet.setting.grid.rows; ++j)
        for (int i = 0; i < sheet.setting.grid.columns; ++i) f.push_back(force.position(i, j));
    return f;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("The sweep sums every spring's force on every mass", "[physics]", Precisions) {
    for (const auto& size : many_sizes)
        for (const auto& material : materials) {
            const Setting s = sheet_of(size, material);
            Sheet<TestType, SemiImplicitEuler> sheet(s, scattered(s.grid, 0.05), noise(s.masses(), 2.0));
            std::vector<double> met;
            // The reference gets the very numbers that the cloth holds, so only the arithmetic differs.
            const auto exact = Reference(s).forces(sheet.positions(), sheet.velocities(), &met);
            for_each_lane_type<TestType>([&]<class V>() {
                const auto f = swept_forces<V>(sheet);
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

TEMPLATE_LIST_TEST_CASE("Padding feels nothing and keeps still", "[physics]", Precisions) {
    for (const auto& size : many_sizes) {
        const Setting s = in_the_wind(size, materials[3]);
        Sheet<TestType, SemiImplicitEuler> sheet(s, scattered(s.grid, 0.02), noise(s.masses(), 1.0));
        sheet.advance(1e-4, 16);
        bool still = true;
        for (int c = 0; c < 6; ++c)
            for (int j = 0; j < size.second; ++j)
                for (int i = size.first; i < sheet.cloth.stride(); ++i)
                    still =
                        still && sheet.cloth.component(c)[static_cast<std::size_t>(j) * sheet.cloth.stride() + i] == 0;
        CHECK(still);
    }
}

TEMPLATE_LIST_TEST_CASE("Any number of threads gives the same bits", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    using Tested = Sheet<Real, typename TestType::Method>;
    for (const auto& size : {std::pair{5, 2}, {5, 3}, {17, 7}, {33, 12}, {4, 41}, {1, 9}})
        for (const auto& material : materials) {
            const Setting s = in_the_wind(size, material);
            const auto x = scattered(s.grid, 0.02), v = noise(s.masses(), 1.0);
            const int steps = 21;
            const Real dt = static_cast<Real>(1e-4);
            Tested alone(s, x, v);
            alone.advance(1e-4, steps);
            for (const int threads : {1, 2, 3, 5}) {
                Tested shared(s, x, v);
                Team<Real> team(threads, shared.cloth);
                const auto rows = shared.cloth.view();
                const auto fabric = shared.fabric.view();
                shared.composed([&](auto pair, auto diagonals) {
                    team.advance(rows, steps,
                                 [&](int first, int last, const Row<Real>* above, const Row<Real>* below, int step,
                                     SweepBuffers<Real>& buffers) {
                                     advance_rows<Vector<Real>, decltype(pair), decltype(diagonals)::value,
                                                  typename TestType::Method>(rows, first, last, above, below, fabric,
                                                                             shared.uniform_at(step * 1e-4), dt,
                                                                             buffers);
                                 });
                });
                CHECK(same_bits(alone.cloth, shared.cloth));
            }
        }
}

TEMPLATE_LIST_TEST_CASE("Blocks of rows with copies at the seams have the bits of the whole", "[physics]", AllCases) {
    using Real = typename TestType::Real;
    using Tested = Sheet<Real, typename TestType::Method>;
    const int steps = 5;
    const Real dt = static_cast<Real>(1e-4);
    for (const auto& material : materials)
        for (int seam = 1; seam < 7; ++seam) {
            const Setting s = in_the_wind({17, 7}, material);
            const auto x = scattered(s.grid, 0.02), v = noise(s.masses(), 1.0);
            Tested whole(s, x, v), cut(s, x, v), before(s, x, v);
            whole.advance(1e-4, steps);
            for (int n = 0; n < steps; ++n) {
                // Rows above the seam first, then those below it, against the row above as it was before the step.
                before.set(cut.positions(), cut.velocities());
                const auto rows = cut.cloth.view();
                const Row<Real> above = before.cloth.view()[seam - 1], below = before.cloth.view()[seam];
                const auto uniform = cut.uniform_at(n * 1e-4);
                cut.composed([&](auto pair, auto diagonals) {
                    constexpr bool has_diagonals = decltype(diagonals)::value;
                    using Pair = decltype(pair);
                    using Method = typename TestType::Method;
                    const Row<Real>* const none = nullptr;
                    advance_rows<Vector<Real>, Pair, has_diagonals, Method>(
                        rows, 0, seam, none, &below, cut.fabric.view(), uniform, dt, cut.buffers[0]);
                    advance_rows<Vector<Real>, Pair, has_diagonals, Method>(
                        rows, seam, 7, &above, none, cut.fabric.view(), uniform, dt, cut.buffers[1]);
                });
            }
            CHECK(same_bits(whole.cloth, cut.cloth));
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
    for (const auto& material : materials) {
        const Setting s = sheet_of({9, 5}, material);
        // All in one place, far from the origin too
        for (const glm::dvec3& place : {glm::dvec3{0.0}, glm::dvec3{1.0, -2.0, 3.0}}) {
            Sheet<TestType, SemiImplicitEuler> sheet(s, Points(45, place), noise(45, 1.0));
            for_each_lane_type<TestType>([&]<class V>() {
                for (const auto& f : swept_forces<V>(sheet)) CHECK(f == glm::dvec3(0.0));
            });
            sheet.advance(1e-4, 50);
            CHECK(distance(sheet.positions(), Points(45, place)) < 1.0);  // false for NaN
        }
        // Two of them in one place: the others' springs still pull
        auto x = scattered(s.grid, 0.02);
        x[21] = x[22] = x[30];
        Sheet<TestType, SemiImplicitEuler> sheet(s, x, noise(45, 1.0));
        std::vector<double> met;
        const auto exact = Reference(s).forces(sheet.positions(), sheet.velocities(), &met);
        const auto f = sheet.forces();
        for (int n = 0; n < 45; ++n) CHECK(length(f[n] - exact[n]) < 8.0 * epsilon<TestType> * met[n]);
    }
}
