// Shared options: what several commands' options mean, each read and refused in one way. All throw InputError.
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <utility>
#include <vector>

namespace drapeau::lab {

/// A time (s) as a number of batches of 1/60 s, at least so many.
long long batches_option(const std::string& option, const std::string& text, long long least);

/// --budget, in s.
double budget_option(const std::string& minutes);

/// A distance with its unit, "1mm" or "0.5 mm", in m.
double distance_in(const std::string& option, const std::string& text);

/// Columns and rows: "23x15".
std::pair<int, int> grid_in(const std::string& text);

/// The scene that is meant, with what --set says instead.
Scene scene_in(const std::string& scene, const std::vector<std::string>& set);

}  // namespace drapeau::lab
