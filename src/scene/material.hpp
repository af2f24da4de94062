// Material: a scene's masses and springs, given one by one or by a fabric; grids whose cells a fabric can have.
#pragma once

#include "scene/scene.hpp"

#include <optional>
#include <utility>

namespace drapeau {

/// Whether the cells are no longer than the scene's fabric can have; always where it has none.
bool do_cells_fit(const Scene& scene);

/// The columns and rows nearest to the scene's, by the change of their cells' numbers in ratio, with which its cells
/// fit; nothing where none do.
std::optional<std::pair<int, int>> fitting_grid(const Scene& scene);

/// Makes cells fit that a change of the flag made too long: by the rows, or where those were changed by the columns; by
/// both where one does not suffice.
void fit_cells(Scene& scene, const FlagSettings& before);

/// The material given the other way: the same on square cells but for borders and friction, which a fabric has none of.
/// On others a fabric's springs along the fly and along the hoist differ; springs have their geometric mean.
void give_as_fabric(Scene& scene);
void give_as_springs(Scene& scene);

/// What diagonal springs, switched on, are: N/m, or a share.
double usual_diagonals(const Scene& scene);

/// What a term is that is listed without a word: a fabric bends as its name says.
template <class Term>
Term usual_term(const Scene&) {
    return {};
}
template <>
inline Bending usual_term(const Scene& scene) {
    return scene.fabric ? Bending{.stiffness = bending_of(scene.fabric->name)} : Bending{};
}

}  // namespace drapeau
