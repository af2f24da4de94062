// The page on the wind: its mean as strength and direction, its gusts on each axis.
#include "panels.hpp"

#include "setting_controls.hpp"
#include "wind_overlay.hpp"

#include <imgui.h>

#include <glm/trigonometric.hpp>

#include <cmath>

namespace drapeau {

using namespace settings;

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
    bool changed = wind_compass(speed, direction, 40.0, widgets);
    changed |= widgets.slider("Wind speed", speed, {.high = 40.0, .format = "%.1f m/s"},
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

void draw_wind_page(AppState& app, PanelMemory& memory, Widgets& widgets) {
    auto& wind = app.scene.wind();
    const Wind origin = app.origin.wind().value_or(Wind{});
    if (switch_table(widgets, Wind::name, remark_on<Wind>, wind.has_value()))
        wind = wind ? std::nullopt : std::optional(origin);
    if (!wind) return;
    each_key(keys_of<Wind>, [&](const auto& field) {
        if (field.key == "velocity") {
            edit_mean(*wind, origin, memory, widgets);
        } else {
            edit(widgets, Wind::table, field, *wind, origin);
        }
    });
}

}  // namespace drapeau
