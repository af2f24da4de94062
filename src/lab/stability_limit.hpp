// Stability limit: the largest step of a method at which noise on a cloth at rest does not grow, measured, and what
// theory says of it.
//
// The cloth lies at rest without weight or wind, so that nothing but the method can make noise grow. Its growth in a
// step is fitted while it is far too small to turn a spring; whether a run breaks is not asked.
#pragma once

#include "scene/scene.hpp"

#include <optional>
#include <vector>

namespace drapeau::lab {

/// How noise grows at one step.
struct GrowthAt {
    double dt = 0.0;        // s
    double per_step = 0.0;  // the slope of the logarithm of the noise, fitted
};

struct StabilityLimit {
    Method method{};
    double stiffness = 0.0;  // N/m, of structural springs
    double damping = 0.0;    // N s/m, of every spring
    // s; infinite where every step up to the coarsest that anybody wants is stable, 0 where none is. NAN of methods
    // that create energy by nature where dampers are not in proportion to springs: growth too slow to measure decides
    // there.
    double measured = 0.0, theory = 0.0;
    double unseen = 0.0;        // s: limits below would have been measured as 0
    std::vector<GrowthAt> map;  // all that was measured, by growing steps

    /// measured/theory - 1; 0 where both are infinite, or no limit is seen and theory has none that could be.
    double off() const;
};

/// A cloth with the scene's springs, drag and friction and nothing else, at rest.
Scene quiet(const Scene& scene);

/// Measured by halving, to a ten-thousandth, and then a little below and above; of methods that create energy
/// by nature, whose noise grows slowly just past their limit, from how it grows beyond.
StabilityLimit stability_limit(const Scene& quiet_scene, Method method);

}  // namespace drapeau::lab
