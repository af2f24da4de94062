// Reference: the same physics written as plainly as can be, in double, one mass after the other: it shares no code with
// the sweep. Springs are found by looking at every pair of masses.
#pragma once

#include "physics_sheet.hpp"

#include <functional>
#include <vector>

namespace drapeau::testing {

/// A small dense symmetric matrix.
struct Matrix {
    int n;
    std::vector<double> of;

    explicit Matrix(int size) : n(size), of(static_cast<std::size_t>(size) * size, 0.0) {}
    double& at(int i, int j) { return of[static_cast<std::size_t>(i) * n + j]; }
    double at(int i, int j) const { return of[static_cast<std::size_t>(i) * n + j]; }

    /// Positive definite: Cholesky's factor exists.
    bool is_positive_definite() const {
        Matrix f = *this;
        for (int j = 0; j < n; ++j) {
            for (int i = j; i < n; ++i) {
                double sum = f.at(i, j);
                for (int k = 0; k < j; ++k) sum -= f.at(i, k) * f.at(j, k);
                if (i == j) {
                    if (!(sum > 0.0)) return false;
                    f.at(j, j) = std::sqrt(sum);
                } else {
                    f.at(i, j) = sum / f.at(j, j);
                }
            }
        }
        return true;
    }
};

/// The largest s in (low, high) for which `holds`, true at low and false at high, to 1e-9 of itself.
inline double last_where(double low, double high, const std::function<bool(double)>& holds) {
    while (high - low > 1e-9 * high) {
        const double middle = 0.5 * (low + high);
        (holds(middle) ? low : high) = middle;
    }
    return low;
}

/// Masses and springs all alike, or those of cloth whose borders are as light as what they stand for.
class Reference {
public:
    struct Spring {
        int a, b;
        double k, rest, c;
    };

    explicit Reference(const Model& model, Borders borders = Borders::alike) : model_(model), count_(masses_of(model)) {
        const Grid& grid = model.grid;
        const bool light = borders == Borders::light;
        const auto on_side = [&](int n) {
            return light && grid.columns > 1 && (n % grid.columns == 0 || n % grid.columns == grid.columns - 1);
        };
        const auto on_end = [&](int n) {
            return light && grid.rows > 1 && (n / grid.columns == 0 || n / grid.columns == grid.rows - 1);
        };
        for (int n = 0; n < count_; ++n) shares_.push_back((on_side(n) ? 0.5 : 1.0) * (on_end(n) ? 0.5 : 1.0));
        for (int a = 0; a < count_; ++a)
            for (int b = a + 1; b < count_; ++b) {
                const int across = std::abs(b % grid.columns - a % grid.columns);
                const int down = b / grid.columns - a / grid.columns;
                const double rest = std::sqrt(across * across * grid.pitch_x * grid.pitch_x +
                                              down * down * grid.pitch_y * grid.pitch_y);
                const double c = model.springs.damping.value_or(0.0);
                // A border's own springs stand for half as wide a strip of cloth as those inside.
                const bool along_border =
                    (on_side(a) && on_side(b) && across == 0) || (on_end(a) && on_end(b) && down == 0);
                const double share = along_border ? 0.5 : 1.0;
                const double stiffer = down == 1 ? model.springs.along_hoist : 1.0;
                if (across + down == 1)
                    springs_.push_back({a, b, share * stiffer * model.springs.stiffness, rest, share * stiffer * c});
                else if (across == 1 && down == 1 && model.springs.diagonal_stiffness)
                    springs_.push_back(
                        {a, b, *model.springs.diagonal_stiffness, rest, model.springs.diagonal_damping * c});
            }
        if (const auto& term = model.terms.get<Gravity>()) gravity_ = term->acceleration;
        if (const auto& term = model.terms.get<AirDrag>()) drag_ = term->d;
        if (const auto& term = model.terms.get<Friction>()) friction_ = term->c_f;
        if (const auto& term = model.terms.get<Wind>()) wind_ = *term;
        if (const auto& term = model.terms.get<Air>()) air_ = *term;
        bending_ = model.terms.get<Bending>();
    }

    const std::vector<Spring>& springs() const { return springs_; }
    double mass(int n) const { return shares_[n] * model_.springs.mass; }

