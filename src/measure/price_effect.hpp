// Price effect: how far a scene's motion is from that of the scene as given, both flown from the same state so finely
// that the difference is what was left out, not the error of a step.
#pragma once

#include "measure/trade_measure.hpp"

#include <functional>
#include <string>

namespace drapeau {

struct Effect {
    Apart apart;            // of the motion without from the motion with it, at the masses of the scene as given
    double known_to = NAN;  // m, root mean square: the error of both motions
    TipStatistics tip;      // without it
    bool is_measured = false;
    std::string remark;  // why it is not

    /// Whether it is at most `tolerance` (m), as far as it is known.
    bool is_within(double tolerance) const { return is_measured && apart.distance() + known_to <= tolerance; }
};

/// The stretch of the ground as the scene's grid has it.
Stretch stretch_on(const Scene& scene, const Footing& ground);

/// Flies rk4 in double at the steps of the ground's reference, and at twice and four times those for its error; one
/// flight where only statistics are asked for. A scene in float, where the ground's is in double, is flown with the
/// rounding of its own method and step too; one without the ground's tolerance with what that changes of its own run,
/// as the programs run it. Nothing is measured where it does not hold, or `may_go_on()` was false.
Effect effect_of(const Scene& scene, const Footing& ground, bool only_statistics,
                 const std::function<bool()>& may_go_on);

}  // namespace drapeau
