// Surroundings: where the ground is, how thick the pole, and where on it the flag hangs: what the picture and the start
// have in common. The pole stands on the ground and ends at the origin, where the flag's upper corner is at full mast.
#pragma once

#include "scene/scene.hpp"

#include <algorithm>

namespace drapeau {

/// Width, height and the longer of the two (m) of the flag as it starts, stretched or not.
struct Extent {
    double width, height, size;
};
inline Extent extent_of(const FlagSettings& flag) {
    const double stretch = 1.0 + flag.prestretch;
    const double width = flag.columns > 1 ? stretch * flag.width : 0.0;
    const double height = flag.rows > 1 ? stretch * flag.height : 0.0;
    return {width, height, std::max({width, height, 0.05})};
}

/// The height (m) of the ground: that of [ground], or else where it is drawn though nothing touches it.
inline double ground_height(const Scene& scene) {
    const Extent e = extent_of(scene.flag);
    const auto& ground = scene.limits.get<Ground>();
    return ground ? ground->height : -e.height - 0.52 * e.size;
}
inline double pole_radius(const Scene& scene) {  // m
    const auto& pole = scene.limits.get<Pole>();
    return pole ? pole->radius : std::clamp(0.014 * extent_of(scene.flag).size, 0.002, 0.05);
}

/// The height (m) of the flag's upper corner where the halyard holds it, no lower than lets its foot reach the ground.
inline double hoisted_height(const Scene& scene) {
    if (!scene.flag.halyard || scene.flag.attach == Attach::none) return 0.0;
    const double pole = std::max(0.0, -ground_height(scene));
    return std::max((*scene.flag.halyard - 1.0) * pole, std::min(0.0, extent_of(scene.flag).height - pole));
}

}  // namespace drapeau
