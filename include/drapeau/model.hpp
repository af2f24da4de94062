// Fabric: what a flag is made of, as the row-long arrays that the sweep reads: springs, masses and what is attached.
#pragma once

#include "drapeau/state.hpp"
#include "scene.hpp"
#include "drapeau/sweep.hpp"

#include <optional>

namespace drapeau {

/// Whether mass (i, j) is held where it is.
inline bool is_attached(Attach attach, const Grid& grid, int i, int j) {
    const bool hoist = i == 0, top = j == 0, bottom = j == grid.rows - 1;
    switch (attach) {
        case Attach::hoist:
            return hoist;
        case Attach::grommets:
            return hoist && (top || bottom);
        case Attach::top:
            return top;
        case Attach::corner:
            return hoist && top;
        case Attach::edges:
            return hoist || top || bottom || i == grid.columns - 1;
        case Attach::all:
            return true;
        case Attach::none:
            break;
    }
    return false;
}

/// The report's material: every mass and every spring alike, borders too.
struct Material {
    double mass = 0.0001;                      // kg, of every mass
    double stiffness = 200.0;                  // k of structural springs, N/m
    std::optional<double> diagonal_stiffness;  // N/m; absent: no diagonal springs
    std::optional<double> damping;             // c of every spring, N s/m; absent: none
};

/// What kernels are given of a fabric.
template <class Real>
struct FabricView {
    SpringRows<Real> springs;
    const Real* inverse_mass[3];  // 1/kg, of the top row, of any row between, of the bottom row; 0 where attached
    int rows;

    DRAPEAU_INLINE const Real* inverse_mass_of(int j) const { return inverse_mass[j == 0 ? 0 : j == rows - 1 ? 2 : 1]; }
};

template <class Real>
class Fabric {
public:
    Fabric(const Grid& grid, Attach attach, const Material& material)
        : width_(padded<Real>(grid.columns)), rows_(grid.rows), all_(12 * static_cast<std::size_t>(width_)) {
        const auto fill = [&](Family family, double k, double length, int springs) {
            for (int i = 0; i < springs; ++i) {
                part(family, 0)[i] = static_cast<Real>(k);
                part(family, 1)[i] = static_cast<Real>(k * length);
                part(family, 2)[i] = static_cast<Real>(material.damping.value_or(0.0));
            }
        };
        fill(fly, material.stiffness, grid.pitch_x, grid.columns - 1);
        fill(hoist, material.stiffness, grid.pitch_y, grid.columns);
        if (material.diagonal_stiffness)
            fill(diagonal, *material.diagonal_stiffness, grid.pitch_diagonal(), grid.columns - 1);

        const int rows_of_kind[3] = {0, 1, grid.rows - 1};
        for (int kind = 0; kind < 3; ++kind)
            for (int i = 0; i < grid.columns; ++i) {
                const bool held = is_attached(attach, grid, i, rows_of_kind[kind]);
                part(inverse_mass, kind)[i] = held ? Real(0) : static_cast<Real>(1.0 / material.mass);
            }
    }

    FabricView<Real> view() const {
        const auto springs = [this](Family f) { return SpringRow<Real>{part(f, 0), part(f, 1), part(f, 2)}; };
        return {{springs(fly), springs(hoist), springs(diagonal)},
                {part(inverse_mass, 0), part(inverse_mass, 1), part(inverse_mass, 2)},
                rows_};
    }

private:
    enum Family { fly, hoist, diagonal, inverse_mass };
    Real* part(int family, int n) { return all_.data() + (3 * family + n) * static_cast<std::ptrdiff_t>(width_); }
    const Real* part(int family, int n) const { return const_cast<Fabric*>(this)->part(family, n); }

    int width_, rows_;
    Array<Real> all_;
};

}  // namespace drapeau
