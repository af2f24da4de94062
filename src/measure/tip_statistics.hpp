// Tip statistics: what two chaotic motions can be compared by: where the tip is on average, how much it moves, how
// fast.
#pragma once

#include <glm/vec3.hpp>

#include <vector>

namespace drapeau {

/// Each with one standard error, from the spread of up to eight blocks of the time. NAN where the time is too short.
struct TipStatistics {
    glm::dvec3 mean{0.0};     // m
    double mean_error = 0.0;  // m, root of the sum over the axes
    double variance = 0.0;    // m^2, summed over the axes
    double variance_error = 0.0;
    double mean_hertz =
        0.0;  // Hz, rms speed / (2 pi rms displacement): the root mean square of the spectrum's frequency
    double mean_hertz_error = 0.0;
    double peak_hertz = 0.0;        // Hz, where the spectrum of the displacement is largest
    double peak_hertz_error = 0.0;  // Hz, half a line of the spectrum
};

/// `position` (m) and `velocity` (m/s) are equally spaced, `interval` (s) apart.
TipStatistics statistics_of(const std::vector<glm::dvec3>& position, const std::vector<glm::dvec3>& velocity,
                            double interval);

/// How many standard errors apart two are at most: in mean, variance and mean frequency.
double standard_errors_apart(const TipStatistics& one, const TipStatistics& other);

}  // namespace drapeau