    /// Force of the springs on every mass (N). If `sizes` is given: the sum of the magnitudes k l + k L + |c v| that
    /// met at each mass, what rounding errors are measured against.
    Points forces(const Points& x, const Points& v, std::vector<double>* sizes = nullptr) const {
        Points f(x.size(), glm::dvec3(0.0));
        if (sizes) sizes->assign(x.size(), 0.0);
        for (const auto& s : springs_) {
            const auto d = x[s.b] - x[s.a];
            const double l = length(d);
            if (l == 0.0) continue;
            const auto e = d / l;
            const double tension = s.k * (l - s.rest) + s.c * dot(v[s.b] - v[s.a], e);
            f[s.a] += tension * e;
            f[s.b] -= tension * e;
            if (sizes)
                for (const int n : {s.a, s.b}) (*sizes)[n] += s.k * (l + s.rest) + s.c * length(v[s.b] - v[s.a]);
        }
        return f;
    }

    /// What the springs hold (J).
    double elastic_energy(const Points& x) const {
        double sum = 0.0;
        for (const auto& s : springs_) sum += 0.5 * s.k * std::pow(length(x[s.b] - x[s.a]) - s.rest, 2);
        return sum;
    }
    /// The springs' greatest stretch (share).
    double max_stretch(const Points& x) const {
        double most = -1.0;
        for (const auto& s : springs_) most = std::max(most, length(x[s.b] - x[s.a]) / s.rest - 1.0);
        return most;
    }

    /// Force (N) of the air on mass n's share of the cloth, that the wind (m/s) passes.
    glm::dvec3 air_force(const Points& x, const Points& v, int n, const glm::dvec3& wind) const {
        const Grid& grid = model_.grid;
        if (!air_ || grid.columns == 1 || grid.rows == 1) return glm::dvec3(0.0);
        const int i = n % grid.columns, j = n / grid.columns;
        const int left = std::max(i - 1, 0), right = std::min(i + 1, grid.columns - 1);
        const int above = std::max(j - 1, 0), below = std::min(j + 1, grid.rows - 1);
        const auto at = [&](int column, int row) { return x[row * grid.columns + column]; };
        const auto face = cross(at(right, j) - at(left, j), at(i, above) - at(i, below));
        const auto normal = face / length(face), u = wind - v[n], across = dot(u, normal) * normal, along = u - across;
        const double area = grid.pitch_x * (right - left) / 2.0 * grid.pitch_y * (below - above) / 2.0;
        return 0.5 * air_->density * area *
               (air_->pressure.value_or(0.0) * length(across) * across +
                air_->skin.value_or(0.0) * length(along) * along);
    }

    /// Force (N) on every mass of what its lines bend with, and brake it with: of each three in a line, their own.
    Points bending_forces(const Points& x, const Points& v) const {
        Points f(x.size(), glm::dvec3(0.0));
        if (!bending_) return f;
        const Grid& grid = model_.grid;
        const auto bend = [&](int left, int n, int right, double share, double length, double width) {
            const double k = share * bending_->stiffness * width / std::pow(length, 3);
            const double c = share * bending_->damping.value_or(0.0) * model_.springs.mass / 16.0;
            const auto resistance = k * (x[left] - 2.0 * x[n] + x[right]) + c * (v[left] - 2.0 * v[n] + v[right]);
            f[left] -= resistance, f[n] += 2.0 * resistance, f[right] -= resistance;
        };
        const bool light = shares_.front() < 1.0;
        for (int j = 0; j < grid.rows; ++j)
            for (int i = 0; i < grid.columns; ++i) {
                const int n = j * grid.columns + i;
                const bool on_end = light && grid.rows > 1 && (j == 0 || j == grid.rows - 1);
                const bool on_side = light && grid.columns > 1 && (i == 0 || i == grid.columns - 1);
                if (i > 0 && i + 1 < grid.columns)
                    bend(n - 1, n, n + 1, on_end ? 0.5 : 1.0, grid.pitch_x, grid.pitch_y);
                if (j > 0 && j + 1 < grid.rows)
                    bend(n - grid.columns, n, n + grid.columns, on_side ? 0.5 : 1.0, grid.pitch_y, grid.pitch_x);
            }
        return f;
    }

