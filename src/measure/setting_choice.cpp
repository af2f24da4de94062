#include "measure/setting_choice.hpp"

#include "io/error.hpp"
#include "measure/trade_analysis.hpp"
#include "run/step_choice.hpp"

#include <array>
#include <cmath>

namespace drapeau {

namespace {

/// s; 0 where the method takes none of its own accord.
double automatic_step_of(Scene scene, Method method, const Model& model) {
    scene.time.method = method;
    scene.time.dt.reset();
    try {
        return chosen_step(scene, model, false, 1.0);
    } catch (const InputError&) {
        return 0.0;
    }
}

}  // namespace

double error_rate(const Measured& point, double seconds) {
    return point.error.at_end / seconds;
}

std::vector<char> within_automatic_step(const Scene& scene, const std::vector<Measured>& points) {
    constexpr double as_long = 1.0 + 1e-9;
    const Model model = model_of(scene);
    std::array<double, method_count> longest{};
    for (std::size_t n = 0; n < method_count; ++n) longest[n] = automatic_step_of(scene, static_cast<Method>(n), model);
    std::vector<char> within;
    for (const Measured& measured : points)
        within.push_back(measured.point.dt() <= as_long * longest[static_cast<std::size_t>(measured.point.method)]);
    return within;
}

SettingChoice choose_setting(const std::vector<Measured>& points, const std::vector<char>& allowed, double seconds,
                             double tolerance, double most) {
    SettingChoice choice;
    for (const std::size_t n : all_within(points, tolerance * seconds)) {
        if (!allowed[n]) continue;
        if (!choice.chosen) {
            choice.chosen = n;
        } else if (points[n].point.method != points[*choice.chosen].point.method) {
            choice.next = n;
            break;
        }
    }
    choice.keeps_up = choice.chosen && points[*choice.chosen].ms_per_second <= most;
    if (choice.keeps_up) return choice;
    double least = INFINITY;
    for (std::size_t n = 0; n < points.size(); ++n) {
        const Measured& point = points[n];
        if (!allowed[n] || !point.is_measured() || !(point.ms_per_second <= most)) continue;
        const double distance = std::max(point.error.distance(), point.known_to);
        if (!(distance < least)) continue;
        least = distance;
        choice.nearest = n;
    }
    return choice;
}

}  // namespace drapeau
