// A small flag of springs in gusty wind, for tests of what runs it.
#pragma once

#include "scene/scene.hpp"

namespace drapeau::testing {

inline Scene small_sheet(int columns = 12, int rows = 8) {
    Scene scene;
    scene.flag.columns = columns, scene.flag.rows = rows;
    scene.springs->damping = 0.002;
    scene.springs->drag = 0.0002;
    scene.gravity() = Gravity{};
    scene.wind() = Wind{.velocity = {5.0, 0.0, 1.0}, .gusts = {1.0, 0.5, 1.0}};
    return scene;
}

}  // namespace drapeau::testing
