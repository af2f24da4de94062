#include "force_scale.hpp"

#include <algorithm>
#include <cmath>

namespace drapeau {

namespace {

constexpr int most_sampled = 10000;  // springs looked at
constexpr double least = 1e-6;       // N
constexpr double fall = 0.96;        // of the level, each batch
constexpr double hysteresis = 0.7;   // the scale shrinks only when the level is well below it

double rms_force(const Snapshot& s, const Scene& scene) {
    const double cell_x = s.columns > 1 ? scene.flag.width / (s.columns - 1) : 0.0;
    const double cell_y = s.rows > 1 ? scene.flag.height / (s.rows - 1) : 0.0;
    const int every = std::max(1, s.columns * s.rows / most_sampled);
    double sum = 0.0;
    int count = 0;
    const auto look = [&](int from, int to, double rest) {
        const double dx = s.x[to] - s.x[from], dy = s.y[to] - s.y[from], dz = s.z[to] - s.z[from];
        const double force = scene.springs.stiffness * (std::sqrt(dx * dx + dy * dy + dz * dz) - rest);
        sum += force * force;
        ++count;
    };
    for (int mass = 0; mass < s.columns * s.rows; mass += every) {
        const int column = mass % s.columns, row = mass / s.columns, at = row * s.stride + column;
        if (column + 1 < s.columns) look(at, at + 1, cell_x);
        if (row + 1 < s.rows) look(at, at + s.stride, cell_y);
    }
    return count > 0 ? std::sqrt(sum / count) : 0.0;
}

}  // namespace

double rounded_up(double value) {
    if (!(value > least)) return least;
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0})
        if (value <= step * decade * (1.0 + 1e-9)) return step * decade;
    return 10.0 * decade;
}

void ForceScale::follow(const Snapshot& snapshot, const Scene& scene) {
    const double force = 2.0 * rms_force(snapshot, scene);
    if (!std::isfinite(force)) return;
    level_ = std::max(force, level_ * fall);
    const double wanted = rounded_up(level_);
    if (wanted > shown_ || level_ < hysteresis * rounded_up(0.4 * shown_)) shown_ = wanted;
}

}  // namespace drapeau
