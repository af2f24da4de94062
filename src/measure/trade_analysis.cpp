#include "measure/trade_analysis.hpp"

#include <algorithm>
#include <cmath>

namespace drapeau {

std::vector<std::size_t> efficient_front(const std::vector<Measured>& points) {
    std::vector<std::size_t> order;
    for (std::size_t n = 0; n < points.size(); ++n)
        if (points[n].is_measured() && !points[n].is_below_resolution()) order.push_back(n);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return points[a].ms_per_second < points[b].ms_per_second; });
    std::vector<std::size_t> front;
    double least = INFINITY;
    for (const std::size_t n : order) {
        if (!(points[n].error.at_end < least)) continue;
        least = points[n].error.at_end;
        front.push_back(n);
    }
    return front;
}

std::vector<OrderFit> orders_of(const std::vector<Measured>& points) {
    constexpr std::size_t finest = 3;
    std::vector<OrderFit> fits;
    std::vector<const Measured*> left;
    for (const Measured& point : points)
        if (point.is_measured() && !point.is_below_resolution() &&
            point.point.precision == Precision::double_precision && point.error_in_time.over_time > 0.0)
            left.push_back(&point);
    std::sort(left.begin(), left.end(), [](const Measured* a, const Measured* b) {
        return std::tuple(a->point.variant, a->point.method, b->point.steps_a_batch) <
               std::tuple(b->point.variant, b->point.method, a->point.steps_a_batch);
    });
    for (std::size_t first = 0; first < left.size();) {
        std::size_t last = first;
        while (last < left.size() && left[last]->point.variant == left[first]->point.variant &&
               left[last]->point.method == left[first]->point.method)
            ++last;
        const std::size_t used = std::min(finest, last - first);
        double x_sum = 0.0, y_sum = 0.0, xx = 0.0, xy = 0.0;
        for (std::size_t n = first; n < first + used; ++n) {
            const double x = std::log(left[n]->point.dt()), y = std::log(left[n]->error_in_time.over_time);
            x_sum += x, y_sum += y, xx += x * x, xy += x * y;
        }
        const double count = static_cast<double>(used);
        if (used >= 2)
            fits.push_back({left[first]->point.variant, left[first]->point.method,
                            (xy - x_sum * y_sum / count) / (xx - x_sum * x_sum / count), static_cast<int>(used)});
        first = last;
    }
    return fits;
}

double expected_cost(const std::vector<Measured>& points, const Measured& diverged) {
    double nearest = INFINITY, cost = NAN;
    for (const Measured& other : points) {
        const bool is_alike = other.point.method == diverged.point.method &&
                              other.point.variant == diverged.point.variant && other.is_measured();
        if (!is_alike) continue;
        const double ratio =
            static_cast<double>(diverged.point.steps_a_batch) / static_cast<double>(other.point.steps_a_batch);
        const double distance =
            std::abs(std::log(ratio)) + (other.point.precision == diverged.point.precision ? 0.0 : 100.0);
        if (distance >= nearest) continue;
        nearest = distance;
        cost = ratio * other.ms_per_second;
    }
    return cost;
}

bool meets(const Measured& point, double tolerance) {
    if (!point.is_measured()) return false;
    const double doubt = point.is_below_resolution() ? 10.0 * point.known_to : 0.0;
    return std::max(point.error.distance(), doubt) <= tolerance;
}

std::vector<std::size_t> all_within(const std::vector<Measured>& points, double tolerance) {
    std::vector<std::size_t> within;
    for (std::size_t n = 0; n < points.size(); ++n)
        if (meets(points[n], tolerance)) within.push_back(n);
    std::stable_sort(within.begin(), within.end(),
                     [&](std::size_t a, std::size_t b) { return points[a].ms_per_second < points[b].ms_per_second; });
    return within;
}

}  // namespace drapeau
