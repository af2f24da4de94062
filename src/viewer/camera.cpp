#include "camera.hpp"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace drapeau {

namespace {

constexpr float field_of_view = 34.0f;      // degrees over the view's height
constexpr float degrees_per_pixel = 0.3f;   // of turning
constexpr float degrees_per_second = 6.0f;  // of the slow turn
constexpr float zoom_per_notch = 1.12f;
constexpr float min_zoom = 0.15f, max_zoom = 20.0f;
constexpr float lowest = -35.0f, highest = 85.0f;  // degrees
constexpr float above_ground = 0.12f;              // m, the eye at least

float half_height_at(float distance) {
    return distance * std::tan(glm::radians(field_of_view) / 2.0f);
}

}  // namespace

void Camera::turn(glm::vec2 pixels) {
    azimuth = std::remainder(azimuth - pixels.x * degrees_per_pixel, 360.0f);
    elevation = std::clamp(elevation + pixels.y * degrees_per_pixel, lowest, highest);
}

void Camera::closer(float notches) {
    zoom = std::clamp(zoom * std::pow(zoom_per_notch, notches), min_zoom, max_zoom);
}

void Camera::closer(float notches, glm::vec2 pointer, const Framing& framing, const Area& view) {
    const glm::vec2 middle((view.x0 + view.x1) / 2.0f, (view.y0 + view.y1) / 2.0f);
    const float before = zoom;
    closer(notches);
    // What is there has moved away from the middle by as much as it has become larger.
    slide((1.0f - zoom / before) * (pointer - middle), framing, view);
}

void Camera::orbit(double seconds) {
    azimuth = std::remainder(azimuth + float(seconds) * degrees_per_second, 360.0f);
}

// What is under the mouse stays under it.
void Camera::slide(glm::vec2 pixels, const Framing& framing, const Area& view) {
    const glm::mat4 world_to_eye = view_matrix(framing, view);
    const glm::vec3 right(world_to_eye[0][0], world_to_eye[1][0], world_to_eye[2][0]);
    const glm::vec3 up(world_to_eye[0][1], world_to_eye[1][1], world_to_eye[2][1]);
    const float metres_per_pixel = 2.0f * half_height_at(distance(framing, view)) / std::max(1.0f, view.height());
    pan += (-right * pixels.x + up * pixels.y) * metres_per_pixel;
    const float furthest = 4.0f * std::max(framing.width, framing.height);
    pan = glm::clamp(pan, glm::vec3(-furthest), glm::vec3(furthest));
}

void Camera::reset() {
    *this = Camera();
}

float Camera::distance(const Framing& framing, const Area& view) const {
    const float aspect = std::max(0.2f, view.width() / std::max(1.0f, view.height()));
    const float height = std::max(framing.height, framing.width / aspect);
    return height / 2.0f / std::tan(glm::radians(field_of_view) / 2.0f) / zoom;
}

glm::vec3 Camera::eye(const Framing& framing, const Area& view) const {
    const float a = glm::radians(azimuth);
    const float e = glm::radians(std::clamp(elevation + framing.above, lowest, highest));
    const glm::vec3 towards_eye(std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e));
    glm::vec3 place = target(framing) + towards_eye * distance(framing, view);
    place.y = std::max(place.y, framing.ground + above_ground);
    return place;
}

glm::mat4 Camera::view_matrix(const Framing& framing, const Area& view) const {
    return glm::lookAt(eye(framing, view), target(framing), glm::vec3(0.0f, 1.0f, 0.0f));
}

glm::mat4 Camera::projection(const Framing& framing, const Area& view, glm::vec2 picture) const {
    const float away = distance(framing, view);
    const float nearest = std::max(0.01f, away * 0.02f), furthest = away * 40.0f + 200.0f;
    const float per_pixel = 2.0f * half_height_at(nearest) / std::max(1.0f, view.height());
    const glm::vec2 middle((view.x0 + view.x1) / 2.0f, (view.y0 + view.y1) / 2.0f);
    return glm::frustum(-middle.x * per_pixel, (picture.x - middle.x) * per_pixel, -(picture.y - middle.y) * per_pixel,
                        middle.y * per_pixel, nearest, furthest);
}

}  // namespace drapeau
