#include "person.hpp"

namespace drapeau {

namespace {

const glm::vec3 clay(0.30f, 0.27f, 0.25f);

/// A part of the body between two points of its left half (m from between the feet), round at both ends.
struct Limb {
    glm::vec3 from, to;
    float radius;
};
const Limb limbs[] = {
    {{0.085f, 0.03f, 0.10f}, {0.085f, 0.04f, -0.02f}, 0.035f},  // foot
    {{0.085f, 0.06f, -0.02f}, {0.08f, 0.48f, 0.0f}, 0.048f},    // shin
    {{0.08f, 0.48f, 0.0f}, {0.075f, 0.90f, 0.0f}, 0.070f},      // thigh
    {{0.06f, 0.90f, 0.0f}, {0.04f, 1.15f, 0.0f}, 0.095f},       // hip to waist
    {{0.04f, 1.15f, 0.0f}, {0.08f, 1.36f, 0.0f}, 0.095f},       // waist to chest
    {{0.17f, 1.39f, 0.0f}, {0.22f, 1.12f, -0.02f}, 0.042f},     // upper arm
    {{0.22f, 1.12f, -0.02f}, {0.23f, 0.84f, 0.04f}, 0.035f},    // forearm
    {{0.10f, 1.41f, 0.0f}, {0.17f, 1.39f, 0.0f}, 0.045f},       // shoulder
};
constexpr float head = 0.105f, neck = 0.05f;  // m, radii

void add_limb(Stage& stage, glm::vec3 from, glm::vec3 to, float radius) {
    stage.rods.push_back({.from = from, .to = to, .radius = radius, .color = clay});
    for (const glm::vec3& end : {from, to}) stage.balls.push_back({.centre = end, .radius = radius, .color = clay});
}

}  // namespace

void add_person(Stage& stage, glm::vec2 place) {
    const glm::vec3 feet(place.x, stage.ground_height, place.y);
    for (const float side : {-1.0f, 1.0f})
        for (const Limb& limb : limbs) {
            const glm::vec3 mirror(side, 1.0f, 1.0f);
            add_limb(stage, feet + mirror * limb.from, feet + mirror * limb.to, limb.radius);
        }
    const glm::vec3 crown = feet + glm::vec3(0.0f, person_height, 0.0f);
    add_limb(stage, feet + glm::vec3(0.0f, 1.38f, 0.0f), crown - glm::vec3(0.0f, 2.0f * head, 0.0f), neck);
    stage.balls.push_back({.centre = crown - glm::vec3(0.0f, head, 0.0f), .radius = head, .color = clay});
}

}  // namespace drapeau
