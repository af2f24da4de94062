// Pull: a hand that takes hold of the cloth at one place and pulls through a spring and a damper, after every move.
//
// What is held is a patch: the free mass that is nearest to the place and its neighbours within 5 cm, with weights
// that fall off smoothly, moved as one degree of freedom. The force is that of the step's end (backward Euler): it
// makes the patch heavier by dt C + dt2 K for all that pushes it within the step, so no limit of stability is lowered.
// A method that solves for the springs takes the push at the beginning of a step instead, as velocity alone: the solve
// spreads it, and what the springs about the patch resist with belongs to its mass when the force is found. Its steps
// are large, so the patch is too (a third of the flag's shorter side), and would move by a fiftieth of that at most.
//
// However far away the hand is, the spring pulls with `strongest` at most, a quarter of what would double the length of
// the threads that are held (and 40 times the flag's weight at 9.8 m/s2), and the damper takes all of that at 10 m/s: a
// hand neither tears the cloth nor makes it faster than that. Its work is counted as that of a pass (energy.hpp).
#pragma once

#include "drapeau/model.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// Where a hand holds and where it pulls to.
struct Pull {
    double across = 0.0, down = 0.0;  // the place held, in shares of the flag from its hoist and from its top
    glm::dvec3 target{0.0};           // m, where the hand is

    bool operator==(const Pull&) const = default;
};

/// What a hand did, summed over steps.
struct PullReport {
    double seconds = 0.0;     // s, that it held
    glm::dvec3 impulse{0.0};  // N s
    double gross = 0.0;       // J, more than all the energy that it moved, whatever its sign

    double force() const {  // N, the mean
        const auto& i = impulse;
        return seconds > 0.0 ? std::sqrt(i.x * i.x + i.y * i.y + i.z * i.z) / seconds : 0.0;
    }
    void add(const PullReport& other) {
        seconds += other.seconds;
        impulse += other.impulse;
        gross += other.gross;
    }
};

/// The free mass nearest to a place of the flag at rest, the first in the order of rows among equals: its column and
/// row. None where every mass is held.
template <class IsHeld>
std::optional<std::pair<int, int>> nearest_free(const Grid& grid, double across, double down, const IsHeld& held) {
    std::optional<std::pair<int, int>> nearest;
    double least = std::numeric_limits<double>::infinity();
    for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i) {
            const double x = (i - across * (grid.columns - 1)) * grid.pitch_x;
            const double y = (j - down * (grid.rows - 1)) * grid.pitch_y;
            if (const double square = x * x + y * y; square < least && !held(i, j)) {
                least = square;
                nearest = {i, j};
            }
        }
    return nearest;
}

/// A patch of the cloth in a hand.
class Grip {
public:
    Grip() = default;
    Grip(const Model& model, const Pull& pull, bool solves) : target_(pull.target) {
        if (solves) radius_ = std::fmax(radius_, wide * shorter_side(model.grid));
        const auto held = [&](int i, int j) { return model.held(i, j); };
        const auto middle = nearest_free(model.grid, pull.across, pull.down, held);
        if (!middle) return;
        gather(model, middle->first, middle->second);
        stiffness_ = model.total_mass() * rate * rate;
        strongest_ = std::fmin(most_acceleration * model.total_mass(), 0.25 * threads_ * weakest_thread(model));
        damping_ = strongest_ / fastest;
    }

    bool holds() const { return !shares_.empty(); }
    double strongest() const { return strongest_; }  // N
    double stiffness() const { return stiffness_; }  // N/m, between hand and patch

    template <class Real>
    glm::dvec3 place(const Field<Real>& position) const {  // m, of the patch
        glm::dvec3 sum(0.0);
        for (const Share& share : shares_) sum += share.of_place * at(position, share);
        return sum;
    }

    /// Adds to velocities what the hand gives in a step of dt (s), and to places what follows: after a step, or before
    /// one where the method `solves`, which moves them itself.
    template <class Real, class Follow>
    void pull(const Field<Real>* fields, double dt, bool solves, PullReport& report, const Follow& follow) const {
        const glm::dvec3 here = place(fields[0]), velocity = place(fields[1]);
        const double met = mass_ + (solves ? dt * own_damping_ + dt * dt * own_stiffness_ : 0.0);  // kg
        glm::dvec3 force = force_on(here, velocity, dt, met);
        const double most = 0.02 * radius_ * mass_ / (dt * dt), size = std::sqrt(dot(force, force));
        if (solves && size > most) force *= most / size;
        const glm::dvec3 faster = dt / met * force, push = dt / mass_ * force;  // m/s, of the patch
        report.seconds += dt;
        report.impulse += dt * force;
        report.gross +=
            met * dot(faster, faster) + mass_ * std::abs(dot(velocity, faster)) + dt * std::abs(dot(force, faster));
        for (const Share& share : shares_) {
            const glm::dvec3 dv = share.of_motion * push;
            follow(fields, share.row * fields[0].stride + share.column,
                   rounded<Real>(solves ? glm::dvec3(0.0) : dt * dv), rounded<Real>(dv));
        }
    }

private:
    static constexpr double wide = 1.0 / 3.0;           // of the flag's shorter side
    static constexpr double radius = 0.05;              // m
    static constexpr double rate = 20.0;                // 1/s, at which the spring would swing the whole flag
    static constexpr double fastest = 10.0;             // m/s
    static constexpr double most_acceleration = 392.0;  // m/s2, of the whole flag

