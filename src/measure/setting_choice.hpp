// Setting choice: which of the settings measured an accuracy asked for needs, and what to take where none has it or the
// machine is too slow. Accuracies are errors a simulated second, as a scene's time.tolerance asks for.
#pragma once

#include "measure/trade_measure.hpp"

#include <optional>
#include <vector>

namespace drapeau {

/// m a simulated second: the error at the end of the stretch (s) compared, as a share of it.
double error_rate(const Measured& point, double seconds);

/// Of each point, whether an automatic step of its method is at least as long: with a tolerance it takes one of these.
std::vector<char> within_automatic_step(const Scene& scene, const std::vector<Measured>& points);

struct SettingChoice {
    std::optional<std::size_t> chosen;   // the cheapest within the tolerance, of the points
    std::optional<std::size_t> next;     // the cheapest within it of another method
    std::optional<std::size_t> nearest;  // where the machine cannot keep up with that, or there is none: the most
                                         // accurate with which it can
    bool keeps_up = false;               // the machine, with what was chosen
};

/// `tolerance`: m a simulated second. `most`: ms of processor time a simulated second that the machine has.
SettingChoice choose_setting(const std::vector<Measured>& points, const std::vector<char>& allowed, double seconds,
                             double tolerance, double most);

}  // namespace drapeau
