// Model: what is modelled: grid, masses, springs, attachments, terms and limits. Built once from the settings; the
// sweep, energies, bounds, starts, tests, the benchmark and the colours of the picture all read this one description.
#pragma once

#include "drapeau/limits/list.hpp"
#include "drapeau/method.hpp"
#include "drapeau/state.hpp"
#include "drapeau/terms/list.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace drapeau {

/// Which masses are held where they are.
enum class Attach { hoist, grommets, top, corner, sides, edges, all, none };

inline namespace DRAPEAU_ISA {

/// Whether mass (i, j) is held.
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
        case Attach::sides:
            return hoist || i == grid.columns - 1;
        case Attach::edges:
            return hoist || top || bottom || i == grid.columns - 1;
        case Attach::all:
            return true;
        case Attach::none:
            break;
    }
    return false;
}

/// Masses and springs: every one of a kind alike, but for what borders are (Borders).
struct Springs {
    double mass = 0.0001;                      // kg, of every mass
    double stiffness = 200.0;                  // k of structural springs, N/m; larger needs a smaller step
    std::optional<double> diagonal_stiffness;  // k of diagonal springs, N/m; absent: no diagonal springs
    std::optional<double> damping;             // c of every spring, N s/m; larger needs a smaller step; absent: none
    double along_hoist = 1.0;       // k and c of structural springs along the hoist, over those along the fly
    double diagonal_damping = 1.0;  // c of diagonal springs, over that of those along the fly

    double stiffest() const {  // N/m
        return std::max(stiffness * std::max(1.0, along_hoist), diagonal_stiffness.value_or(0.0));
    }
    bool operator==(const Springs&) const = default;
};

/// Borders as light as the cloth they stand for: half the mass and drag (corners a quarter), border springs half as
/// stiff. Or all alike, as in the report.
enum class Borders { alike, light };

class Model {
public:
    /// One row's shares of mass, of area, of the springs to the right and of those downwards. Rows alike share one.
    struct Kind {
        std::vector<double> mass, area, fly, hoist;
        std::vector<char> held;
    };

    Model(const Grid& of_grid, const Springs& of_springs, Attach attach, const Terms& listed = {},
          const Limits& passes = {}, Borders borders = Borders::alike)
        : grid(of_grid), springs(of_springs), terms(listed), limits(passes) {
        for (const int j : {0, 1, grid.rows - 1}) kinds_.push_back(kind_of(j, attach, borders));
        row_.resize(static_cast<std::size_t>(grid.rows), 1);
        row_.front() = 0;
        row_.back() = grid.rows > 1 ? 2 : 0;
    }

    // Strengths may be set while a run goes on (Stepper::refill); the grid and what is listed may not.
    Grid grid;
    Springs springs;
    Terms terms;
    Limits limits;

    const std::vector<Kind>& kinds() const { return kinds_; }
    int kind(int j) const { return row_[static_cast<std::size_t>(j)]; }
    bool held(int i, int j) const { return at(j).held[i] != 0; }
    double mass(int i, int j) const { return springs.mass * at(j).mass[i]; }  // kg
    double total_mass() const {                                               // kg
        double sum = 0.0;
        for (int j = 0; j < grid.rows; ++j) sum = std::accumulate(at(j).mass.begin(), at(j).mass.end(), sum);
        return springs.mass * sum;
    }

    bool is_free() const {
        return std::none_of(row_.begin(), row_.end(), [&](int kind) {
            const auto& held = kinds_[static_cast<std::size_t>(kind)].held;
            return std::find(held.begin(), held.end(), 1) != held.end();
        });
    }

    /// Holds one more mass where it is.
    void hold(int i, int j) {
        kinds_.push_back(at(j));
        kinds_.back().held[i] = 1;
        row_[static_cast<std::size_t>(j)] = static_cast<int>(kinds_.size()) - 1;
    }

    bool has_diagonals() const { return springs.diagonal_stiffness.has_value(); }
    bool is_damped() const { return springs.damping.has_value(); }

