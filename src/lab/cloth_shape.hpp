// Cloth shape: how much of a cloth is compressed, and how wide its folds are. A cloth without bending stiffness that is
// compressed folds as finely as its grid lets it, whatever the grid: the growth of a fold of wave number q is
// sqrt(compression k/m) q h, fastest at two cells.
#pragma once

#include "drapeau/state.hpp"

#include <cmath>

namespace drapeau::lab {

/// Summed over moments of one grid's motion.
class ClothShape {
public:
    ClothShape(const Grid& grid, bool diagonals) : grid_(grid), diagonals_(diagonals) {}

    void take(const State<double>& state);

    /// The share of springs shorter than at rest, over all moments.
    double compressed_share() const;
    /// The wavelength of folds (m), on the average by how sharp they are: from third against second differences of
    /// positions across the line of masses, |third|^2 = 4 sin^2(q h/2) |second|^2 for one wave. Along that side of the
    /// grid which is folded more. NAN where it is flat.
    double fold_wavelength() const;
    /// The same over the distance between masses; at least 2.
    double fold_cells() const;

private:
    struct Folds {
        double second = 0.0, third = 0.0;  // m^2, sums of squares
        long long count = 0;
        double sharpness(double pitch) const;  // 1/m, root mean square of curvature
        double cells() const;
    };
    const Folds& sharper() const;
    double pitch_of_sharper() const;
    void take_line(const FieldBuffer<double>& x, int i, int j, int di, int dj, int count, Folds& folds) const;

    Grid grid_;
    bool diagonals_;
    long long compressed_ = 0, springs_ = 0;
    Folds across_, down_;
};

}  // namespace drapeau::lab
