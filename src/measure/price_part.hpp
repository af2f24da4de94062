// Price part: something of a scene that may be left out, and the scene without it. What there is follows from the lists
// of settings, terms and limits: a term that joins them is a part too.
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace drapeau {

struct ScenePart {
    std::string key;    // stable, as in a scene file: "springs.drag", "wind", "wind.gusts", "time.precision", "flag"
    std::string label;  // for people: "springs.drag = 0.0006 N·s/m, and the wind that needs it"
    Scene without;      // the scene that is left
    std::vector<std::string> also;  // tables that need it and are left out with it
    std::string impossible;         // why there is no such scene; "" where there is
};

/// Of the springs each setting that may be absent; each term and limit listed, and of those with several settings each
/// vector among others and each switch that is on; double precision (float instead); the tolerance (the automatic step
/// alone); the grid (half the cells each way, the same cloth).
std::vector<ScenePart> parts_of(const Scene& scene);

}  // namespace drapeau
