// Precision: what float can honour. A position is known to half a unit in its last place, so velocities finer than that
// over one step do not move a mass, or move it too far: the smaller the step, the coarser they are.
#pragma once

#include "drapeau/model.hpp"

#include <algorithm>
#include <cmath>

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// What the air on faces pushes a mass with (m/s2) whose rest place is in column i, in the plane of a flat flag.
inline glm::dvec3 air_at_rest(const Model& model, double time, int i) {
    const auto& wind = model.terms.get<Wind>();
    if (!model.air() || !wind) return glm::dvec3(0.0);
    return model.air()->push_at_rest(model.cell() / model.springs.mass, wind->at(time, model.grid.rest(i, 0)));
}

/// Calls visit(a) with the acceleration (m/s2) that the terms push each mass of the first row with, at forty moments of
/// ten seconds. Returns how often.
template <class Visit>
long long for_each_push(const Model& model, Visit&& visit) {
    constexpr int looks = 40;
    constexpr double interval = 0.25;  // s
    const int width = padded<double>(model.grid.columns);
    Array<double> rates(static_cast<std::size_t>(width));
    std::fill_n(rates.data(), model.grid.columns, model.damping_on_mass(1.0, true) / model.springs.mass);
    FieldBuffer<double> row(model.grid.columns, 1);
    for (int look = 0; look < looks; ++look) {
        row = FieldBuffer<double>(model.grid.columns, 1);
        const PushedRow<double> pushed{model.grid, 0, width, rates.data()};
        const auto a = row.view();
        model.terms.for_each([&](const auto& term) {
            if constexpr (requires { term.accelerate(pushed, 0.0, a); }) term.accelerate(pushed, look * interval, a);
        });
        for (int i = 0; i < model.grid.columns; ++i) visit(row.at(i, 0) + air_at_rest(model, look * interval, i));
    }
    return 1LL * looks * model.grid.columns;
}

/// The root of the mean square of that.
inline double typical_push(const Model& model) {
    double squares = 0.0;
    const auto count = for_each_push(model, [&](const glm::dvec3& a) { squares += a.x * a.x + a.y * a.y + a.z * a.z; });
    return std::sqrt(squares / static_cast<double>(count));
}

/// Whether any of it leaves the plane in which a flat flag begins.
inline bool is_pushed_across(const Model& model) {
    bool across = false;
    for_each_push(model, [&](const glm::dvec3& a) { across = across || a.z != 0.0; });
    return across;
}

/// A speed (m/s) of this model's motion: that of a fall over its own size, or the one at which drag and friction carry
/// the push; a hundredth of the waves' where nothing pushes.
inline double typical_speed(const Model& model) {
    const Grid& grid = model.grid;
    const double size = std::hypot((grid.columns - 1) * grid.pitch_x, (grid.rows - 1) * grid.pitch_y);
    const double push = typical_push(model), rate = model.damping_on_mass(1.0) / model.springs.mass;
    if (push == 0.0)
        return 0.01 * std::max(grid.pitch_x, grid.pitch_y) * std::sqrt(model.springs.stiffness / model.springs.mass);
    const double falling = std::sqrt(push * size);
    return rate > 0.0 ? std::min(falling, push / rate) : falling;
}

/// The finest velocity (m/s) that float resolves in steps of dt (s), masses being up to `reach` (m) from the origin.
/// The law and its measurement: docs/model.md.
inline double float_velocity_unit(double reach, double dt) {
    return 0x1p-24 * reach / dt;
}
/// The smallest step (s) at which it resolves a two-hundredth of a speed (m/s).
inline double smallest_float_step(double reach, double speed) {
    return 200.0 * float_velocity_unit(reach, 1.0) / speed;
}
/// Below this share of it float resolves less than half of that speed: nothing of the motion is left.
inline constexpr double hopeless_float_step = 0.01;

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
