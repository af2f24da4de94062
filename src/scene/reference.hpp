// The reference of every setting, docs/scene.md, from their table.
#pragma once

#include <string>

namespace drapeau {

/// Markdown: each table of a scene with its settings, their units, defaults and ranges.
std::string settings_reference();

}  // namespace drapeau
