// Report text: what the reports of comparisons of motions say in the same words.
#pragma once

#include "measure/reference_flight.hpp"
#include "measure/tip_statistics.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace drapeau::lab {

/// A distance (m) for a person; "-" where there is none.
std::string metres(double value);
/// "12.3 ± 0.4 Hz", of a value and its error times `scale`.
std::string with_error(double value, double error, const std::string& unit, double scale = 1.0);

/// How well a motion is known (m): "known to 14.6 nm (rms)"; past the horizon it is not.
std::string known_text(double error, bool is_beyond_horizon);

/// How fast neighbouring motions part, and when they are `distance` (m) apart: a line.
std::string growth_text(const Growth& growth, double distance);
/// Said where that has shortened the time compared.
extern const char* const shortened_text;
/// Said where the time compared is past the horizon (s).
std::string beyond_text(const Stretch& stretch, double horizon);
std::string statistics_text(const Tip& place, const TipStatistics& tip);
nlohmann::ordered_json statistics_json(const TipStatistics& tip);

}  // namespace drapeau::lab
