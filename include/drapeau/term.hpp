// Term: what may push or brake every mass, besides the springs. A term is one file in terms/, a plain aggregate of its
// parameters with these members:
//
//   name                        for people
//   table (if it has one)       its table in a scene file; its keys are rows of src/scene/settings.hpp
//
// and of these what it needs; what a term does not have is not asked for, and a term that is not listed is not
// executed:
//
//   accelerate(row, t, a)       adds, to every element of a row, the acceleration (m/s2) of its mass at time t (s)
//   varies_by_row(grid)         whether that differs from row to row; without it one row is asked for and stands for
//                               all of them
//   potential(moment)           the energy (J) it stores in masses whose sum of m x is `moment` (kg m), of a push that
//                               is the same everywhere and always
//   damping(share)              N s/m that brake a mass's own velocity; share: of a mass inside, 1, or on a border that
//                               is lighter. It lowers the largest stable step and its work is counted.
//   most_power(d)               the greatest power (W) at which it can bring energy into a mass with air drag d (N
//   s/m);
//                               a term that pushes, stores nothing and does not say may bring in any
//   is_air                      the damping is against the air, so wind is felt through it
//
// A term that sees where masses are and how they move (terms/air.hpp) has a kernel of its own, which passes over the
// rows before the sweep does (air_rows.hpp, block.hpp); its methods are asked for by name.
#pragma once

#include "drapeau/state.hpp"

#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

namespace drapeau {
inline namespace DRAPEAU_ISA {

/// The masses of one row as a term sees them. Padding may be computed with: it is never moved.
template <class Real>
struct PushedRow {
    const Grid& grid;
    int row;
    int width;              // elements to fill
    const Real* drag_rate;  // 1/s, of each column: air drag over the mass; null where there is none
};

/// Settings of which each may be listed or not.
template <class... Listed>
class ListOf {
public:
    template <class T>
    static constexpr bool has = (std::is_same_v<T, Listed> || ...);

    template <class T>
    std::optional<T>& get() {
        return std::get<std::optional<T>>(all_);
    }
    template <class T>
    const std::optional<T>& get() const {
        return std::get<std::optional<T>>(all_);
    }
    template <class T>
    ListOf& add(const T& term) {
        get<T>() = term;
        return *this;
    }

    /// Calls visit(term) for each that is listed.
    template <class Visit>
    void for_each(Visit&& visit) const {
        const auto look = [&](const auto& term) {
            if (term) visit(*term);
        };
        std::apply([&](const auto&... terms) { (look(terms), ...); }, all_);
    }
    /// Calls visit(optional term) for each that there is.
    template <class Self, class Visit>
    static void for_all(Self& self, Visit&& visit) {
        std::apply([&](auto&... terms) { (visit(terms), ...); }, self.all_);
    }

    bool operator==(const ListOf&) const = default;

private:
    std::tuple<std::optional<Listed>...> all_;
};

}  // namespace DRAPEAU_ISA
}  // namespace drapeau
