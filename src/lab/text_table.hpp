// Text table: rows of cells, their columns aligned.
#pragma once

#include <string>
#include <vector>

namespace drapeau::lab {

using Row = std::vector<std::string>;

/// The first row is the heading. Two spaces between columns; a row of one cell is a line of its own.
std::string aligned(const std::vector<Row>& rows);

}  // namespace drapeau::lab
