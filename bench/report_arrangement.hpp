// The report's own arrangement (section 4.2), the baseline of the benchmark: an object per mass, a loop over the masses
// from right to left and bottom to top, and a function for the force of one spring.
//
// Each spring is computed once, by the mass at its lower or right end. That mass adds the force to its own; the
// opposite is stored with the neighbour, whose turn comes later (the report's forceExterieur). When a mass has had its
// turn nobody needs its old position any more, so it moves at once.
#pragma once

#include "drapeau/model.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace drapeau {

/// What acts on the masses of the report's flag, besides its springs.
struct ReportSurroundings {
    glm::dvec3 gravity{0.0, -9.8, 0.0};  // m/s2
    glm::dvec3 wind{0.0};                // m/s
    double drag = 0.0;                   // N s/m
};

template <class Real>
class ReportArrangement {
public:
    using vec3 = glm::vec<3, Real>;

    /// All masses at rest at their places in the grid. Here, because grid and springs are those of whoever calls it,
    /// who need not be compiled for the same instruction set (isa.hpp).
    ReportArrangement(const Grid& grid, Attach attach, const Springs& springs, const ReportSurroundings& around)
        : columns_(grid.columns),
          rows_(grid.rows),
          mass_(static_cast<Real>(springs.mass)),
          gravity_(around.gravity),
          wind_(around.wind),
          drag_(static_cast<Real>(around.drag)),
          diagonals_(springs.diagonal_stiffness.has_value()),
          masses_(static_cast<std::size_t>(grid.masses())) {
        const auto spring = [&](double k, double length) {
            return Spring{static_cast<Real>(k), static_cast<Real>(springs.damping.value_or(0.0)),
                          static_cast<Real>(length)};
        };
        along_fly_ = spring(springs.stiffness, grid.pitch_x);
        down_hoist_ = spring(springs.stiffness, grid.pitch_y);
        diagonal_ = spring(springs.diagonal_stiffness.value_or(0.0), grid.pitch_diagonal());
        for (int j = 0; j < rows_; ++j)
            for (int i = 0; i < columns_; ++i)
                mass(i, j) = {vec3(grid.rest(i, j)), vec3(0), vec3(0), vec3(0), is_attached(attach, grid, i, j)};
    }

    /// Takes `steps` steps of dt seconds with semi-implicit Euler (report, eqs. 8 and 9).
    void advance(double dt, int steps);

    glm::dvec3 position(int i, int j) const { return mass(i, j).position; }
    glm::dvec3 velocity(int i, int j) const { return mass(i, j).velocity; }
    void set(int i, int j, const glm::dvec3& position, const glm::dvec3& velocity);

private:
    struct Mass {
        vec3 position, velocity;
        vec3 force;
        vec3 stored_force;  // forceExterieur: what springs computed by other masses do to this one
        bool attached;
    };
    struct Spring {
        Real stiffness, damping, length;  // N/m, N s/m, m
    };

    Mass& mass(int i, int j) { return masses_[static_cast<std::size_t>(j) * columns_ + i]; }
    const Mass& mass(int i, int j) const { return masses_[static_cast<std::size_t>(j) * columns_ + i]; }
    void compute_force(int i, int j);
    void move(Mass& mass, Real dt, Real dt_over_m) const;

    int columns_, rows_;
    Real mass_;  // kg, of each
    vec3 gravity_, wind_;
    Real drag_;
    Spring along_fly_, down_hoist_, diagonal_;
    bool diagonals_;
    std::vector<Mass> masses_;
};

}  // namespace drapeau
