#include "report_text.hpp"

#include "io/text.hpp"

#include "drapeau/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace drapeau::lab {

std::string metres(double value) {
    constexpr double least = 1e-12;  // no unit is smaller
    if (value > 0.0 && value < least) return "< 0.001 nm";
    return std::isfinite(value) ? quantity(value, "m") : "-";
}

std::string with_error(double value, double error, const std::string& unit, double scale) {
    const std::string doubt = std::isfinite(error) ? rounded(scale * error, 2) : "?";
    return rounded(scale * value, 3) + " ± " + doubt + " " + unit;
}

std::string known_text(double error, bool is_beyond_horizon) {
    return is_beyond_horizon ? "but past the chaos horizon trajectories are not known"
                             : "known to " + metres(error) + " (rms)";
}

std::string growth_text(const Growth& growth, double distance) {
    if (!growth.is_seen())
        return fmt::format("chaos: none seen: what was 1 nm apart is {} apart at the end\n", metres(growth.last));
    return fmt::format("chaos: what is apart becomes tenfold every {} (rate {} 1/s): 1 nm becomes {} in {}\n",
                       quantity(std::log(10.0) / growth.rate, "s", 2), rounded(growth.rate, 3), metres(distance),
                       quantity(growth.horizon(distance), "s", 2));
}

const char* const shortened_text =
    "  half of that is compared, so that errors of steps grow no more than a thousandfold (--seconds overrides)\n";

std::string beyond_text(const Stretch& stretch, double horizon) {
    return fmt::format(
        "  {} is beyond that horizon: where masses are says nothing there, so statistics of the tip are compared\n"
        "  (--seconds {} compares trajectories). One standard error each; \"apart\": the most of the three.\n",
        quantity(stretch.seconds(), "s"),
        rounded(std::max(1.0, std::floor(horizon / batch_seconds)) * batch_seconds, 6));
}

std::string statistics_text(const Tip& place, const TipStatistics& tip) {
    return fmt::format(
        "the mass in column {}, row {} is on average at ({}, {}, {}) m ± {}; variance {},\n"
        "  mean frequency {}, peak of the spectrum {}\n",
        place.column, place.row, rounded(tip.mean.x, 3), rounded(tip.mean.y, 3), rounded(tip.mean.z, 3),
        metres(tip.mean_error), with_error(tip.variance, tip.variance_error, "cm²", 1e4),
        with_error(tip.mean_hertz, tip.mean_hertz_error, "Hz"), with_error(tip.peak_hertz, tip.peak_hertz_error, "Hz"));
}

nlohmann::ordered_json statistics_json(const TipStatistics& tip) {
    return {{"mean_m", {tip.mean.x, tip.mean.y, tip.mean.z}},
            {"mean_error_m", tip.mean_error},
            {"variance_m2", tip.variance},
            {"variance_error_m2", tip.variance_error},
            {"mean_hz", tip.mean_hertz},
            {"mean_error_hz", tip.mean_hertz_error},
            {"peak_hz", tip.peak_hertz},
            {"peak_error_hz", tip.peak_hertz_error}};
}

}  // namespace drapeau::lab
