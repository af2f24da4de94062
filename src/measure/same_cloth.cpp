#include "measure/same_cloth.hpp"

#include "scene/file.hpp"

#include <algorithm>
#include <cmath>

namespace drapeau {

namespace {

/// The natural cubic spline through values one apart.
class Spline {
public:
    explicit Spline(std::vector<glm::dvec3> values) : y_(std::move(values)), m_(y_.size(), glm::dvec3(0.0)) {
        // m[i-1] + 4 m[i] + m[i+1] = 6 (y[i-1] - 2 y[i] + y[i+1]), m = 0 at both ends: Thomas' algorithm.
        const std::size_t n = y_.size();
        std::vector<double> c(n, 0.0);
        for (std::size_t i = 1; i + 1 < n; ++i) {
            const double pivot = 4.0 - c[i - 1];
            c[i] = 1.0 / pivot;
            m_[i] = (6.0 * ((y_[i + 1] - y_[i]) - (y_[i] - y_[i - 1])) - m_[i - 1]) / pivot;
        }
        for (std::size_t i = n; i-- > 2;) m_[i - 1] -= c[i - 1] * m_[i];
    }

    /// Between value i and the next, `b` of the way.
    glm::dvec3 at(std::size_t i, double b) const {
        if (b == 0.0) return y_[i];
        const double a = 1.0 - b;
        return a * y_[i] + b * y_[i + 1] + ((a * a * a - a) / 6.0) * m_[i] + ((b * b * b - b) / 6.0) * m_[i + 1];
    }

private:
    std::vector<glm::dvec3> y_, m_;  // values and second derivatives
};

FieldBuffer<double> finer(const FieldBuffer<double>& coarse, int times) {
    const int columns = (coarse.columns() - 1) * times + 1, rows = (coarse.rows() - 1) * times + 1;
    const auto place = [&](int n) { return static_cast<std::size_t>(n / times); };
    const auto share = [&](int n) { return static_cast<double>(n % times) / times; };
    FieldBuffer<double> wide(columns, coarse.rows()), all(columns, rows);
    for (int j = 0; j < coarse.rows(); ++j) {
        std::vector<glm::dvec3> row;
        for (int i = 0; i < coarse.columns(); ++i) row.push_back(coarse.at(i, j));
        const Spline spline(std::move(row));
        for (int i = 0; i < columns; ++i) wide.set(i, j, spline.at(place(i), share(i)));
    }
    for (int i = 0; i < columns; ++i) {
        std::vector<glm::dvec3> column;
        for (int j = 0; j < coarse.rows(); ++j) column.push_back(wide.at(i, j));
        const Spline spline(std::move(column));
        for (int j = 0; j < rows; ++j) all.set(i, j, spline.at(place(j), share(j)));
    }
    return all;
}

}  // namespace

Scene same_cloth(const Scene& scene, int columns, int rows) {
    Scene other = scene;
    other.flag.columns = columns;
    other.flag.rows = rows;
    if (other.fabric) {
        check_scene(other);
        return other;
    }
    const auto cells = [](int masses) { return static_cast<double>(std::max(1, masses - 1)); };
    const double across = cells(columns) / cells(scene.flag.columns), down = cells(rows) / cells(scene.flag.rows);
    // Springs in a line over lines of springs; a chain is one line.
    const double fly = across / down, hoist = down / across;
    const double stiffer = rows == 1 ? across : columns == 1 ? down : std::sqrt(fly * hoist);
    SpringSettings& springs = *other.springs;
    springs.mass /= across * down;
    springs.stiffness *= stiffer;
    if (springs.diagonal_stiffness) *springs.diagonal_stiffness *= stiffer;
    if (springs.damping) *springs.damping *= stiffer;
    if (springs.drag) *springs.drag /= across * down;
    if (springs.friction) *springs.friction /= across * down;
    check_scene(other);
    return other;
}

Model model_with(const Scene& scene, Borders borders) {
    const Model alike = model_of(scene);
    if (scene.fabric) return alike;
    return Model(alike.grid, alike.springs, scene.flag.attach, alike.terms, alike.limits, borders);
}

State<double> on_finer_grid(const State<double>& coarse, int times) {
    if (times == 1) return coarse;
    State<double> state((coarse.columns() - 1) * times + 1, (coarse.rows() - 1) * times + 1);
    state.position = finer(coarse.position, times);
    state.velocity = finer(coarse.velocity, times);
    return state;
}

void hold_fast(State<double>& state, const Model& model, double prestretch) {
    for (int j = 0; j < state.rows(); ++j)
        for (int i = 0; i < state.columns(); ++i) {
            if (!model.held(i, j)) continue;
            state.position.set(i, j, (1.0 + prestretch) * model.grid.rest(i, j));
            state.velocity.set(i, j, glm::dvec3(0.0));
        }
}

}  // namespace drapeau
