#include "picking.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace drapeau {

namespace {

constexpr float on_a_mass = 7.0f;  // window units

glm::vec3 at_mass(const FieldBuffer<float>& position, int column, int row) {
    return glm::vec3(position.at(column, row));
}

/// How far along the ray it meets a triangle (Moeller and Trumbore 1997), infinite where it does not.
float meets(const Ray& ray, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    constexpr float never = std::numeric_limits<float>::infinity();
    const glm::vec3 ab = b - a, ac = c - a, across = glm::cross(ray.along, ac);
    const float volume = glm::dot(ab, across);
    if (volume == 0.0f) return never;
    const glm::vec3 from_a = ray.from - a, turned = glm::cross(from_a, ab);
    const float u = glm::dot(from_a, across) / volume, v = glm::dot(ray.along, turned) / volume;
    const float away = glm::dot(ac, turned) / volume;
    return u >= 0.0f && v >= 0.0f && u + v <= 1.0f && away > 0.0f ? away : never;
}

/// Of the masses around a cell the one that is nearest to a place on it.
Picked nearest_corner(const FieldBuffer<float>& position, int column, int row, const glm::vec3& place) {
    Picked nearest{.column = column, .row = row, .place = place};
    float least = std::numeric_limits<float>::infinity();
    for (int j = row; j < row + 2; ++j)
        for (int i = column; i < column + 2; ++i)
            if (const float away = glm::distance(at_mass(position, i, j), place); away < least) {
                least = away;
                nearest.column = i, nearest.row = j;
            }
    return nearest;
}

std::optional<Picked> on_surface(const FieldBuffer<float>& position, const Ray& ray) {
    float nearest = std::numeric_limits<float>::infinity();
    int column = 0, row = 0;
    for (int j = 0; j + 1 < position.rows(); ++j)
        for (int i = 0; i + 1 < position.columns(); ++i) {
            const glm::vec3 a = at_mass(position, i, j), b = at_mass(position, i + 1, j);
            const glm::vec3 c = at_mass(position, i, j + 1), d = at_mass(position, i + 1, j + 1);
            const float away = std::min(meets(ray, a, b, c), meets(ray, b, d, c));
            if (away < nearest) nearest = away, column = i, row = j;
        }
    if (!std::isfinite(nearest)) return {};
    return nearest_corner(position, column, row, ray.from + nearest * ray.along);
}

std::optional<Picked> nearest_seen(const FieldBuffer<float>& position, const Lens& lens, glm::vec2 at, float reach) {
    std::optional<Picked> nearest;
    for (int j = 0; j < position.rows(); ++j)
        for (int i = 0; i < position.columns(); ++i) {
            const glm::vec3 place = at_mass(position, i, j);
            const auto seen = seen_at(lens, place);
            if (!seen || glm::distance(*seen, at) >= reach) continue;
            reach = glm::distance(*seen, at);
            nearest = Picked{.column = i, .row = j, .place = place};
        }
    return nearest;
}

float distance_to_segment(glm::vec2 at, glm::vec2 a, glm::vec2 b) {
    const glm::vec2 ab = b - a;
    const float square = glm::dot(ab, ab);
    const float share = square > 0.0f ? std::clamp(glm::dot(at - a, ab) / square, 0.0f, 1.0f) : 0.0f;
    return glm::distance(at, a + share * ab);
}

}  // namespace

Ray ray_through(const Lens& lens, glm::vec2 at) {
    const glm::mat4 to_world = glm::inverse(lens.to_clip);
    const glm::vec2 clip(2.0f * at.x / lens.picture.x - 1.0f, 1.0f - 2.0f * at.y / lens.picture.y);
    const auto world = [&](float depth) {
        const glm::vec4 point = to_world * glm::vec4(clip, depth, 1.0f);
        return glm::vec3(point) / point.w;
    };
    // Far from the far plane, where floats of the world are coarse.
    const glm::vec3 from = world(-1.0f);
    return {from, glm::normalize(world(0.5f) - from)};
}

std::optional<glm::vec2> seen_at(const Lens& lens, glm::vec3 point) {
    const glm::vec4 clip = lens.to_clip * glm::vec4(point, 1.0f);
    if (!(clip.w > 0.0f)) return {};
    return glm::vec2((0.5f + 0.5f * clip.x / clip.w) * lens.picture.x,
                     (0.5f - 0.5f * clip.y / clip.w) * lens.picture.y);
}

glm::vec3 on_plane(const Ray& ray, glm::vec3 through, glm::vec3 normal) {
    const float towards = glm::dot(ray.along, normal);
    if (std::abs(towards) < 1e-4f) return through;
    return ray.from + glm::dot(through - ray.from, normal) / towards * ray.along;
}

std::optional<Picked> pick(const FieldBuffer<float>& position, const Lens& lens, glm::vec2 at, float reach) {
    if (const auto found = on_surface(position, ray_through(lens, at))) return found;
    return nearest_seen(position, lens, at, reach);
}

Selection nearest_part(const FieldBuffer<float>& position, const Lens& lens, glm::vec2 at, const Picked& picked,
                       bool springs, bool diagonals) {
    const Selection mass{.column = picked.column, .row = picked.row};
    const auto seen = seen_at(lens, at_mass(position, picked.column, picked.row));
    if (!springs || (seen && glm::distance(*seen, at) < on_a_mass)) return mass;
    Selection nearest = mass;
    float least = std::numeric_limits<float>::infinity();
    const auto consider = [&](int column, int row, int right, int down) {
        const int column2 = column + right, row2 = row + down;
        if (std::min({column, row, column2, row2}) < 0 || std::max(column, column2) >= position.columns() ||
            std::max(row, row2) >= position.rows())
            return;
        const auto a = seen_at(lens, at_mass(position, column, row));
        const auto b = seen_at(lens, at_mass(position, column2, row2));
        if (!a || !b) return;
        if (const float away = distance_to_segment(at, *a, *b); away < least) {
            least = away;
            nearest = {.column = column, .row = row, .right = right, .down = down};
        }
    };
    for (int j = picked.row - 1; j <= picked.row; ++j)
        for (int i = picked.column - 1; i <= picked.column + 1; ++i) {
            consider(i, j, 1, 0);
            consider(i, j + 1, 1, 0);
            consider(i, j, 0, 1);
            if (!diagonals) continue;
            consider(i, j, 1, 1);
            consider(i, j, -1, 1);
        }
    return nearest;
}

}  // namespace drapeau
