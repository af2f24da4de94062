#include "plan.hpp"

#include "io/error.hpp"
#include "io/text.hpp"
#include "run/step_choice.hpp"
#include "scene/file.hpp"

#include <algorithm>
#include <cmath>

namespace drapeau::lab {

namespace {

constexpr double longest_run = 24.0 * 3600.0;  // s

/// How many times `step` fits `seconds`, if that is a whole number but for the rounding of decimal input.
std::optional<long long> whole_count(double seconds, double step) {
    const double count = seconds / step;
    const double tolerance = std::min(1e-3, 1e-12 * count);
    if (std::abs(count - std::round(count)) > tolerance) return std::nullopt;
    return std::llround(count);
}

/// A number a person may type, free of the rounding of the last binary digits.
std::string decimal(double value) {
    return shortest(number_in(rounded(value, 12)).value_or(value));
}

}  // namespace

Plan plan_for(const Scene& scene, double seconds, const std::string& given_seconds) {
    if (const auto dt = scene.time.dt) {
        if (const auto steps = whole_count(seconds, *dt)) return {0, *steps, dt};
        const double below = std::floor(seconds / *dt);
        throw InputError("--seconds = " + one_line(given_seconds, 60) + ": a whole number of steps of " +
                         shortest(*dt) + " s is allowed, such as " + decimal(below * *dt) + " or " +
                         decimal((below + 1.0) * *dt));
    }
    if (const auto batches = whole_count(seconds, batch_seconds)) return {*batches, 0, {}};
    if (scene.time.tolerance)
        throw InputError("--seconds = " + one_line(given_seconds, 60) +
                         ": with time.tolerance a whole number of sixtieths of a second is allowed, such as " +
                         decimal(std::ceil(seconds / batch_seconds) * batch_seconds));
    // Equal steps, none longer than the automatic one.
    Scene flat = scene;  // how it starts takes time and does not matter for the step
    flat.flag.start = Start::flat;
    const Simulation automatic(flat);
    const double steps = std::ceil(seconds / automatic.dt()), dt = seconds / steps;
    check_automatic_step(scene.time.method, dt);
    return {0, std::llround(std::min(steps, 9e18)), dt, automatic.precision(), automatic.precision_remark()};
}

void check_duration(const Scene& scene, const Simulation& simulation, double seconds) {
    constexpr double mass_steps_a_second = 1.5e8;  // of one core; small flags are slower by the mass
    constexpr double steps_a_second = 2e6;
    const double steps = seconds / simulation.dt();
    const int passes = with_method(scene.time.method, [](const auto& m) { return std::decay_t<decltype(m)>::passes; });
    const double masses = static_cast<double>(simulation.model().grid.masses());
    const double estimate = steps * passes * std::max(masses / mass_steps_a_second, 1.0 / steps_a_second);
    if (estimate <= longest_run) return;
    throw InputError("--seconds = " + shortest(seconds) + ": about " + rounded(estimate / 3600.0, 2) + " h for " +
                     rounded(steps, 3) + " steps of " + quantity(simulation.dt(), "s") + " and " + rounded(masses, 3) +
                     " masses, more than " + rounded(longest_run / 3600.0, 2) + " h; --force runs it");
}

void check_pace(double share_done, double wall) {
    constexpr double known_after = 3.0, minute = 60.0;  // s
    if (wall < known_after || wall > minute || wall / share_done <= longest_run) return;
    throw InputError("this run would take about " + rounded(wall / share_done / 3600.0, 2) + " h, more than " +
                     rounded(longest_run / 3600.0, 2) + " h; --force runs it");
}

}  // namespace drapeau::lab
