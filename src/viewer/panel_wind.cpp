// The page on the wind: its mean as strength and direction, its gusts on each axis.
#include "panels.hpp"

#include <imgui.h>

#include <glm/trigonometric.hpp>

#include <cmath>

namespace drapeau {

namespace {

double direction_of(const glm::dvec3& v, double otherwise) {
    return v.x == 0.0 && v.z == 0.0 ? otherwise : glm::degrees(std::atan2(v.z, v.x));
}

glm::dvec3 blowing(double speed, double degrees, double up) {
    const double angle = glm::radians(degrees);
    return {speed * std::cos(angle), up, speed * std::sin(angle)};
}

void edit_mean(Wind& wind, const Wind& origin, PanelMemory& memory, Widgets& widgets) {
    glm::dvec3& v = wind.velocity;
    double speed = std::hypot(v.x, v.z);
    double direction = memory.wind_direction = direction_of(v, memory.wind_direction);
    bool changed = widgets.slider("Wind speed", speed, {.low = 0.0, .high = 40.0, .format = "%.1f m/s"},
                                  std::hypot(origin.velocity.x, origin.velocity.z),
                                  "Horizontal mean. Faster wind lifts the flag and stretches its springs more.");
    changed |= widgets.slider("Direction", direction, {.low = -180.0, .high = 180.0, .format = "%.0f\xc2\xb0"},
                              direction_of(origin.velocity, 0.0),
                              "0: along the flag, away from the pole; 90: towards its front; -90: towards its back.");
    if (changed) {
        memory.wind_direction = direction;
        v = blowing(speed, direction, v.y);
    }
    widgets.slider("Upwards", v.y, {.low = -10.0, .high = 10.0, .format = "%.1f m/s"}, origin.velocity.y,
                   "Vertical mean; negative blows down.");
}

}  // namespace

void draw_wind_page(Session& session, PanelMemory& memory, Widgets& widgets) {
    auto& wind = session.scene.wind();
    const Wind origin = session.origin.wind().value_or(Wind{});
    bool on = wind.has_value();
    if (widgets.toggle("Wind", on,
                       "Wind on or off. Wind pushes through air drag, so it needs air drag on the Springs page."))
        wind = on ? std::optional(origin) : std::nullopt;
    if (!wind) return;

    edit_mean(*wind, origin, memory, widgets);
    const Range range{.low = 0.0, .high = 15.0, .format = "%.1f m/s"};
    widgets.slider("Gusts along", wind->gusts.x, range, origin.gusts.x,
                   "RMS speed of the gusts along the flag, added to the mean. Higher is more violent.");
    widgets.slider("Gusts up", wind->gusts.y, range, origin.gusts.y, "RMS speed of the gusts up and down.");
    widgets.slider("Gusts across", wind->gusts.z, range, origin.gusts.z,
                   "RMS speed of the gusts towards the flag's front and back. Higher makes it flap more.");
    widgets.slider("Gust period", wind->period, {.low = 0.1, .high = 20.0, .logarithmic = true, .format = "%.2f s"},
                   origin.period, "Time scale of the gusts. A longer period makes them change more slowly.");
    widgets.toggle(
        "Travelling gusts", wind->travelling,
        "Gusts move along the flag with the mean wind (at 1 m/s at least), so they reach the pole before the "
        "fly. Off: the wind is the same everywhere at any moment. Travelling gusts take more time.");
    int seed = int(wind->seed);
    if (widgets.slider("Seed", seed, 1, 100, int(origin.seed),
                       "A different seed gives different gusts; the same seed always repeats them."))
        wind->seed = std::uint64_t(seed);
}

}  // namespace drapeau
