// Saved scene: a scene that a command found, as it is to be written.
#pragma once

#include "scene/scene.hpp"

#include <filesystem>

namespace drapeau::lab {

/// Its image is found from its new place too. `from`: the file it was read from.
Scene as_saved(const Scene& scene, const std::filesystem::path& from);

}  // namespace drapeau::lab
