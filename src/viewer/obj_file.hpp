// OBJ file: the shape of the cloth for other programs, Wavefront's text format: places, texture coordinates and normals
// of the masses, one face a cell. Lengths are metres, y is up; the flag's front is where faces run anticlockwise.
#pragma once

#include "run/simulation.hpp"

#include <filesystem>

namespace drapeau {

/// Throws InputError unless the name's ending is .obj; of a sequence, unless it has one place for a number.
void check_obj_name(const std::filesystem::path& file);

/// Writes the file, whole or not at all. A chain of masses has no faces: it is written as a line. Throws InputError if
/// it cannot be written.
void write_obj(const std::filesystem::path& file, const Snapshot& shape);

}  // namespace drapeau
