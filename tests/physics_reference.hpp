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

class Reference {
public:
    struct Spring {
        int a, b;
        double k, rest, c;
    };

    explicit Reference(const Setting& setting) : setting_(setting) {
        const Grid& grid = setting.grid;
        for (int a = 0; a < setting.masses(); ++a)
            for (int b = a + 1; b < setting.masses(); ++b) {
                const int across = std::abs(b % grid.columns - a % grid.columns);
                const int down = b / grid.columns - a / grid.columns;
                const double rest = std::sqrt(across * across * grid.pitch_x * grid.pitch_x +
                                              down * down * grid.pitch_y * grid.pitch_y);
                const double c = setting.material.damping.value_or(0.0);
                if (across + down == 1)
                    springs_.push_back({a, b, setting.material.stiffness, rest, c});
                else if (across == 1 && down == 1 && setting.material.diagonal_stiffness)
                    springs_.push_back({a, b, *setting.material.diagonal_stiffness, rest, c});
            }
    }

    const std::vector<Spring>& springs() const { return springs_; }

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

    /// Acceleration of every mass at time t (s); none where attached.
    Points acceleration(const Points& x, const Points& v, double t) const {
        const double m = setting_.material.mass;
        const auto wind = setting_.wind.velocity(t);
        Points a = forces(x, v);
        for (int n = 0; n < setting_.masses(); ++n) {
            a[n] = setting_.gravity + (a[n] + setting_.drag * (wind - v[n]) - setting_.friction * v[n]) / m;
            if (setting_.held(n)) a[n] = glm::dvec3(0.0);
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

    /// s_M M + s_K K + s_C C over the free masses at the configuration x: K the springs' Hessian
    /// k [e e^T + (1 - L/l) (I - e e^T)], C their dampers c e e^T with drag and friction on the diagonal.
    Matrix combined(const Points& x, double s_M, double s_K, double s_C) const {
        std::vector<int> free(x.size(), -1);
        int count = 0;
        for (int n = 0; n < setting_.masses(); ++n)
            if (!setting_.held(n)) free[n] = count++;
        Matrix sum(3 * count);
        const double own = s_M * setting_.material.mass + s_C * (setting_.drag + setting_.friction);
        for (int n = 0; n < 3 * count; ++n) sum.at(n, n) = own;
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

    /// Largest eigenvalue (N/m) of K at x.
    double greatest_eigenvalue(const Points& x) const {
        double high = 0.0;
        for (const auto& s : springs_) high += 4.0 * s.k;
        const double m = setting_.material.mass;
        return last_where(0.0, high, [&](double shift) {  // shift I - K is definite only above it
            return !combined(x, shift / m, -1.0, 0.0).is_positive_definite();
        });
    }

private:
    Setting setting_;
    std::vector<Spring> springs_;
};

}  // namespace drapeau::testing
