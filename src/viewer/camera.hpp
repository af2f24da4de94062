// Camera: turns around the flag, comes closer, slides aside; it never flips over nor sinks below the ground.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace drapeau {

/// A rectangle in pixels, origin at the upper left corner.
struct Area {
    float x0 = 0.0f, y0 = 0.0f, x1 = 0.0f, y1 = 0.0f;

    float width() const { return x1 - x0; }
    float height() const { return y1 - y0; }
    bool contains(glm::vec2 at) const { return at.x >= x0 && at.x < x1 && at.y >= y0 && at.y < y1; }
};

/// What the camera must see when it is reset: a box that faces +z.
struct Framing {
    glm::vec3 centre{0.0f};
    float width = 1.0f, height = 1.0f;  // m
    float ground = -1e9f;               // m, height of the ground
    float above = 0.0f;                 // degrees that it is seen from above, besides the camera's own
};

class Camera {
public:
    float azimuth = default_azimuth;      // degrees to the right of the flag's front
    float elevation = default_elevation;  // degrees above the flag, besides the framing's
    float zoom = 1.0f;                    // 2 is twice as close as the framing asks
    glm::vec3 pan{0.0f};                  // m from the framing's centre

    void turn(glm::vec2 pixels);
    void closer(float notches);
    /// The same towards what is seen at `pointer`: it stays where it is in the picture.
    void closer(float notches, glm::vec2 pointer, const Framing& framing, const Area& view);
    /// So many seconds of a slow turn around the flag, a minute a turn.
    void orbit(double seconds);
    void slide(glm::vec2 pixels, const Framing& framing, const Area& view);
    void reset();

    float distance(const Framing& framing, const Area& view) const;
    glm::vec3 target(const Framing& framing) const { return framing.centre + pan; }
    glm::vec3 eye(const Framing& framing, const Area& view) const;
    glm::mat4 view_matrix(const Framing& framing, const Area& view) const;

    /// The perspective whose middle is the middle of `view` within a picture of width x height pixels.
    glm::mat4 projection(const Framing& framing, const Area& view, glm::vec2 picture) const;

    static constexpr float default_azimuth = -14.0f;
    static constexpr float default_elevation = -5.0f;
};

}  // namespace drapeau
