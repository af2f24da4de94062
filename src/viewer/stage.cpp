#include "stage.hpp"

#include "scene/surroundings.hpp"

#include <algorithm>

namespace drapeau {

namespace {

const glm::vec3 metal(0.55f, 0.57f, 0.60f);
const glm::vec3 hemp(0.62f, 0.58f, 0.48f);
const glm::vec3 gold(0.83f, 0.56f, 0.16f);

struct Shape {
    float width, height, size;
};
Shape shape_of(const FlagSettings& flag) {
    const Extent e = extent_of(flag);
    return {float(e.width), float(e.height), float(e.size)};
}

void add_rod(Stage& stage, glm::vec3 from, glm::vec3 to, float radius) {
    stage.rods.push_back({.from = from, .to = to, .radius = radius, .color = metal});
}

void add_finial(Stage& stage, glm::vec3 top, float radius) {
    stage.balls.push_back(
        {.centre = top + glm::vec3(0.0f, 1.4f * radius, 0.0f), .radius = 2.2f * radius, .color = gold});
    stage.balls.push_back(
        {.centre = top - glm::vec3(0.0f, 0.4f * radius, 0.0f), .radius = 1.35f * radius, .color = gold});
}

void add_post(Stage& stage, float x, float z, float top, float radius) {
    add_rod(stage, {x, stage.ground_height, z}, {x, top, z}, radius);
    stage.bases.push_back({.place = {x, z}, .radius = 9.0f * radius});
    add_finial(stage, {x, top, z}, radius);
}

// The line that a flag is hoisted by: down the pole along the hoist, and back up beside it, made fast at a cleat.
void add_halyard(Stage& stage, float top, float radius) {
    const float line = 0.14f * radius, away = radius + line, length = top - stage.ground_height;
    const float cleat = stage.ground_height + std::min(0.30f * length, 0.9f);
    for (const glm::vec2 side : {glm::vec2(1.0f, 0.0f), glm::vec2(0.70f, 0.71f)}) {
        const float x = -radius + away * side.x, z = away * side.y;
        stage.rods.push_back({.from = {x, cleat, z}, .to = {x, top - 0.5f * radius, z}, .radius = line, .color = hemp});
    }
    stage.balls.push_back(
        {.centre = {-radius + 0.85f * away, cleat, 0.4f * away}, .radius = 0.4f * radius, .color = hemp});
}

// A bar over the flag's width between two posts.
void add_gallows(Stage& stage, const Shape& e, float radius) {
    const float left = -0.10f * e.size, right = e.width + 0.10f * e.size;
    add_post(stage, left, 0.0f, 0.10f * e.size, radius);
    add_post(stage, right, 0.0f, 0.10f * e.size, radius);
    add_rod(stage, {left, radius, 0.0f}, {right, radius, 0.0f}, radius);
}

void add_frame(Stage& stage, const Shape& e, float radius) {
    add_gallows(stage, e, radius);
    const float left = -radius, right = e.width + radius, low = -e.height - radius, high = radius;
    add_rod(stage, {left, low, 0.0f}, {right, low, 0.0f}, 0.7f * radius);
    add_rod(stage, {left, low, 0.0f}, {left, high, 0.0f}, 0.7f * radius);
    add_rod(stage, {right, low, 0.0f}, {right, high, 0.0f}, 0.7f * radius);
    for (const float y : {low, high - 2.0f * radius}) {
        add_rod(stage, {left, y, 0.0f}, {-0.10f * e.size, y, 0.0f}, 0.5f * radius);
        add_rod(stage, {right, y, 0.0f}, {e.width + 0.10f * e.size, y, 0.0f}, 0.5f * radius);
    }
}

}  // namespace

bool has_header(const FlagSettings& flag) {
    return flag.attach == Attach::hoist || flag.attach == Attach::grommets;
}

Stage stage_of(const Scene& scene, bool with_person) {
    const FlagSettings& flag = scene.flag;
    const Shape e = shape_of(flag);
    const auto radius = float(pole_radius(scene));
    const bool has_ground = scene.limits.get<Ground>().has_value(), has_pole = scene.limits.get<Pole>().has_value();
    Stage stage;
    stage.ground = flag.attach != Attach::none || has_ground || has_pole;
    stage.ground_height = float(ground_height(scene));
    const auto add_pole = [&] { add_post(stage, -radius, 0.0f, 0.07f * e.size, radius); };
    switch (flag.attach) {
        case Attach::hoist:
        case Attach::grommets:
        case Attach::corner:
            add_pole();
            add_halyard(stage, 0.07f * e.size, radius);
            break;
        case Attach::top:
            add_gallows(stage, e, radius);
            if (has_pole) add_pole();
            break;
        case Attach::sides:
            add_pole();
            add_post(stage, e.width + radius, 0.0f, 0.07f * e.size, radius);
            break;
        case Attach::edges:
        case Attach::all:
            add_frame(stage, e, radius);
            if (has_pole) add_pole();
            break;
        case Attach::none:
            if (has_pole) add_pole();
            break;
    }
    if (with_person && stage.ground) stage.person = {-0.30f - 0.10f * e.size, stage.ground_height, 0.05f * e.size};
    const float reach = 0.25f * e.size;
    stage.low = {-reach, stage.ground_height, -0.5f * e.size};
    stage.high = {e.width + reach, 0.16f * e.size, 0.5f * e.size};
    return stage;
}

Framing framing_of(const FlagSettings& flag, const Stage& stage) {
    const Shape e = shape_of(flag);
    const float top = std::max(0.22f * e.size, stage.person ? stage.ground_height + 1.85f : 0.0f);
    // What lies down needs ground before it, and is seen from above.
    const bool falls = flag.attach == Attach::none && stage.ground;
    const float before = falls ? 0.45f : 0.12f;
    const float bottom = std::min(-e.height - 0.60f * e.size, stage.ground_height - before * e.size);
    const float left = std::min(-0.275f * e.size, stage.person ? stage.person->x - 0.35f : 0.0f);
    const float right = e.width + 0.275f * e.size;
    return {.centre = {0.5f * (left + right), 0.5f * (top + bottom), 0.0f},
            .width = right - left,
            .height = top - bottom,
            .ground = stage.ground ? stage.ground_height : -1e9f,
            .above = falls ? 15.0f : 0.0f};
}

}  // namespace drapeau
