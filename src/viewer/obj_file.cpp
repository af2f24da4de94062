#include "obj_file.hpp"

#include "io/error.hpp"
#include "io/given_path.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "numbered_name.hpp"

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <string>

namespace drapeau {

namespace {

constexpr double degenerate = 1e-14;  // m2; masses on top of each other have no normal of their own

glm::dvec3 normal_at(const FieldBuffer<float>& x, int column, int row) {
    const int right = std::min(column + 1, x.columns() - 1), left = std::max(column - 1, 0);
    const int below = std::min(row + 1, x.rows() - 1), above = std::max(row - 1, 0);
    const glm::dvec3 along = x.at(right, row) - x.at(left, row), up = x.at(column, above) - x.at(column, below);
    const glm::dvec3 normal = glm::cross(along, up);
    const double size = glm::length(normal);
    return size > degenerate ? normal / size : glm::dvec3(0.0, 0.0, 1.0);
}

/// The masses of a row: their places, where the image lies on them, and their normals.
std::string masses_of(const FieldBuffer<float>& x, int row) {
    const double down = double(row) / std::max(1, x.rows() - 1);
    std::string text;
    for (int column = 0; column < x.columns(); ++column) {
        const glm::dvec3 place = x.at(column, row), normal = normal_at(x, column, row);
        text += fmt::format("v {} {} {}\n", float(place.x), float(place.y), float(place.z));
        text += fmt::format("vt {:.6g} {:.6g}\n", double(column) / std::max(1, x.columns() - 1), 1.0 - down);
        text += fmt::format("vn {:.5f} {:.5f} {:.5f}\n", normal.x, normal.y, normal.z);
    }
    return text;
}

/// The cells between a row and the next, anticlockwise as seen from the front.
std::string cells_below(const FieldBuffer<float>& x, int row) {
    std::string text;
    for (int column = 0; column + 1 < x.columns(); ++column) {
        const long long upper = 1LL + static_cast<long long>(row) * x.columns() + column, lower = upper + x.columns();
        text += fmt::format("f {0}/{0}/{0} {1}/{1}/{1} {2}/{2}/{2} {3}/{3}/{3}\n", upper, lower, lower + 1, upper + 1);
    }
    return text;
}

}  // namespace

void check_obj_name(const std::filesystem::path& file) {
    if (means_sequence(file)) check_numbered(file);
    if (ending_of(file) != ".obj")
        throw InputError(one_line(file.string(), 1000) + ": .obj is allowed, the format of the shape");
}

void write_obj(const std::filesystem::path& file, const Snapshot& shape) {
    const FieldBuffer<float>& x = shape.position;
    write_text_file(file.string(), [&](const Append& append) {
        append(fmt::format("# a flag of {} x {} masses after {:.6g} s; metres, y up\no flag\n", x.columns(), x.rows(),
                           shape.time));
        for (int row = 0; row < x.rows(); ++row) append(masses_of(x, row));
        if (x.columns() > 1 && x.rows() > 1) {
            append("s 1\n");
            for (int row = 0; row + 1 < x.rows(); ++row) append(cells_below(x, row));
            return;
        }
        append("l");
        for (int mass = 1; mass <= x.columns() * x.rows(); ++mass) append(" " + std::to_string(mass));
        append("\n");
    });
}

}  // namespace drapeau
