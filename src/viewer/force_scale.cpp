#include "force_scale.hpp"

#include <algorithm>
#include <cmath>

namespace drapeau {

namespace {

constexpr double least = 1e-6;  // N, a share, m/s
constexpr double fall = 0.96;   // of the level, each moment

}  // namespace

double rounded_up(double value) {
    if (!(value > least)) return least;
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0})
        if (value <= step * decade * (1.0 + 1e-9)) return step * decade;
    return 10.0 * decade;
}

void RoundScale::follow(double level) {
    if (!std::isfinite(level)) return;
    level_ = std::max(level, level_ * fall);
    const double wanted = rounded_up(level_);
    if (wanted > shown_ || level_ < hysteresis_ * rounded_up(0.4 * shown_)) shown_ = wanted;
}

}  // namespace drapeau
