// Assignments of the command line, "flag.columns=90", put into what a scene file says, so that both are read and
// checked alike.
#pragma once

#include "scene/file.hpp"

#include <toml++/toml.h>

namespace drapeau {

/// Puts the value into the file's tables. Its node's source is the option instead of a file. A word that is no TOML
/// is text; `off` takes out what a scene may leave out, `on` lists a table with its defaults. Throws InputError if the
/// key cannot be one.
void assign(toml::table& root, const Assignment& assignment);

}  // namespace drapeau
