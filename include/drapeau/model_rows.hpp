// Model rows: the model as the sweep reads it.
#pragma once

#include "drapeau/model.hpp"

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// The model in the precision of a kernel: what the sweep reads, as row-long arrays that rows alike share.
template <class Real>
class ModelRows {
public:
    explicit ModelRows(const Model& model)
        : width_(padded<Real>(model.grid.columns)),
          arrays_(model.kinds().size() * arrays_a_kind * static_cast<std::size_t>(width_)),
          constants_(static_cast<std::size_t>(model.grid.rows)) {
        for (std::size_t j = 0; j < constants_.size(); ++j)
            constants_[j] = constants_of(model, model.kind(static_cast<int>(j)));
        refill(model);
    }
    ModelRows(const ModelRows&) = delete;  // constants point into arrays

    int width() const { return width_; }
    const RowConstants<Real>* constants() const { return constants_.data(); }
    /// Of each column, 1/s; null without air drag.
    const Real* drag_rate(const Model& model, int j) const {
        return model.damping_on_mass(1.0, true) > 0.0 ? array(model.kind(j), drag_rate_) : nullptr;
    }

    /// Takes over the model's strengths. Nothing is allocated.
    void refill(const Model& model) {
        const Grid& grid = model.grid;
        const Springs& s = model.springs;
        const double c = s.damping.value_or(0.0), kd = s.diagonal_stiffness.value_or(0.0);
        const double k_hoist = s.along_hoist * s.stiffness, c_hoist = s.along_hoist * c;
        for (int n = 0; n < static_cast<int>(model.kinds().size()); ++n) {
            const auto& kind = model.kinds()[static_cast<std::size_t>(n)];
            for (int i = 0; i < grid.columns; ++i) {
                const bool right = i + 1 < grid.columns;
                set_spring(n, fly_, i, right ? kind.fly[i] : 0.0, s.stiffness, grid.pitch_x, c);
                set_spring(n, hoist_, i, kind.hoist[i], k_hoist, grid.pitch_y, c_hoist);
                set_spring(n, diagonal_, i, right ? 1.0 : 0.0, kd, grid.pitch_diagonal(), s.diagonal_damping * c);
                const double m = s.mass * kind.mass[i];
                const bool held = kind.held[i] != 0;
                const auto set = [&](int which, double value) {
                    array(n, which)[i] = held ? Real(0) : static_cast<Real>(value);
                };
                set(inverse_mass_, 1.0 / m), set(mass_, m);
                set(rate_, model.damping_on_mass(kind.mass[i]) / m);
                set(area_, kind.area[i] * model.cell() / m);
                array(n, bend_fly_)[i] = static_cast<Real>(i > 0 && right ? kind.fly[i] : 0.0);
                array(n, bend_hoist_)[i] = static_cast<Real>(kind.hoist[i]);
                array(n, drag_rate_)[i] = static_cast<Real>(model.damping_on_mass(kind.mass[i], true) / m);
            }
        }
    }

private:
    enum {
        fly_ = 0,
        hoist_ = 3,
        diagonal_ = 6,
        inverse_mass_ = 9,
        mass_,
        rate_,
        area_,
        drag_rate_,
        bend_fly_,
        bend_hoist_,
        arrays_a_kind
    };

    std::ptrdiff_t place(int kind, int which) const {
        return (static_cast<std::ptrdiff_t>(kind) * arrays_a_kind + which) * width_;
    }
    Real* array(int kind, int which) { return arrays_.data() + place(kind, which); }
    const Real* array(int kind, int which) const { return arrays_.data() + place(kind, which); }

    void set_spring(int kind, int which, int i, double share, double k, double length, double c) {
        array(kind, which)[i] = static_cast<Real>(share * k);
        array(kind, which + 1)[i] = static_cast<Real>(share * k * length);
        array(kind, which + 2)[i] = static_cast<Real>(share * c);
    }

    RowConstants<Real> constants_of(const Model& model, int kind) const {
        const auto springs = [&](int which, double length) {
            return SpringRow<Real>{array(kind, which), array(kind, which + 1), array(kind, which + 2),
                                   static_cast<Real>(length)};
        };
        const Grid& grid = model.grid;
        return {springs(fly_, grid.pitch_x),
                springs(hoist_, grid.pitch_y),
                springs(diagonal_, grid.pitch_diagonal()),
                array(kind, inverse_mass_),
                array(kind, mass_),
                array(kind, rate_),
                array(kind, area_),
                array(kind, bend_fly_),
                array(kind, bend_hoist_)};
    }

    int width_;
    Array<Real> arrays_;
    Array<RowConstants<Real>> constants_;
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
