// Fabric: a cloth by what it is made of, whatever the grid: masses and springs follow from the cells. Refining the grid
// refines the motion of the same cloth; its borders are light (Borders::light).
#pragma once

#include "drapeau/model.hpp"

#include <cmath>
#include <optional>

namespace drapeau {

/// Fabrics that flags are made of.
enum class FabricName { knitted_polyester, woven_polyester, nylon, silk, canvas };

struct Fabric {
    FabricName name = FabricName::knitted_polyester;  // what its values began as
    double density = 0.11;                            // kg/m2
    double stretch_modulus = 300.0;  // Y, N/m: pull per width of a strip along the threads, over its stretch
    // s, stiffness of diagonal springs over that of others, on square cells: it resists shear, at 0.5 alike in all
    // directions; absent: nothing does.
    std::optional<double> diagonal_share = 0.1;
    std::optional<double> damping_time = 5e-5;  // s, c over k of every spring; absent: none
    std::optional<double> drag_per_area{};      // N s/m3, d over the area that a mass stands for; absent: none

    bool operator==(const Fabric&) const = default;
};

/// The values of a named fabric, without drag, which is the air's. Sources: docs/model.md, "Fabric".
inline Fabric fabric_of(FabricName name) {
    switch (name) {
        case FabricName::woven_polyester:
            return {name, 0.155, 2000.0, 0.03};
        case FabricName::nylon:
            return {name, 0.12, 1900.0, 0.03};
        case FabricName::silk:
            return {name, 0.035, 550.0, 0.03};
        case FabricName::canvas:
            return {name, 0.34, 1000.0, 0.07};
        case FabricName::knitted_polyester:
            break;
    }
    return {};
}

/// B, N m, of a named fabric. Sources: docs/model.md, "Fabric".
inline double bending_of(FabricName name) {
    switch (name) {
        case FabricName::woven_polyester:
        case FabricName::nylon:
            return 3e-5;
        case FabricName::silk:
            return 8e-6;
        case FabricName::canvas:
            return 7e-5;
        case FabricName::knitted_polyester:
            break;
    }
    return 2e-5;
}

inline namespace DRAPEAU_ISA {

/// The most that a cell may be longer than wide, or wider than long, for springs to resist as the fabric does: beyond,
/// some would have to push. Infinite without diagonal springs.
inline double longest_cell(const Fabric& fabric) {
    const double s = fabric.diagonal_share.value_or(0.0);
    return std::sqrt((1.0 + s) / s);
}

/// The springs of cells a x b (m) that make a sheet of this fabric: any even strain stores the energy that it stores in
/// square cells. The cells must be no longer than longest_cell.
inline Springs fabric_springs(const Fabric& fabric, double a, double b) {
    const double s = fabric.diagonal_share.value_or(0.0), square = fabric.stretch_modulus * (1.0 + s) / (1.0 + 2.0 * s);
    const auto along = [s](double length, double width) { return (1.0 + s) * width / length - s * length / width; };
    Springs springs;
    springs.mass = fabric.density * a * b;
    springs.stiffness = square * along(a, b);
    springs.along_hoist = along(b, a) / along(a, b);
    if (fabric.diagonal_share) springs.diagonal_stiffness = s * square * (a * a + b * b) / (2.0 * a * b);
    if (fabric.damping_time) springs.damping = *fabric.damping_time * springs.stiffness;
    if (fabric.diagonal_share) springs.diagonal_damping = *springs.diagonal_stiffness / springs.stiffness;
    return springs;
}

/// A sheet of it: it has two columns and rows at least.
inline Model model_of(const Fabric& fabric, const Grid& grid, Attach attach, Terms terms = {},
                      const Limits& limits = {}) {
    if (fabric.drag_per_area) terms.add(AirDrag{*fabric.drag_per_area * grid.pitch_x * grid.pitch_y});
    return Model(grid, fabric_springs(fabric, grid.pitch_x, grid.pitch_y), attach, terms, limits, Borders::light);
}

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
