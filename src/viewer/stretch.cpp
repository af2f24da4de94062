#include "stretch.hpp"

#include "usual_size.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace drapeau {

namespace {

/// Along the springs to the masses `right` and `down` from one and opposite to it.
double stretch_along(const FieldBuffer<float>& position, double rest, int column, int row, int right, int down) {
    double sum = 0.0;
    int count = 0;
    for (const int side : {-1, 1}) {
        const int c = column + side * right, r = row + side * down;
        if (c < 0 || r < 0 || c >= position.columns() || r >= position.rows()) continue;
        sum += glm::distance(position.at(column, row), position.at(c, r)) / rest - 1.0;
        ++count;
    }
    return count > 0 ? sum / count : -std::numeric_limits<double>::infinity();
}

}  // namespace

double stretch_at(const FieldBuffer<float>& position, const SpringKinds& kinds, int column, int row) {
    double greatest = -std::numeric_limits<double>::infinity();
    const auto look = [&](const SpringKind& kind, int right, int down) {
        if (kind.exists())
            greatest = std::max(greatest, stretch_along(position, double(kind.rest), column, row, right, down));
    };
    look(kinds.fly, 1, 0);
    look(kinds.hoist, 0, 1);
    look(kinds.diagonal, 1, 1);
    look(kinds.diagonal, -1, 1);
    return std::isfinite(greatest) ? greatest : 0.0;
}

double usual_stretch(const FieldBuffer<float>& position, const SpringKinds& kinds) {
    return usual_size(position.columns(), position.rows(),
                      [&](int column, int row) { return std::abs(stretch_at(position, kinds, column, row)); });
}

}  // namespace drapeau
