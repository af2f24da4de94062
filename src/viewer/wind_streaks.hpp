// Wind streaks: motes that drift with the wind through a box around the flag, so that one sees how it blows. Where they
// are depends on the simulated moments shown alone: the same run shows the same streaks.
#pragma once

#include "camera.hpp"
#include "scene/scene.hpp"
#include "streak.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace drapeau {

class WindStreaks {
public:
    static constexpr int count = 70;
    static constexpr float trail = 0.06f;  // s, the way of the air that a streak shows

    /// Lets the motes drift from the last moment to this one (s). After a jump in time they are where they were.
    void drift(const Wind& wind, const Framing& framing, double time);
    /// Each from where its air was a moment ago; strong well inside the box, nothing at its faces.
    const std::vector<Streak>& streaks() const { return streaks_; }

private:
    std::vector<glm::dvec3> places_;   // in shares of the box
    std::vector<std::int64_t> lives_;  // how many each has begun
    std::vector<Streak> streaks_;
    double time_ = 0.0, drifted_ = 0.0;  // s
};

/// The Beaufort force of a wind (m/s, 10 m above ground), 0 to 12: the limits are those of the WMO's scale in m/s.
int beaufort(double speed);
const char* beaufort_name(int force);
constexpr double knots_in_a_metre_per_second = 3600.0 / 1852.0;

}  // namespace drapeau
