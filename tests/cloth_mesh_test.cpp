// How finely the cloth is drawn: as many points as its looks need, and none more where the grid is fine by itself.
#include "catch.hpp"

#include "viewer/cloth_mesh.hpp"

#include <algorithm>
#include <set>

using namespace drapeau;

TEST_CASE("a coarse grid is drawn finer, as fine along the fly as along the hoist, within the most points allowed") {
    for (const int most : {120, 240})
        for (const glm::ivec2 masses : {glm::ivec2(45, 30), {9, 7}, {30, 3}, {3, 200}, {2, 2}, {100, 61}}) {
            CAPTURE(most, masses.x, masses.y);
            const glm::vec2 size(1.5f, 1.0f), cell = size / glm::vec2(masses - 1);
            const glm::ivec2 pieces = pieces_of_cell(masses, cell, most), points = (masses - 1) * pieces + 1;
            CHECK(points.x <= std::max(masses.x, most + 1));
            CHECK(points.y <= std::max(masses.y, most + 1));
            CHECK(std::max(pieces.x, pieces.y) <= most_pieces);
            if (std::max(masses.x, masses.y) < most / 4) CHECK(std::max(pieces.x, pieces.y) > 1);
        }
    CHECK(pieces_of_cell({45, 30}, {1.5f / 44.0f, 1.0f / 29.0f}, 240) == glm::ivec2(5, 6));
}

TEST_CASE("what is fine by itself, and what has no surface, is drawn as it is") {
    CHECK(pieces_of_cell({512, 512}, {0.003f, 0.002f}, 240) == glm::ivec2(1));
    CHECK(pieces_of_cell({4096, 4096}, {0.001f, 0.001f}, 240) == glm::ivec2(1));
    CHECK(pieces_of_cell({1, 1}, {0.0f, 0.0f}, 240) == glm::ivec2(1));
    CHECK(pieces_of_cell({0, 0}, {0.0f, 0.0f}, 240) == glm::ivec2(1));
    CHECK(pieces_of_cell({1, 20}, {0.0f, 0.05f}, 240).x == 1);
}

TEST_CASE("two triangles fill each cell, and name every point of the grid and none beyond it") {
    for (const glm::ivec2 points : {glm::ivec2(2, 2), {5, 3}, {1, 7}, {0, 0}}) {
        const auto indices = triangles_between(points.x, points.y);
        CHECK(int(indices.size()) == 6 * std::max(0, points.x - 1) * std::max(0, points.y - 1));
        const std::set<std::uint32_t> named(indices.begin(), indices.end());
        if (!named.empty()) CHECK(int(named.size()) == points.x * points.y);
        for (const std::uint32_t index : named) CHECK(int(index) < points.x * points.y);
    }
}
