// CoarseMasses: what is too long is shortened coarse to fine, so that a cloth that is far too long takes no more sweeps
// the more masses it has (after the multi-resolution of Wang, O'Brien and Ramamoorthi 2010).
//
// Masses 2^n apart are no farther apart than the springs between them permit: a way along springs that are short enough
// is never longer than that, so nothing is asked for that the springs do not ask for. What moves two coarse masses
// moves those between them by linear shares. A coarse mass is as heavy as the shares that it moves: linear momentum is
// kept; angular momentum is not, quite.
#pragma once

#include "drapeau/limits/extra/lattice.hpp"

#include <algorithm>
#include <utility>

namespace drapeau {
inline namespace DRAPEAU_ISA {

template <class Real>
class CoarseMasses {
public:
    CoarseMasses() = default;
    explicit CoarseMasses(const Grid& grid)
        : x_(nodes_of(grid.columns, 2), nodes_of(grid.rows, 2), 0),
          before_(x_.columns(), x_.rows(), 1),
          inverse_mass_(x_.component(0).size()) {}

    /// Shortens lines (Lattice::shorten) of the coarsest masses first, those of every other mass last.
    void shorten(const Grid& grid, bool diagonals, const RowConstants<Real>* constants, const Field<Real>& x,
                 double longest, double beyond, TautLine& taut) {
        int coarsest = 1;
        while (2 * coarsest < std::max(grid.columns, grid.rows)) coarsest *= 2;
        for (int apart = coarsest; apart > 1; apart /= 2) {
            weigh(grid, apart, constants);
            const Lattice nodes{grid, apart, x_.view(), [&](int I, int J) { return inverse_mass_[element(I, J)]; }};
            for (int J = 0; J < nodes.rows; ++J)
                for (int I = 0; I < nodes.columns; ++I) {
                    const int i = std::min(I * apart, grid.columns - 1), j = std::min(J * apart, grid.rows - 1);
                    const auto place = x.template at<Real>(j * x.stride + i);
                    nodes.x.set(element(I, J), place), before_.view().set(element(I, J), place);
                    double& w = inverse_mass_[element(I, J)];  // the mass until now
                    w = constants[j].inverse_mass[i] > 0 ? 1.0 / w : 0.0;
                }
            double excess = 0.0;
            for (const Along along : all_lines)
                if (diagonals || along < Along::falling)
                    nodes.for_lines(along, [&](int, const SpringLine& line) {
                        excess += nodes.shorten(line, longest, beyond, taut);
                    });
            if (excess > 0.0) move(grid, apart, constants, x);
        }
    }

private:
    std::ptrdiff_t element(int I, int J) const { return static_cast<std::ptrdiff_t>(J) * x_.stride() + I; }

    /// Calls visit(element of a node, share) for the nodes that mass (i, j) moves with.
    template <class Visit>
    void for_nodes(const Grid& grid, int apart, int i, int j, const Visit& visit) const {
        const auto between = [&](int n, int masses) {
            const int node = std::min(n, std::max(0, masses - 2)) / apart, first = node * apart;
            const int cells = std::max(1, std::min(apart, masses - 1 - first));
            return std::pair(node, static_cast<double>(n - first) / cells);
        };
        const auto [I, u] = between(i, grid.columns);
        const auto [J, v] = between(j, grid.rows);
        for (const auto& [below, of_v] : {std::pair(0, 1.0 - v), {1, v}})
            for (const auto& [right, of_u] : {std::pair(0, 1.0 - u), {1, u}})
                if (of_u * of_v > 0.0) visit(element(I + right, J + below), of_u * of_v);
    }
    /// Calls visit(i, j, 1/m) for masses that are not held.
    template <class Visit>
    static void for_free(const Grid& grid, const RowConstants<Real>* constants, const Visit& visit) {
        for (int j = 0; j < grid.rows; ++j)
            for (int i = 0; i < grid.columns; ++i)
                if (const double w = constants[j].inverse_mass[i]; w > 0.0) visit(i, j, w);
    }

    void weigh(const Grid& grid, int apart, const RowConstants<Real>* constants) {
        std::fill(inverse_mass_.begin(), inverse_mass_.end(), 0.0);
        for_free(grid, constants, [&](int i, int j, double w) {
            for_nodes(grid, apart, i, j, [&](std::ptrdiff_t n, double share) { inverse_mass_[n] += share / w; });
        });
    }
    void move(const Grid& grid, int apart, const RowConstants<Real>* constants, const Field<Real>& x) {
        const Field<Real> from = before_.view(), to = x_.view();
        for_free(grid, constants, [&](int i, int j, double) {
            const std::ptrdiff_t n = j * x.stride + i;
            auto place = x.template at<Real>(n);
            for_nodes(grid, apart, i, j, [&](std::ptrdiff_t node, double share) {
                place = place + static_cast<Real>(share) * (to.template at<Real>(node) - from.template at<Real>(node));
            });
            x.set(n, place);
        });
    }

    FieldBuffer<Real> x_, before_;  // m
    Array<double> inverse_mass_;    // 1/kg, 0 for a held node
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
