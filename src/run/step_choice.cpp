#include "run/step_choice.hpp"

#include "io/error.hpp"
#include "io/text.hpp"
#include "scene/file.hpp"
#include "scene/settings.hpp"

#include "drapeau/precision.hpp"
#include "drapeau/stability.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace drapeau {

double chosen_step(const Scene& scene, const Model& model, bool exact, double lowered) {
    if (scene.time.dt) return exact ? *scene.time.dt : whole_steps_per_batch(*scene.time.dt);
    if (!stable_step(scene.time.method, model).is_none()) {
        const double dt = whole_steps_per_batch(
            with_method(scene.time.method, [&](const auto& method) { return automatic_step(method, model, lowered); }));
        if (lowered == 1.0) check_automatic_step(scene.time.method, dt);
        return dt;
    }
    const double wanted = whole_steps_per_batch(automatic_step(SemiImplicitEuler{}, model));
    throw InputError(
        fmt::format("time.dt = \"auto\": {} has no stable step without drag or friction; for a step of {} "
                    "their sum must exceed {:.3g} N·s/m, or choose semi-implicit-euler",
                    name_of(scene.time.method), quantity(wanted, "s"), damping_needed(model, wanted)));
}

void check_automatic_step(Method method, double dt) {
    constexpr double least = settings::dt_range.lowest;
    if (dt >= least) return;
    throw InputError("time.dt = \"auto\": " + std::string(name_of(method)) + " needs steps of " + quantity(dt, "s") +
                     " for these springs and masses, and " + quantity(least, "s") + " is the least; choose " +
                     (method == method_id<SemiImplicitEuler> ? "" : "semi-implicit-euler, ") +
                     "softer springs, heavier masses, less damping or less bending");
}

std::string limit_of_step(Method method, const Model& model) {
    return with_method(method, [&]<class M>(const M& chosen) {
        const double stable = M::automatic * automatic_share(model) * stable_step(chosen, model).seconds();
        if (stable >= M::coarsest_step)
            return M::coarsest_step == batch_seconds ? std::string("1/60 s")
                                                     : std::string("coarsest step of ") + M::name;
        // What would still limit the step most, were there nothing else.
        std::pair<double, std::string> least{INFINITY, "1/60 s"};
        const auto alone = [&](const Oscillator& o, const char* name) {
            const double seconds = M::stable_step(o).seconds();
            if (seconds < least.first) least = {seconds, name};
        };
        for (const auto& o : model.bounds()) {
            alone({.mass = o.mass, .stiffness = o.stiffness}, "stiffness of the springs");
            alone({.mass = o.mass, .damping = o.damping}, "damping of the springs");
            alone({.mass = o.mass, .on_mass = o.on_mass}, "drag and friction");
            alone({.mass = o.mass, .air = o.air}, "air on faces");
            alone({.mass = o.mass, .bending = o.bending}, "bending stiffness");
            alone({.mass = o.mass, .bending_damping = o.bending_damping}, "bending damping");
        }
        if (added_air_step(model).seconds() < least.first) return std::string("added air");
        return least.second;
    });
}

Precision chosen_precision(const Scene& scene, const Model& model, double dt) {
    if (scene.time.precision == Precision::double_precision) return Precision::double_precision;
    const Grid& grid = model.grid;
    const double size = std::hypot(grid.columns * grid.pitch_x, grid.rows * grid.pitch_y);
    const double honest = smallest_float_step(size, typical_speed(model));
    if (dt >= honest) return Precision::single_precision;
    if (!scene.time.dt) return Precision::double_precision;
    check_float_step(dt, honest, *scene.time.dt);
    return Precision::single_precision;
}

void check_float_step(double dt, double honest, double given) {
    const double smallest = hopeless_float_step * honest;
    if (dt >= smallest) return;
    const bool has_larger = smallest < batch_seconds;
    throw InputError("time.dt = " + quantity(given, "s") + ": in float nothing is left of so slow a motion" +
                     (has_larger ? " at steps below " + quantity(smallest, "s") : "") +
                     "; give time.precision = \"double\"" + (has_larger ? " or larger steps" : ""));
}

}  // namespace drapeau
