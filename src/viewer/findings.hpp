// Findings: what was measured of the scene, and what follows from it: the setting for an accuracy asked for, a setting
// or a part of the scene chosen from what was measured.
#pragma once

#include "measuring.hpp"

#include <optional>
#include <set>
#include <string>

namespace drapeau {

/// What the simulation cares for: names and views are left empty.
Scene physics_of(Scene scene);

struct Findings {
    std::optional<MeasuredTrade> trade;
    std::optional<MeasuredPrices> prices;
    std::optional<Measuring::Subject> under_way;
    double share = 0.0;             // of what is under way
    std::string trouble;            // why the last measurement came to nothing
    Measuring::Subject troubled{};  // and what it was of

    // m a simulated second: what method and step are chosen for; empty while they are the user's.
    std::optional<double> accuracy;
    TimeSettings chosen;             // that the accuracy came to; any other means that the user chose
    std::set<std::string> left_out;  // keys of parts that are switched off in the list of prices
    Scene reduced;                   // what they leave of the scene that was priced
    std::set<std::string> missing;   // keys of parts that needed those and went with them
};

/// Whether what was measured of a scene holds for another: how it is stepped does not matter.
bool holds_for(const Scene& measured, const Scene& now);

/// The settings for an accuracy (m a simulated second), once the scene's are measured; before that, its tolerance
/// alone.
TimeSettings settings_for(double accuracy, const Scene& scene, const Findings& findings);

/// What follows from what was measured for the accuracy asked for.
struct AccuracyAnswer {
    std::string text;               // what was chosen, why, and what it costs; or why nothing was
    bool is_good = false;           // it is met, and the machine keeps up
    std::optional<double> instead;  // m a simulated second: the nearest that can be had
};
/// `dt`: s, the step in use; 0 where it is not known.
AccuracyAnswer answer_for(double accuracy, const Scene& scene, const Findings& findings, double dt = 0.0);

/// Takes in what was measured; the scene is stepped as an accuracy that is asked for needs.
void take(MeasuredScene measurement, Scene& scene, Findings& findings);

/// The scene with one setting that was measured.
TimeSettings settings_of(const TradePoint& point, TimeSettings time);

/// The place of the point that the scene is stepped by; nothing if there is none.
std::optional<std::size_t> place_of(const TimeSettings& time, double dt, const MeasuredTrade& trade);

/// Switches a priced part of the scene off or on again. The scene is then the priced one without all that is off,
/// stepped as it was before.
void leave_out(const std::string& key, bool is_out, Scene& scene, Findings& findings);

/// Settings that the run refused are taken back: where the scene is as it was priced, nothing of it is switched off.
void hear_of_scene(Findings& findings, const Scene& now);

/// Whether the list of prices speaks of this scene, as its switches made it.
bool are_of(const Findings& findings, const Scene& now);

/// "leapfrog in float, 253 µs"
std::string setting_text(const TradePoint& point);

}  // namespace drapeau
