#include "measure/tip_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>

namespace drapeau {

namespace {

constexpr std::size_t most_blocks = 8, least_in_a_block = 8;

double square(const glm::dvec3& v) {
    return v.x * v.x + v.y * v.y + v.z * v.z;
}

glm::dvec3 mean_of(const std::vector<glm::dvec3>& of, std::size_t first, std::size_t last) {
    glm::dvec3 sum(0.0);
    for (std::size_t n = first; n < last; ++n) sum += of[n];
    return sum / static_cast<double>(last - first);
}

double mean_square(const std::vector<glm::dvec3>& of, std::size_t first, std::size_t last, const glm::dvec3& around) {
    double sum = 0.0;
    for (std::size_t n = first; n < last; ++n) sum += square(of[n] - around);
    return sum / static_cast<double>(last - first);
}

double peak_of(const std::vector<glm::dvec3>& position, const glm::dvec3& mean, double interval) {
    const std::size_t count = position.size();
    double best = 0.0, hertz = 0.0;
    for (std::size_t line = 1; line <= count / 2; ++line) {
        double power = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            std::complex<double> sum = 0.0;
            for (std::size_t n = 0; n < count; ++n)
                sum +=
                    (position[n] - mean)[axis] *
                    std::polar(1.0, -2.0 * M_PI * static_cast<double>(line * n % count) / static_cast<double>(count));
            power += std::norm(sum);
        }
        if (power > best) best = power, hertz = static_cast<double>(line) / (static_cast<double>(count) * interval);
    }
    return hertz;
}

}  // namespace

TipStatistics statistics_of(const std::vector<glm::dvec3>& position, const std::vector<glm::dvec3>& velocity,
                            double interval) {
    const std::size_t count = position.size();
    TipStatistics all;
    if (count == 0) return all;
    all.mean = mean_of(position, 0, count);
    all.variance = mean_square(position, 0, count, all.mean);
    const auto hertz = [&](std::size_t first, std::size_t last, const glm::dvec3& mean) {
        const double moved = mean_square(position, first, last, mean);
        return moved > 0.0 ? std::sqrt(mean_square(velocity, first, last, glm::dvec3(0.0)) / moved) / (2.0 * M_PI)
                           : 0.0;
    };
    all.mean_hertz = hertz(0, count, all.mean);
    all.peak_hertz = peak_of(position, all.mean, interval);
    all.peak_hertz_error = 0.5 / (static_cast<double>(count) * interval);

    const std::size_t blocks = std::min(most_blocks, count / least_in_a_block);
    if (blocks < 2) {
        all.mean_error = all.variance_error = all.mean_hertz_error = NAN;
        return all;
    }
    const auto standard_error = [&](const std::function<double(std::size_t, std::size_t)>& of_block) {
        double sum = 0.0, squares = 0.0;
        for (std::size_t b = 0; b < blocks; ++b) {
            const double value = of_block(b * count / blocks, (b + 1) * count / blocks);
            sum += value, squares += value * value;
        }
        const double n = static_cast<double>(blocks);
        return std::sqrt(std::max(0.0, squares - sum * sum / n) / (n * (n - 1.0)));
    };
    double mean_error = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double error =
            standard_error([&](std::size_t first, std::size_t last) { return mean_of(position, first, last)[axis]; });
        mean_error += error * error;
    }
    all.mean_error = std::sqrt(mean_error);
    all.variance_error = standard_error(
        [&](std::size_t first, std::size_t last) { return mean_square(position, first, last, all.mean); });
    all.mean_hertz_error =
        standard_error([&](std::size_t first, std::size_t last) { return hertz(first, last, all.mean); });
    return all;
}

double standard_errors_apart(const TipStatistics& one, const TipStatistics& other) {
    const auto apart = [](double distance, double a, double b) {
        const double error = std::hypot(a, b);
        return distance == 0.0 ? 0.0 : distance / error;
    };
    return std::max({apart(std::sqrt(square(one.mean - other.mean)), one.mean_error, other.mean_error),
                     apart(std::abs(one.variance - other.variance), one.variance_error, other.variance_error),
                     apart(std::abs(one.mean_hertz - other.mean_hertz), one.mean_hertz_error, other.mean_hertz_error)});
}

}  // namespace drapeau
