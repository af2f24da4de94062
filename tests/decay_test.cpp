// Decay: in steady wind the energy with what wind and gravity can still give only falls. Drag is linear and the same
// everywhere, so a steady wind is a potential: E = sum m v^2/2 + springs - sum (m g + d w) . x has
// dE/dt = -sum (d + c_f) v^2 - sum c (dv . e)^2 <= 0. No flag flaps by itself in this model.
#include "catch.hpp"
#include "physics_sheet.hpp"

using namespace drapeau;
using namespace drapeau::testing;

namespace {

template <class Sheet>
double energy_left(Sheet& sheet) {
    const Model& model = sheet.model();
    const auto& gravity = *model.terms.template get<Gravity>();
    const auto& drag = *model.terms.template get<AirDrag>();
    const auto& wind = *model.terms.template get<Wind>();
    double energy = sheet.measure().total();
    for (const auto& x : sheet.positions())
        energy -= dot(model.springs.mass * gravity.acceleration + drag.d * wind.velocity, x);
    return energy;
}

}  // namespace

TEMPLATE_LIST_TEST_CASE("In steady wind the energy never rises", "[physics]", DoubleCases) {
    using Method = typename TestType::Method;
    for (const auto& springs : all_springs(0.01, 200.0, 100.0, 0.05))
        for (const Attach attach : {Attach::hoist, Attach::grommets}) {
            const Model model(spread(5, 4, 0.4, 0.3), springs, attach,
                              Terms().add(Gravity{}).add(AirDrag{0.02}).add(Wind{.velocity = {5.0, 1.0, 2.0}}));
            // Small steps: the energy of a state swings by dt v.F/2 or less about the shadow energy that does fall, far
            // below what drag takes in a hundredth of a second; and forward Euler falls while
            // dt max(8k, 4k + 8kd) < d.
            // Implicit Euler's own falls at any step.
            const double dt = std::is_same_v<Method, ImplicitEuler> ? 1e-4 : 1e-5;
            Sheet<double, Method> sheet(model, scattered(model.grid, 0.01), noise(masses_of(model), 1.0));
            sheet.advance(dt, 1);
            const double first = energy_left(sheet);
            double before = first;
            int risen = 0;
            for (int n = 0; n < 40; ++n) {
                sheet.advance(dt, std::lround(0.01 / dt));
                const double now = energy_left(sheet);
                if (now > before + 1e-13 * std::abs(first)) ++risen;  // 20 masses' worth of rounding
                before = now;
            }
            CHECK(risen == 0);
            CHECK(before < first - 1e-3);
        }
}