    struct Share {
        int column, row;
        double of_place, of_motion;  // g of the patch's place is sum g x; its motion moves a mass by so many of its own
    };

    static double dot(const glm::dvec3& a, const glm::dvec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    template <class Real>
    static glm::dvec3 at(const Field<Real>& field, const Share& share) {
        const std::ptrdiff_t n = share.row * field.stride + share.column;
        return {static_cast<double>(field.x[n]), static_cast<double>(field.y[n]), static_cast<double>(field.z[n])};
    }
    template <class Real>
    static Vec3<Real> rounded(const glm::dvec3& a) {
        return {static_cast<Real>(a.x), static_cast<Real>(a.y), static_cast<Real>(a.z)};
    }

    /// N, from where and how fast the patch would be at the step's end without it.
    glm::dvec3 force_on(const glm::dvec3& here, const glm::dvec3& velocity, double dt, double met) const {
        const glm::dvec3 far = target_ - here;
        const glm::dvec3 force =
            met / (met + dt * damping_ + dt * dt * stiffness_) * (stiffness_ * far - damping_ * velocity);
        const glm::dvec3 left = stiffness_ * (far - dt * dt / met * force);
        if (dot(left, left) <= strongest_ * strongest_) return force;
        const glm::dvec3 most = strongest_ / std::sqrt(dot(left, left)) * left;
        return met / (met + dt * damping_) * (most - damping_ * velocity);
    }

    static double shorter_side(const Grid& grid) {  // m
        const double fly = (grid.columns - 1) * grid.pitch_x, hoist = (grid.rows - 1) * grid.pitch_y;
        return grid.columns == 1 ? hoist : grid.rows == 1 ? fly : std::fmin(fly, hoist);
    }

    /// N, what would double the length of one thread, along the fly or down the hoist.
    static double weakest_thread(const Model& model) {
        const Grid& grid = model.grid;
        const double k = model.springs.stiffness;
        const double fly = grid.columns > 1 ? k * grid.pitch_x : INFINITY;
        const double hoist = grid.rows > 1 ? k * model.springs.along_hoist * grid.pitch_y : INFINITY;
        return std::fmin(fly, hoist);
    }

    void gather(const Model& model, int column, int row) {
        const Grid& grid = model.grid;
        const int reach_x = static_cast<int>(radius_ / grid.pitch_x),
                  reach_y = static_cast<int>(radius_ / grid.pitch_y);
        const auto weight = [&](int i, int j) {
            if (i < 0 || j < 0 || i >= grid.columns || j >= grid.rows || model.held(i, j)) return 0.0;
            const double x = (i - column) * grid.pitch_x / radius_, y = (j - row) * grid.pitch_y / radius_;
            const double left = std::fmax(0.0, 1.0 - x * x - y * y);
            return i == column && j == row ? 1.0 : left * left;
        };
        double sum = 0.0, squares = 0.0, weights = 0.0, weight_squares = 0.0, resisted = 0.0;
        const auto across = [&](double w, int i, int j, double k) {
            const double apart = w - weight(i, j);
            resisted += k * apart * apart;
        };
        const double k = model.springs.stiffness, kd = model.springs.diagonal_stiffness.value_or(0.0);
        for (int j = std::max(0, row - reach_y - 1); j <= std::min(grid.rows - 1, row + reach_y + 1); ++j)
            for (int i = std::max(0, column - reach_x - 1); i <= std::min(grid.columns - 1, column + reach_x + 1);
                 ++i) {
                const double w = weight(i, j), m = model.mass(i, j);
                if (i + 1 < grid.columns) across(w, i + 1, j, k);
                if (j + 1 < grid.rows) across(w, i, j + 1, k * model.springs.along_hoist);
                if (j + 1 < grid.rows && i + 1 < grid.columns) across(w, i + 1, j + 1, kd);
                if (j + 1 < grid.rows && i > 0) across(w, i - 1, j + 1, kd);
                if (w == 0.0) continue;
                shares_.push_back({i, j, m * w, w});
                sum += m * w, squares += m * w * w, weights += w, weight_squares += w * w;
            }
        mass_ = sum * sum / squares;
        for (Share& share : shares_) share.of_place /= sum, share.of_motion *= sum / squares;
        own_stiffness_ = resisted * (sum / squares) * (sum / squares);
        own_damping_ = k > 0.0 ? own_stiffness_ * model.springs.damping.value_or(0.0) / k : 0.0;
        threads_ = std::sqrt(weights * weights / weight_squares);
    }

    std::vector<Share> shares_;
    double radius_ = radius;                          // m, of the patch
    glm::dvec3 target_{0.0};                          // m
    double mass_ = 0.0;                               // kg, of the patch as one
    double own_stiffness_ = 0.0, own_damping_ = 0.0;  // N/m and N s/m, of the cloth against its motion, at most
    double stiffness_ = 0.0, damping_ = 0.0;          // N/m and N s/m, of the hand
    double strongest_ = 0.0;                          // N, of its spring
    double threads_ = 1.0;                            // that share the pull
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
