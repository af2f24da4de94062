// Sweep options: what commands that compare many runs of a scene take alike, as the numbers it means.
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <utility>
#include <vector>

namespace drapeau::lab {

/// So many seconds as a whole number of batches of 1/60 s, at least `least`. Throws InputError, as do the others.
long long batches_option(const std::string& option, const std::string& text, long long least);

/// Columns and rows: "23x15".
std::pair<int, int> grid_in(const std::string& text);

/// The scene, with what `set` says instead ("KEY=VALUE").
Scene scene_in(const std::string& scene, const std::vector<std::string>& set);

}  // namespace drapeau::lab
