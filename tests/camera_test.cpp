// Camera: it turns around the flag, neither flips over nor sinks below the ground, and slides with the mouse.
#include "catch.hpp"

#include "viewer/camera.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace drapeau;

namespace {

const Framing framing{.centre = {0.75f, -0.5f, 0.0f}, .width = 2.0f, .height = 1.5f, .ground = -2.0f};
const Area view{300.0f, 0.0f, 1200.0f, 800.0f};
const glm::vec2 picture(1200.0f, 800.0f);

/// Where a point of the world is in the picture, in pixels from the upper left corner.
glm::vec2 pixel_of(const Camera& camera, glm::vec3 point) {
    const glm::vec4 clip =
        camera.projection(framing, view, picture) * camera.view_matrix(framing, view) * glm::vec4(point, 1.0f);
    return {(0.5f + 0.5f * clip.x / clip.w) * picture.x, (0.5f - 0.5f * clip.y / clip.w) * picture.y};
}

bool same(const Camera& a, const Camera& b) {
    return a.azimuth == b.azimuth && a.elevation == b.elevation && a.zoom == b.zoom && a.pan == b.pan;
}

constexpr float half_pixel = 0.5f;  // floats of a few hundred pixels through two matrices are far better than that

}  // namespace

TEST_CASE("whatever is done to it, the camera stays above the ground, upright, and at a distance") {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> pixels(-500.0f, 500.0f), notches(-10.0f, 10.0f);
    Camera camera;
    for (int act = 0; act < 3000; ++act) {
        switch (random() % 5) {
            case 0:
                camera.turn({pixels(random), pixels(random)});
                break;
            case 1:
                camera.closer(notches(random));
                break;
            case 2:
                camera.orbit(std::abs(notches(random)));
                break;
            case 3:
                camera.closer(notches(random), {pixels(random), pixels(random)}, framing, view);
                break;
            default:
                camera.slide({pixels(random), pixels(random)}, framing, view);
        }
        REQUIRE(camera.eye(framing, view).y >= framing.ground + 0.1f);
        REQUIRE(std::abs(camera.azimuth) <= 180.0f);
        const glm::mat4 to_eye = camera.view_matrix(framing, view);
        REQUIRE(to_eye[1][1] > 0.0f);  // the world's up is up in the picture
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row) REQUIRE(std::isfinite(to_eye[column][row]));
        REQUIRE(camera.distance(framing, view) > 0.1f);
        REQUIRE(camera.distance(framing, view) < 100.0f);
    }
}

TEST_CASE("what the camera looks at is in the middle of the view") {
    Camera camera;
    camera.turn({120.0f, -40.0f});
    camera.closer(3.0f);
    const glm::vec2 at = pixel_of(camera, camera.target(framing));
    CHECK(at.x == Approx((view.x0 + view.x1) / 2.0f).margin(half_pixel));
    CHECK(at.y == Approx((view.y0 + view.y1) / 2.0f).margin(half_pixel));
}

TEST_CASE("a camera that was reset shows the whole framing within the view") {
    Camera camera;
    camera.azimuth = camera.elevation = 0.0f;
    for (const float side : {-0.499f, 0.499f}) {  // it may fit exactly, up to rounding
        const glm::vec2 at =
            pixel_of(camera, framing.centre + glm::vec3(side * framing.width, side * framing.height, 0.0f));
        CHECK(view.contains(at));
    }
}

TEST_CASE("turning right and back is where it was, and a full turn too") {
    Camera camera;
    camera.turn({100.0f, 30.0f});
    CHECK(camera.azimuth != Camera::default_azimuth);
    CHECK(camera.elevation > Camera::default_elevation);
    camera.turn({-100.0f, -30.0f});
    // Degrees as floats: a few ulp of 30.
    CHECK(camera.azimuth == Approx(Camera::default_azimuth).margin(1e-4));
    CHECK(camera.elevation == Approx(Camera::default_elevation).margin(1e-4));
    for (int tenth = 0; tenth < 10; ++tenth) camera.turn({120.0f, 0.0f});  // 0.3 degrees a pixel
    CHECK(camera.azimuth == Approx(Camera::default_azimuth).margin(1e-3));
}

