// Material: a scene's masses and springs, given one by one or by a fabric; grids whose cells a fabric can have.
#pragma once

#include "scene/scene.hpp"

#include <optional>

namespace drapeau {

/// Whether the cells are no longer than the scene's fabric can have; always where it has none.
bool do_cells_fit(const Scene& scene);

/// The rows nearest to the scene's with which its cells fit, or the columns; nothing where no number of them does.
std::optional<int> fitting_rows(const Scene& scene);
std::optional<int> fitting_columns(const Scene& scene);

/// Makes cells fit that a change of the flag made too long: by the rows, or where those were changed by the columns.
void fit_cells(Scene& scene, const FlagSettings& before);

/// The material given the other way: the same but for borders, and for springs that a fabric has not or cells that are
/// not square make unlike.
void give_as_fabric(Scene& scene);
void give_as_springs(Scene& scene);

/// What diagonal springs, switched on, are: N/m, or a share.
double usual_diagonals(const Scene& scene);

}  // namespace drapeau
