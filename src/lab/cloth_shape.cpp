#include "cloth_shape.hpp"

#include <glm/geometric.hpp>

#include <algorithm>

namespace drapeau::lab {

namespace {

double square(const glm::dvec3& d) {
    return glm::dot(d, d);
}

}  // namespace

void ClothShape::take(const State<double>& state) {
    constexpr double slack = 1.0 - 1e-6;  // shorter than this share of its rest length: not by rounding
    const auto& x = state.position;
    const auto look = [&](int i, int j, int di, int dj, double rest) {
        if (i + di < 0 || i + di >= grid_.columns || j + dj >= grid_.rows) return;
        ++springs_;
        if (square(x.at(i + di, j + dj) - x.at(i, j)) < slack * slack * rest * rest) ++compressed_;
    };
    for (int j = 0; j < grid_.rows; ++j)
        for (int i = 0; i < grid_.columns; ++i) {
            look(i, j, 1, 0, grid_.pitch_x);
            look(i, j, 0, 1, grid_.pitch_y);
            if (!diagonals_) continue;
            look(i, j, 1, 1, grid_.pitch_diagonal());
            look(i, j, -1, 1, grid_.pitch_diagonal());
        }
    for (int j = 0; j < grid_.rows; ++j) take_line(x, 0, j, 1, 0, grid_.columns, across_);
    for (int i = 0; i < grid_.columns; ++i) take_line(x, i, 0, 0, 1, grid_.rows, down_);
}

void ClothShape::take_line(const FieldBuffer<double>& x, int i, int j, int di, int dj, int count, Folds& folds) const {
    glm::dvec3 before(0.0);
    for (int n = 1; n + 1 < count; ++n) {
        const auto at = [&](int k) { return x.at(i + k * di, j + k * dj); };
        const glm::dvec3 chord = at(n + 1) - at(n - 1);
        glm::dvec3 second = (at(n + 1) - at(n)) - (at(n) - at(n - 1));
        // Only what bends: along the line springs are but differently long.
        if (const double length = square(chord); length > 0.0) second -= (glm::dot(second, chord) / length) * chord;
        folds.second += square(second);
        ++folds.count;
        if (n > 1) folds.third += square(second - before);
        before = second;
    }
}

double ClothShape::compressed_share() const {
    return springs_ > 0 ? static_cast<double>(compressed_) / static_cast<double>(springs_) : 0.0;
}

double ClothShape::Folds::sharpness(double pitch) const {
    return count > 0 ? std::sqrt(second / static_cast<double>(count)) / (pitch * pitch) : 0.0;
}

double ClothShape::Folds::cells() const {
    const double sine = std::clamp(0.5 * std::sqrt(third / second), 0.0, 1.0);  // of half the wave's angle in a cell
    return M_PI / std::asin(sine);
}

const ClothShape::Folds& ClothShape::sharper() const {
    return across_.sharpness(grid_.pitch_x) >= down_.sharpness(grid_.pitch_y) ? across_ : down_;
}

double ClothShape::pitch_of_sharper() const {
    return &sharper() == &across_ ? grid_.pitch_x : grid_.pitch_y;
}

double ClothShape::fold_cells() const {
    constexpr double flat = 1e-6;  // of the distance between masses, that one is off the line of its neighbours
    const Folds& folds = sharper();
    const double pitch = pitch_of_sharper();
    return folds.count > 1 && folds.sharpness(pitch) * pitch > flat ? folds.cells() : NAN;
}

double ClothShape::fold_wavelength() const {
    return pitch_of_sharper() * fold_cells();
}

}  // namespace drapeau::lab