TEST_CASE("a notch of the wheel comes closer by the factor that one back undoes, within limits") {
    Camera camera;
    const float before = camera.distance(framing, view);
    camera.closer(1.0f);
    CHECK(camera.distance(framing, view) < before);
    CHECK(camera.distance(framing, view) > 0.8f * before);
    camera.closer(-1.0f);
    CHECK(camera.distance(framing, view) == Approx(before).epsilon(1e-5));

    camera.closer(1e6f);
    const float closest = camera.distance(framing, view);
    camera.closer(1.0f);
    CHECK(camera.distance(framing, view) == closest);
    camera.closer(-1e6f);
    const float furthest = camera.distance(framing, view);
    camera.closer(-1.0f);
    CHECK(camera.distance(framing, view) == furthest);
    CHECK(closest > 0.0f);
    CHECK(furthest > 10.0f * closest);
}

TEST_CASE("what is under the mouse stays under it while the camera slides") {
    Camera camera;
    camera.turn({60.0f, 50.0f});
    const glm::vec3 held = camera.target(framing);
    const glm::vec2 before = pixel_of(camera, held), drag(70.0f, -40.0f);
    camera.slide(drag, framing, view);
    const glm::vec2 after = pixel_of(camera, held);
    CHECK(after.x == Approx(before.x + drag.x).margin(half_pixel));
    CHECK(after.y == Approx(before.y + drag.y).margin(half_pixel));
}

TEST_CASE("the camera cannot slide so far that the flag is lost") {
    Camera camera;
    for (int drag = 0; drag < 1000; ++drag) camera.slide({-400.0f, 300.0f}, framing, view);
    const float furthest = 4.0f * std::max(framing.width, framing.height);
    for (int axis = 0; axis < 3; ++axis) CHECK(std::abs(camera.pan[axis]) <= furthest);
}

TEST_CASE("a reset camera is as new") {
    Camera camera;
    camera.turn({33.0f, 44.0f});
    camera.closer(2.0f);
    camera.slide({10.0f, 10.0f}, framing, view);
    REQUIRE(!same(camera, Camera()));
    camera.reset();
    CHECK(same(camera, Camera()));
}

TEST_CASE("the wheel comes closer to what is under the mouse, which stays where it is") {
    Camera camera;
    camera.turn({60.0f, 30.0f});
    const glm::vec2 mouse(900.0f, 200.0f);
    // Of the plane through what the camera looks at, parallel to the picture.
    const glm::mat4 to_world =
        glm::inverse(camera.projection(framing, view, picture) * camera.view_matrix(framing, view));
    const glm::vec4 aim = camera.projection(framing, view, picture) * camera.view_matrix(framing, view) *
                          glm::vec4(camera.target(framing), 1.0f);
    const glm::vec4 point =
        to_world * glm::vec4(2.0f * mouse.x / picture.x - 1.0f, 1.0f - 2.0f * mouse.y / picture.y, aim.z / aim.w, 1.0f);
    const glm::vec3 under = glm::vec3(point) / point.w;
    REQUIRE(glm::length(pixel_of(camera, under) - mouse) < half_pixel);
    for (const float notches : {1.0f, 1.0f, -1.0f, 2.0f}) {
        camera.closer(notches, mouse, framing, view);
        CHECK(glm::length(pixel_of(camera, under) - mouse) < 2.0f * half_pixel);
    }
    CHECK(camera.zoom > 1.2f);

    // Where it can come no closer nothing moves.
    camera.closer(1e6f, mouse, framing, view);
    const Camera closest = camera;
    camera.closer(1.0f, mouse, framing, view);
    CHECK(same(camera, closest));
}

TEST_CASE("the slow turn takes a minute, whatever the frames, and neither climbs nor comes closer") {
    Camera camera, other;
    for (int frame = 0; frame < 600; ++frame) camera.orbit(0.05);
    CHECK(std::abs(std::remainder(camera.azimuth - other.azimuth - 180.0f, 360.0f)) < 0.1f);
    for (int frame = 0; frame < 300; ++frame) camera.orbit(0.1);
    CHECK(camera.azimuth == Approx(other.azimuth).margin(0.1));
    CHECK(camera.elevation == other.elevation);
    CHECK(camera.zoom == other.zoom);
}