    /// Drag and friction of a mass with this share of the mass (N s/m), or of the air alone.
    double damping_on_mass(double share, bool air_alone = false) const {
        double sum = 0.0;
        terms.for_each([&]<class Term>(const Term& term) {
            if constexpr (requires { term.damping(share); }) {
                constexpr bool air = requires {
                    Term::is_air;
                };
                if (air || !air_alone) sum += term.damping(share);
            }
        });
        return sum;
    }
    bool varies_by_row() const {
        bool any = false;
        terms.for_each([&](const auto& term) {
            if constexpr (requires { term.varies_by_row(grid); }) any = any || term.varies_by_row(grid);
        });
        return any;
    }

    /// The energy (J) that terms such as gravity store in masses whose sum of m x is `moment` (kg m).
    double potential(const glm::dvec3& moment) const {
        double sum = 0.0;
        terms.for_each([&](const auto& term) {
            if constexpr (requires { term.potential(moment); }) sum += term.potential(moment);
        });
        return sum;
    }
    /// The greatest power (W) at which terms can bring in energy, but for those that store it.
    double most_power() const {
        const double drag = damping_on_mass(1.0, true);
        double sum = 0.0;
        terms.for_each([&](const auto& term) {
            if constexpr (requires { term.most_power(drag); })
                sum += term.most_power(drag);
            else if constexpr (requires { term.most_power(cell(), fastest_wind()); })
                sum += air() ? term.most_power(cell(), fastest_wind()) : 0.0;
            else if constexpr (
                !requires { term.damping(1.0); } && !requires { term.potential(glm::dvec3(0.0)); })
                sum = INFINITY;
        });
        return sum * static_cast<double>(grid.masses());
    }
    /// Whether there is a pass after the move over the cloth as a whole, and one over each mass by itself.
    bool is_limited() const { return lists<false>(); }
    bool touches() const { return lists<true>(); }

    /// The share (m2) of the cloth that mass (i, j) stands for: half a cell on a border, a quarter in a corner.
    double area(int i, int j) const { return at(j).area[i] * cell(); }
    double cell() const { return grid.pitch_x * grid.pitch_y; }  // m2

    /// The air on faces, if it is listed and does anything.
    const Air* air() const {
        const auto& listed = terms.get<Air>();
        const bool has_faces = grid.columns > 1 && grid.rows > 1;
        return listed && listed->is_felt() && has_faces ? &*listed : nullptr;
    }
    /// The same if air moves along with the cloth.
    const Air* added_air() const { return air() && air()->moves_along() ? air() : nullptr; }
    /// Bending, if it is listed and three masses stand in a line.
    const Bending* bending() const {
        const auto& listed = terms.get<Bending>();
        return listed && (grid.columns > 2 || grid.rows > 2) ? &*listed : nullptr;
    }
    /// How threads along the fly and down the hoist resist being bent; 0 where no three masses stand in a line.
    BendingStrength<double> bending_strength() const {
        const Bending* const b = bending();
        if (!b) return {};
        const double fly = grid.columns > 2 ? 1.0 : 0.0, hoist = grid.rows > 2 ? 1.0 : 0.0;
        return {fly * b->line_stiffness(grid.pitch_x, grid.pitch_y),
                hoist * b->line_stiffness(grid.pitch_y, grid.pitch_x), fly * b->line_damping(springs.mass),
                hoist * b->line_damping(springs.mass)};
    }
    /// Whether method M is to be composed as with damped springs: some force sees velocities as those see them.
    template <class M>
    bool is_damped_for() const {
        const auto& bends = terms.get<Bending>();
        return is_damped() || (predicts_velocity<M> && (terms.get<Air>() || (bends && bends->damping)));
    }
    double fastest_wind() const { return terms.get<Wind>() ? terms.get<Wind>()->fastest() : 0.0; }  // m/s

