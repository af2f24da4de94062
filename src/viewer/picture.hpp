// Picture: what a frame shows besides the masses, as plain data. Made from the settings by main, drawn by the renderer.
#pragma once

#include "scene/scene.hpp"
#include "streak.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <optional>
#include <vector>

namespace drapeau {

struct Rod {
    glm::vec3 from{0.0f}, to{0.0f};
    float radius = 0.02f;   // m
    glm::vec3 color{0.5f};  // linear

    bool operator==(const Rod&) const = default;
};

struct Ball {
    glm::vec3 centre{0.0f};
    float radius = 0.04f;  // m
    glm::vec3 color{0.5f};

    bool operator==(const Ball&) const = default;
};

/// A disc on the ground that a post stands on.
struct Base {
    glm::vec2 place{0.0f};  // x and z
    float radius = 0.2f;    // m

    bool operator==(const Base&) const = default;
};

/// What holds the flag and what it stands on.
struct Stage {
    std::vector<Rod> rods;
    std::vector<Ball> balls;
    std::vector<Base> bases;
    std::optional<glm::vec3> person;  // where its feet stand
    bool ground = true;
    float ground_height = -2.0f;      // m
    glm::vec3 low{0.0f}, high{0.0f};  // a box around what may cast a shadow

    bool operator==(const Stage&) const = default;
};

/// Springs of one kind.
struct SpringKind {
    float rest = 0.0f;       // L, m; 0: there are none
    float stiffness = 0.0f;  // k, N/m

    bool exists() const { return rest > 0.0f; }
    bool operator==(const SpringKind&) const = default;
};

/// Springs along the fly, along the hoist and across the cells.
struct SpringKinds {
    SpringKind fly, hoist, diagonal;

    bool operator==(const SpringKinds&) const = default;
};

struct Picture {
    glm::mat4 view{1.0f}, projection{1.0f};
    glm::vec3 eye{0.0f};
    bool cloth = true;
    bool texture = true;
    bool cut_out = true;  // by the texture
    bool springs = false;
    bool forces = false;
    bool masses = false;
    bool bare_grid = false;      // flat facets between the masses
    glm::vec2 cloth_size{1.0f};  // width and height at rest, m
    bool header = false;         // a tape along the hoist, with grommets at its ends
    float reference = 0.0f;      // opacity of its wireframe; 0: there is none
    SpringKinds kinds;           // of springs
    float force_scale = 1.0f;    // N, of the reddest colour
    Colours colours = Colours::red;
    bool stretch = false;         // the cloth is coloured by it
    float stretch_scale = 1.0f;   // share, at the ends of its colours
    std::vector<Streak> streaks;  // of the wind
    std::vector<Streak> velocities;
    glm::ivec4 hidden{0};      // x, y, width, height of what panels will cover, pixels from below: not drawn
    float pixel_scale = 1.0f;  // pixels of the picture per unit of line width
    Stage stage;
    Background background = Background::sky;

    bool operator==(const Picture&) const = default;
};

}  // namespace drapeau
