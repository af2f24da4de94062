#include "divergence.hpp"

#include "scene_file.hpp"

#include <cmath>
#include <cstdio>

namespace drapeau {
namespace {

/// The first mass that is not finite, or else the fastest.
std::size_t worst(const Masses& masses) {
    std::size_t at = 0;
    double most = -1.0;
    for (std::size_t n = 0; n < masses.x.size(); ++n) {
        const auto &x = masses.x[n], &v = masses.v[n];
        const double speed = v.x * v.x + v.y * v.y + v.z * v.z;
        if (!std::isfinite(speed) || !std::isfinite(x.x + x.y + x.z)) return n;
        if (speed > most) most = speed, at = n;
    }
    return at;
}

std::string broken_limit(const Physics& physics, const Divergence& d) {
    const std::string method(name_of(physics.method));
    if (d.limit == 0.0) {
        const double dt = largest_step(SemiImplicitEuler{}, physics.rates());
        return method + " has no stable step without drag or friction: use semi-implicit-euler with a step of " +
               in_words(0.9 * dt) + " or less";
    }
    if (d.dt > d.limit)
        return "the step " + in_words(d.dt) + " is above the stability limit " + in_words(d.limit) + " of " + method +
               " for these springs and this damping; a step of " + in_words(d.safe_dt) + " is safe";
    return "the step " + in_words(d.dt) + " is within the stability limit " + in_words(d.limit) +
           ", so not the step but the forces are too large for this precision: lower wind, gravity or stiffness";
}

}  // namespace

EnergyBudget EnergyBudget::with_work_since_kept(const Engine& engine, const Physics& physics, double start,
                                                double now) const {
    const auto dot = [](const glm::dvec3& a, const glm::dvec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
    const auto moved = engine.moved_since_kept();
    const auto wind = physics.wind.wind.velocity(0.5 * (start + now));
    EnergyBudget more = *this;
    more.work_ += std::abs(physics.material.mass * dot(physics.gravity.acceleration, moved));
    more.work_ += std::abs(physics.drag.d * dot(wind, moved));
    return more;
}

std::string in_words(double seconds) {
    const double size = std::abs(seconds);
    const char* unit = size >= 1.0 ? "s" : size >= 1e-3 ? "ms" : size >= 1e-6 ? "us" : "ns";
    const double scale = size >= 1.0 ? 1.0 : size >= 1e-3 ? 1e3 : size >= 1e-6 ? 1e6 : 1e9;
    char text[48];
    std::snprintf(text, sizeof text, "%.3g %s", seconds * scale, unit);
    return text;
}

Divergence explain_divergence(Engine& engine, const Physics& physics, const EnergyBudget& budget, const Clock& clock,
                              long long first, long long last) {
    // What the wind does to masses that fly apart is no energy they may have: each step has the work until then.
    const auto diverged_at = [&](long long step) {
        const auto then = budget.with_work_since_kept(engine, physics, clock.at(first), clock.at(step));
        return has_diverged(engine.energy(), then.could_have());
    };

    // Halve the interval that holds the first bad step: `good` steps are fine (and in `state`), `bad` are not.
    engine.return_to_kept();
    auto state = engine.masses();
    long long good = first, bad = last;
    while (bad - good > 1) {
        const long long middle = good + (bad - good) / 2;
        engine.set(state);
        engine.advance(clock, good, middle);
        if (diverged_at(middle)) {
            bad = middle;
        } else {
            good = middle;
            state = engine.masses();
        }
    }
    engine.set(state);
    engine.advance(clock, good, bad);

    Divergence d;
    const auto place = worst(engine.masses());
    d.step = bad;
    d.time = clock.at(bad);
    d.column = static_cast<int>(place % static_cast<std::size_t>(physics.grid.columns));
    d.row = static_cast<int>(place / static_cast<std::size_t>(physics.grid.columns));
    d.dt = clock.dt;
    d.limit = physics.largest_step();
    d.safe_dt = 0.9 * d.limit;
    char where[160];
    std::snprintf(where, sizeof where, "diverged at step %lld (t = %.4g s) at column %d, row %d: ", d.step, d.time,
                  d.column, d.row);
    d.message = where + broken_limit(physics, d);
    engine.return_to_kept();
    return d;
}

}  // namespace drapeau
