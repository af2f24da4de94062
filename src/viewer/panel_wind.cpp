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

void edit_mean(WindSettings& wind, const WindSettings& origin, PanelMemory& memory, Widgets& widgets) {
    glm::dvec3& v = wind.velocity;
    double speed = std::hypot(v.x, v.z);
    double direction = memory.wind_direction = direction_of(v, memory.wind_direction);
    bool changed = widgets.slider("Wind speed", speed, {.low = 0.0, .high = 40.0, .format = "%.1f m/s"},
                                  std::hypot(origin.velocity.x, origin.velocity.z), "Mean, over the ground.");
    changed |=
        widgets.slider("Direction", direction, {.low = -180.0, .high = 180.0, .format = "%.0f\xc2\xb0"},
                       direction_of(origin.velocity, 0.0),
                       "0 blows along the flag, away from the pole; 90 towards its front, -90 towards its back.");
    if (changed) {
        memory.wind_direction = direction;
        v = blowing(speed, direction, v.y);
    }
    widgets.slider("Upwards", v.y, {.low = -10.0, .high = 10.0, .format = "%.1f m/s"}, origin.velocity.y,
                   "Mean, upwards; negative blows down.");
}

}  // namespace

void draw_wind_page(Session& session, PanelMemory& memory, Widgets& widgets) {
    auto& wind = session.scene.wind;
    const WindSettings origin = session.origin.wind.value_or(WindSettings{});
    bool on = wind.has_value();
    if (widgets.toggle("Wind", on, "Whether the air moves. It pulls through the air drag of the masses."))
        wind = on ? std::optional(origin) : std::nullopt;
    if (!wind) return;

    edit_mean(*wind, origin, memory, widgets);
    const Range range{.low = 0.0, .high = 15.0, .format = "%.1f m/s"};
    widgets.slider("Gusts along", wind->gusts.x, range, origin.gusts.x,
                   "Root mean square of the gusts along the flag, on top of the mean.");
    widgets.slider("Gusts up", wind->gusts.y, range, origin.gusts.y, "The same, upwards and downwards.");
    widgets.slider("Gusts across", wind->gusts.z, range, origin.gusts.z,
                   "The same, towards the flag's front and back.");
    widgets.slider("Gust period", wind->period, {.low = 0.1, .high = 20.0, .logarithmic = true, .format = "%.2f s"},
                   origin.period, "How fast gusts change; longer is slower.");
    int seed = int(wind->seed);
    if (widgets.slider("Seed", seed, 1, 100, int(origin.seed),
                       "Another number is other gusts; the same is the same, always."))
        wind->seed = std::uint64_t(seed);
}

}  // namespace drapeau