    /// Acceleration of every mass at time t (s); none where attached.
    Points acceleration(const Points& x, const Points& v, double t) const {
        Points a = forces(x, v);
        const Points bent = bending_forces(x, v);
        for (int n = 0; n < count_; ++n) {
            a[n] += bent[n];
            const auto wind = wind_.at(t, model_.grid.rest(n % model_.grid.columns, n / model_.grid.columns));
            a[n] =
                gravity_ +
                (a[n] + shares_[n] * (drag_ * (wind - v[n]) - friction_ * v[n]) + air_force(x, v, n, wind)) / mass(n);
            if (is_held(model_, n)) a[n] = glm::dvec3(0.0);
        }
        return a;
    }

    /// The classical Runge-Kutta method of order 4, from time 0.
    void runge_kutta(Points& x, Points& v, double dt, int steps) const {
        const auto moved = [](const Points& from, double by, const Points& along) {
            Points to = from;
            for (std::size_t n = 0; n < to.size(); ++n) to[n] += by * along[n];
            return to;
        };
        for (int step = 0; step < steps; ++step) {
            const double t = step * dt;
            const auto v1 = v, a1 = acceleration(x, v, t);
            const auto v2 = moved(v, 0.5 * dt, a1), a2 = acceleration(moved(x, 0.5 * dt, v1), v2, t + 0.5 * dt);
            const auto v3 = moved(v, 0.5 * dt, a2), a3 = acceleration(moved(x, 0.5 * dt, v2), v3, t + 0.5 * dt);
            const auto v4 = moved(v, dt, a3), a4 = acceleration(moved(x, dt, v3), v4, t + dt);
            for (std::size_t n = 0; n < x.size(); ++n) {
                x[n] += dt / 6.0 * (v1[n] + 2.0 * v2[n] + 2.0 * v3[n] + v4[n]);
                v[n] += dt / 6.0 * (a1[n] + 2.0 * a2[n] + 2.0 * a3[n] + a4[n]);
            }
        }
    }

    /// s_M M + s_K K + s_C C + s_D D over the free masses at the configuration x: K the springs' Hessian
    /// k [e e^T + (1 - L/l) (I - e e^T)], C their dampers c e e^T, D drag and friction.
    Matrix combined(const Points& x, double s_M, double s_K, double s_C, double s_D) const {
        std::vector<int> free(x.size(), -1);
        int count = 0;
        for (int n = 0; n < count_; ++n)
            if (!is_held(model_, n)) free[n] = count++;
        Matrix sum(3 * count);
        for (int n = 0; n < count_; ++n)
            for (int p = 0; p < 3 && free[n] >= 0; ++p)
                sum.at(3 * free[n] + p, 3 * free[n] + p) = s_M * mass(n) + s_D * shares_[n] * (drag_ + friction_);
        for (const auto& s : springs_) {
            const auto d = x[s.b] - x[s.a];
            const double l = length(d);
            const auto e = d / l;
            const double across = s_K * s.k * (1.0 - s.rest / l), along = s_K * s.k + s_C * s.c;
            for (int p = 0; p < 3; ++p)
                for (int q = 0; q < 3; ++q) {
                    const double h = (along - across) * e[p] * e[q] + (p == q ? across : 0.0);
                    const int a = free[s.a], b = free[s.b];
                    if (a >= 0) sum.at(3 * a + p, 3 * a + q) += h;
                    if (b >= 0) sum.at(3 * b + p, 3 * b + q) += h;
                    if (a >= 0 && b >= 0) sum.at(3 * a + p, 3 * b + q) -= h, sum.at(3 * b + p, 3 * a + q) -= h;
                }
        }
        return sum;
    }

    /// Largest eigenvalue (1/s2) of M^-1 K at x.
    double max_eigenvalue(const Points& x) const {
        double high = 0.0;
        for (const auto& s : springs_) high += 4.0 * s.k / std::min(mass(s.a), mass(s.b));
        return last_where(0.0, high, [&](double shift) {  // shift M - K is definite only above it
            return !combined(x, shift, -1.0, 0.0, 0.0).is_positive_definite();
        });
    }

private:
    Model model_;
    int count_;
    std::vector<double> shares_;  // of the mass and the drag
    std::vector<Spring> springs_;
    glm::dvec3 gravity_{0.0};
    double drag_ = 0.0, friction_ = 0.0;
    Wind wind_;
    std::optional<Air> air_;
    std::optional<Bending> bending_;
};

}  // namespace drapeau::testing
