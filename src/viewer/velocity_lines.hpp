// Velocities of masses as lines: from a mass along its velocity, as long as it is fast. Of fine grids masses a few
// centimetres apart have one, so that the flag stays to be seen.
#pragma once

#include "force_scale.hpp"
#include "run/simulation.hpp"
#include "streak.hpp"

#include <glm/vec2.hpp>

#include <algorithm>
#include <vector>

namespace drapeau {

/// The speed (m/s) that 19 masses in 20 do not exceed, of about 4000 at most; 0 of no masses. The tip that cracks like
/// a whip would make all other lines dots.
double usual_speed(const FieldBuffer<float>& velocity);

/// The speed (m/s) at the end of the legend: a round number that follows the usual one closely.
class SpeedScale {
public:
    void follow(const FieldBuffer<float>& velocity) { scale_.follow(std::max(least, usual_speed(velocity))); }
    double end() const { return scale_.end(); }

private:
    static constexpr double least = 0.1;  // m/s; what hardly moves is to look so
    RoundScale scale_{0.95};              // lines are to be long enough to be read
};

/// Every how many columns and rows there is a line, so that at most 18 stand along the longer side and they are as far
/// apart both ways. `cell`: m.
glm::ivec2 lines_apart(int columns, int rows, glm::vec2 cell);

/// A line of `length` (m) for a mass of `speed` (m/s), and none longer than three times that. `snapshot`: with
/// velocities; none are drawn without.
std::vector<Streak> velocity_lines(const Snapshot& snapshot, glm::vec2 cell, double speed, double length);

/// The same of a flag: a mass of `speed` (m/s) has a line as long as a sixth of the flag's longer side.
std::vector<Streak> velocities_of(const Snapshot& snapshot, const FlagSettings& flag, double speed);

}  // namespace drapeau
