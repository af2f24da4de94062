#include "legend.hpp"

#include <fmt/format.h>

namespace drapeau {

namespace {

std::string newtons(double force) {
    return fmt::format("{:.6g} N", force);
}

std::string per_cent(double share) {
    return fmt::format("{:.6g} %", 100.0 * share);
}

std::string speed(double metres_per_second) {
    return fmt::format("{:.6g} m/s", metres_per_second);
}

/// A single row or column of masses has no cloth.
bool shows_cloth(const AppState& app) {
    return app.scene.view.cloth && app.status.columns > 1 && app.status.rows > 1;
}

}  // namespace

std::string Legend::text() const {
    return title + ": " + labels[0] + ", " + labels[1] + ", " + labels[2] + "; " + range();
}

double force_end(const AppState& app) {
    return app.scene.view.force_range.value_or(app.status.force_scale);
}

double stretch_end(const AppState& app) {
    return app.scene.view.stretch_range.value_or(app.status.stretch_scale);
}

double speed_end(const AppState& app) {
    return app.scene.view.velocity_range.value_or(app.status.speed_scale);
}

std::vector<Legend> legends(const AppState& app) {
    const ViewSettings& view = app.scene.view;
    std::vector<Legend> shown;
    if (view.stretch && shows_cloth(app)) {
        const double end = stretch_end(app);
        shown.push_back({.title = "Stretch of the cloth, (l - L) / L",
                         .short_title = "Stretch",
                         .labels = {per_cent(-end), "0 %", "+" + per_cent(end)},
                         .fixed = view.stretch_range.has_value(),
                         .colours = &stretch_colours(view.colours)});
    }
    if (view.forces) {
        const double end = force_end(app);
        shown.push_back({.title = "Force of a spring, |k (l - L)|",
                         .short_title = "Spring force",
                         .labels = {"0 N", newtons(end / 2.0), newtons(end)},
                         .fixed = view.force_range.has_value(),
                         .colours = &force_colours(view.colours)});
    }
    if (view.velocities) {
        const double end = speed_end(app);
        shown.push_back({.title = "Velocity of masses, as length",
                         .short_title = "Velocity",
                         .labels = {"0 m/s", speed(end / 2.0), speed(end)},
                         .fixed = view.velocity_range.has_value()});
    }
    return shown;
}

}  // namespace drapeau
