// Picking: which mass or spring of the cloth is under the mouse, as the cloth is seen.
#pragma once

#include "drapeau/state.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>

namespace drapeau {

/// How the world comes onto the picture.
struct Lens {
    glm::mat4 to_clip{1.0f};
    glm::vec2 picture{1.0f};  // its size in window units
};

struct Ray {
    glm::vec3 from{0.0f}, along{0.0f, 0.0f, -1.0f};  // m, and of length 1
};

/// What is seen at `at` (window units from the upper left corner) lies on this ray.
Ray ray_through(const Lens& lens, glm::vec2 at);

/// Where a point of the world is seen, in window units; none behind the eye.
std::optional<glm::vec2> seen_at(const Lens& lens, glm::vec3 point);

/// Where the ray meets the plane through a point that faces along `normal`; the point itself where it never does.
glm::vec3 on_plane(const Ray& ray, glm::vec3 through, glm::vec3 normal);

/// A mass, or with `right` or `down` the spring from it to the mass so many columns and rows further.
struct Selection {
    int column = 0, row = 0;
    int right = 0, down = 0;

    bool is_spring() const { return right != 0 || down != 0; }
    bool operator==(const Selection&) const = default;
};

struct Picked {
    int column = 0, row = 0;  // of the mass that is nearest on the surface
    glm::vec3 place{0.0f};    // m, of what is under the mouse
};

/// The place of the cloth in front under the mouse; beside it the nearest mass that is seen within `reach` (window
/// units). None where there is neither.
std::optional<Picked> pick(const FieldBuffer<float>& position, const Lens& lens, glm::vec2 at, float reach);

/// What of a cell's masses and springs is seen nearest to the mouse: the mass picked where the mouse is on it, or
/// where no springs are shown.
Selection nearest_part(const FieldBuffer<float>& position, const Lens& lens, glm::vec2 at, const Picked& picked,
                       bool springs, bool diagonals);

}  // namespace drapeau
