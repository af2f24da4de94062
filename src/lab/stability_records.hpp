// Stability records: the points of a stability map, and what part files keep of them.
#pragma once

#include "parts.hpp"
#include "stability.hpp"
#include "stability_limit.hpp"

#include <string>
#include <vector>

namespace drapeau::lab {

/// One method on one cloth.
struct StabilityPoint {
    Method method{};
    Scene scene;                 // at rest
    bool is_of_damping = false;  // one of those that differ in damping, rather than in stiffness
    std::string key;             // stable
};

/// What a sweep found, in the order of its points.
struct StabilityMap {
    Scene scene;
    std::vector<StabilityPoint> points;
    std::vector<StabilityLimit> limits;
};

/// Every method asked for, at the scene's damping over stiffness, then at its stiffness over damping: the values that
/// were asked for, or from a hundredth to a hundredfold, and from none to a tenth of sqrt(k m). Throws InputError.
std::vector<StabilityPoint> points_of(const Scene& scene, const StabilityOptions& options);

SweepIdentity identity_of(const Scene& scene, const StabilityOptions& options);
StabilityOptions options_of_stability(const SweepIdentity& sweep);
std::vector<std::string> keys_of(const std::vector<StabilityPoint>& points);

Json result_json(const StabilityLimit& limit);
/// Throws Json::exception or std::out_of_range for what no sweep wrote.
StabilityLimit limit_in(const Json& json, const StabilityPoint& point);
std::vector<StabilityLimit> limits_in(const Part& part, const std::vector<StabilityPoint>& points);

}  // namespace drapeau::lab
