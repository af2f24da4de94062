// What differs between two scenes, in a few words.
#pragma once

#include "scene/scene.hpp"

#include <string>

namespace drapeau {

/// "Columns", "Width and Height", "Wind" where a whole table comes or goes, "12 settings"; empty if they are alike.
std::string difference_between(const Scene& before, const Scene& after);

}  // namespace drapeau
