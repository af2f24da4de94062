// Bending: the resistance of cloth to curvature, along its threads. Three masses in a line, a apart in a strip as wide
// as the lines are apart (b), hold
//
//   B/2 (b/a3) |x_left - 2 x + x_right|^2          B/2 of the curvature's square, over the area a b
//
// It is quadratic in positions, so its force is linear in them; a sheet that moves as a whole, turns or is stretched
// evenly feels nothing. Ends of a thread are free to turn, held or not. Threads bend, the cell between them does not
// twist: across the bias the sheet bends half as hard. Sources: Bergou et al., A Quadratic Bending Model for
// Inextensible Surfaces, 2006 (why quadratic); docs/model.md (values).
#pragma once

#include "drapeau/term.hpp"

#include <optional>

namespace drapeau {
inline namespace DRAPEAU_ISA {

struct Bending {
    static constexpr const char* name = "bending";
    static constexpr const char* table = "bending";

    double stiffness = 1e-4;          // B, N m; larger makes wider folds
    std::optional<double> damping{};  // 1/s, how fast the shortest wave along a thread is braked; absent: not at all

    /// k (N/m) and c (N s/m) of three masses (kg each) in a line, `length` apart, `width` (m) being the strip's.
    double line_stiffness(double length, double width) const { return stiffness * width / (length * length * length); }
    double line_damping(double mass) const { return damping.value_or(0.0) * mass / fastest; }

    /// The eigenvalue of the shortest wave: k |x_left - 2 x + x_right|^2 summed over a line is at most this times k
    /// x^2, also where the ends are half as heavy.
    static constexpr double fastest = 16.0;

    /// It stores energy and brakes; it brings nothing in.
    static double most_power(double) { return 0.0; }

    bool operator==(const Bending&) const = default;
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
