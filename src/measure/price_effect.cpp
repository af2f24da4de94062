#include "measure/price_effect.hpp"

#include "io/error.hpp"
#include "io/text.hpp"
#include "measure/run_cost.hpp"
#include "run/carry_over.hpp"
#include "run/step_choice.hpp"

#include "drapeau/stability.hpp"

#include <cmath>
#include <optional>
#include <utility>

namespace drapeau {

namespace {

constexpr Method accurate = method_id<Rk4>;

bool is_on_same_grid(const Scene& a, const Scene& b) {
    return a.flag.columns == b.flag.columns && a.flag.rows == b.flag.rows;
}

/// One flight and what two others differ by.
Flight sum_of(Flight flight, const Flight& plus, const Flight& minus) {
    const auto shift = [](FieldBuffer<double>& x, const FieldBuffer<double>& a, const FieldBuffer<double>& b) {
        for (int j = 0; j < x.rows(); ++j)
            for (int i = 0; i < x.columns(); ++i) x.set(i, j, x.at(i, j) + (a.at(i, j) - b.at(i, j)));
    };
    for (std::size_t n = 0; n < flight.positions.size(); ++n) {
        shift(flight.positions[n], plus.positions[n], minus.positions[n]);
        flight.readings[n].energy += plus.readings[n].energy - minus.readings[n].energy;
        flight.readings[n].stretch += plus.readings[n].stretch - minus.readings[n].stretch;
    }
    for (std::size_t n = 0; n < flight.tip.size(); ++n) {
        flight.tip[n] += plus.tip[n] - minus.tip[n];
        flight.tip_velocity[n] += plus.tip_velocity[n] - minus.tip_velocity[n];
    }
    return flight;
}

/// Flights of one scene over the ground's stretch.
class Flights {
public:
    Flights(const Scene& scene, const Footing& ground, const std::function<bool()>& may_go_on)
        : scene_(scene),
          ground_(ground),
          model_(model_of(scene)),
          stretch_(stretch_on(scene, ground)),
          yardstick_(model_),
          may_go_on_(may_go_on) {}

    std::optional<Flight> accurately(long long steps) {
        return fly(model_, accurate, steps, stretch_, yardstick_, may_go_on_);
    }

    /// The flight with what rounding to float makes of the scene's own method and step; nothing if that does not hold.
    std::optional<Flight> rounded(Flight flight) {
        const double dt = chosen_step(scene_, model_, false, 1.0);
        if (chosen_precision(scene_, model_, dt) == Precision::double_precision) return flight;
        const auto own = [&](Precision precision) {
            return fly(model_, scene_.time.method, std::llround(batch_seconds / dt), stretch_, yardstick_, may_go_on_,
                       precision);
        };
        const auto in_float = own(Precision::single_precision), in_double = own(Precision::double_precision);
        if (!in_float || !in_double) return {};
        return sum_of(std::move(flight), *in_float, *in_double);
    }

    /// The flight with what the step makes of the scene's own run that no tolerance holds small; nothing if that does
    /// not hold.
    std::optional<Flight> unheld(Flight flight) {
        Scene held = scene_;
        held.time.tolerance = ground_.variant.scene.time.tolerance;
        const auto without = as_programs_run(scene_), with = as_programs_run(held);
        if (!without || !with) return {};
        return sum_of(std::move(flight), *without, *with);
    }

    /// How far it is from another flight, at the masses of the scene as given.
    Apart apart_from(const Flight& truth, const Flight& flight) const {
        if (is_on_same_grid(scene_, ground_.variant.scene)) return apart(ground_.model, flight, truth);
        Comparison comparison(ground_.model, truth);
        State<double> state = flight.end;
        for (std::size_t n = 0; n < flight.positions.size(); ++n) {
            state.position = flight.positions[n];
            comparison.take(carried_over(state, ground_.variant.scene).position, flight.readings[n]);
        }
        return comparison.result();
    }

    /// m, root mean square, as flights at twice and four times the step tell it.
    double error_of(const Flight& fine, long long steps) {
        const auto half = accurately(steps / 2);
        if (!half) return INFINITY;
        const auto quarter = steps % 4 == 0 ? accurately(steps / 4) : std::nullopt;
        const double now = apart(model_, fine, *half).distance();
        const double before = quarter ? apart(model_, *half, *quarter).distance() : INFINITY;
        return now > 0.0 ? error_left(before, now, Rk4::order) : 0.0;
    }

private:
    std::optional<Flight> as_programs_run(const Scene& scene) {
        Simulation simulation = simulation_at(scene, stretch_);
        const Tip tip = tip_of(model_);
        Flight flight;
        for (long long batch = 1; batch <= stretch_.batches; ++batch) {
            if (simulation.advance_batch() || (may_go_on_ && !may_go_on_())) return {};
            State<double> state = simulation.state();
            flight.tip.push_back(state.position.at(tip.column, tip.row));
            flight.tip_velocity.push_back(state.velocity.at(tip.column, tip.row));
            flight.see(stretch_, batch, std::move(state), yardstick_);
        }
        return flight;
    }

    const Scene& scene_;
    const Footing& ground_;
    Model model_;
    Stretch stretch_;
    Yardstick yardstick_;
    const std::function<bool()>& may_go_on_;
};

}  // namespace

Stretch stretch_on(const Scene& scene, const Footing& ground) {
    Stretch stretch = ground.stretch;
    if (!is_on_same_grid(scene, ground.variant.scene)) stretch.start = carried_over(ground.stretch.start, scene);
    return stretch;
}

Effect effect_of(const Scene& scene, const Footing& ground, bool only_statistics,
                 const std::function<bool()>& may_go_on) {
    Effect effect;
    const long long steps = ground.reference.rk4_steps;
    const auto fail = [&](const std::string& why) {
        effect.remark = may_go_on() ? why : "there is no time left for it in --budget";
        return effect;
    };
    try {
        Flights flights(scene, ground, may_go_on);
        auto flight = flights.accurately(steps);
        if (!flight)
            return fail("without it the motion does not hold at rk4's step of " +
                        quantity(batch_seconds / static_cast<double>(steps), "s"));
        const double error = only_statistics ? NAN : flights.error_of(*flight, steps);
        const bool is_rounded = scene.time.precision != ground.variant.scene.time.precision;
        if (is_rounded) flight = flights.rounded(std::move(*flight));
        if (!flight) return fail("in float the motion does not hold at the scene's own step");
        const bool is_unheld = scene.time.tolerance != ground.variant.scene.time.tolerance;
        if (is_unheld) flight = flights.unheld(std::move(*flight));
        if (!flight) return fail("without the tolerance the motion does not hold at the automatic step");
        effect.apart = flights.apart_from(ground.reference.by_rk4, *flight);
        effect.known_to = ground.reference.error() + error;
        effect.tip = statistics_of(flight->tip, flight->tip_velocity, batch_seconds);
        effect.is_measured = may_go_on();
        if (!effect.is_measured) return fail("");
    } catch (const InputError& refused) {
        return fail(refused.what());
    }
    return effect;
}

}  // namespace drapeau