    /// An estimate (m/s) of the greatest speed at which the air passes the cloth: the fastest wind there can be and
    /// that of a fall over the flag's own size. Springs that recoil may be faster for moments.
    double fastest_air() const {
        const double pull = std::hypot(potential({1, 0, 0}), potential({0, 1, 0}), potential({0, 0, 1}));
        const double size = std::hypot((grid.columns - 1) * grid.pitch_x, (grid.rows - 1) * grid.pitch_y);
        return fastest_wind() + std::sqrt(2.0 * pull * size);
    }
    /// How fast the air on faces then brakes a mass (N s/m): of those inside, for which there is most air for the mass.
    double damping_of_air() const {
        return air() ? springs.mass * air()->most_rate(cell() / springs.mass, fastest_air()) : 0.0;
    }

    /// Springs between neighbours of a row, of a column, and across cells.
    long long springs_in_all() const {
        const long long c = grid.columns, r = grid.rows;
        return (c - 1) * r + c * (r - 1) + (has_diagonals() ? 2 * (c - 1) * (r - 1) : 0);
    }

    /// The fastest modes that any configuration of these springs can have. No spring's Hessian exceeds k I, folded or
    /// stretched, so the springs resist at most like the graph's Laplacian, whose largest eigenvalue on a grid is
    /// 4 max(kx + ky, max(kx, ky) + 2kd), on a chain 4k; dampers likewise. Light borders and held masses do not raise
    /// it. Bending adds its own fastest wave. What the air on faces does is an estimate.
    std::vector<Oscillator> bounds() const {
        const double k = springs.stiffness, c = springs.damping.value_or(0.0), m = springs.mass;
        const double both = 4.0 * (1.0 + springs.along_hoist), one = 4.0 * std::max(1.0, springs.along_hoist);
        const double on_mass = damping_on_mass(1.0), air = damping_of_air();
        const auto b = bending_strength();
        const double bend = Bending::fastest * (b.k_fly + b.k_hoist);
        const double bend_damping = Bending::fastest * (b.c_fly + b.c_hoist);
        if (grid.rows == 1) return {{m, 4.0 * k, 4.0 * c, on_mass, 0.0, bend, bend_damping}};
        if (grid.columns == 1)
            return {
                {m, 4.0 * springs.along_hoist * k, 4.0 * springs.along_hoist * c, on_mass, 0.0, bend, bend_damping}};
        const double kd = springs.diagonal_stiffness.value_or(0.0);
        const double cd = has_diagonals() ? springs.diagonal_damping * c : 0.0;
        return {{m, both * k, both * c, on_mass, air, bend, bend_damping},
                {m, one * k + 8.0 * kd, one * c + 8.0 * cd, on_mass, air, bend, bend_damping}};
    }

private:
    template <bool contacts>
    bool lists() const {
        bool any = false;
        limits.for_each([&]<class Limit>(const Limit&) { any = any || Contact<Limit> == contacts; });
        return any;
    }

    const Kind& at(int j) const { return kinds_[static_cast<std::size_t>(row_[static_cast<std::size_t>(j)])]; }

    Kind kind_of(int j, Attach attach, Borders borders) const {
        const auto columns = static_cast<std::size_t>(grid.columns);
        const std::vector whole(columns, 1.0);
        Kind kind{whole, whole, whole, whole, std::vector<char>(columns, 0)};
        const double lighter = borders == Borders::light ? 0.5 : 1.0;
        const bool border_row = grid.rows > 1 && (j == 0 || j == grid.rows - 1);
        const bool is_chain = grid.columns == 1 || grid.rows == 1;  // it has no faces
        for (int i = 0; i < grid.columns; ++i) {
            const bool border_column = grid.columns > 1 && (i == 0 || i == grid.columns - 1);
            kind.fly[i] = border_row ? lighter : 1.0;
            kind.hoist[i] = border_column ? lighter : 1.0;
            kind.mass[i] = kind.fly[i] * kind.hoist[i];
            kind.area[i] = is_chain ? 0.0 : (border_row ? 0.5 : 1.0) * (border_column ? 0.5 : 1.0);
            kind.held[i] = is_attached(attach, grid, i, j);
        }
        return kind;
    }

    std::vector<Kind> kinds_;
    std::vector<int> row_;  // the kind of each
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
