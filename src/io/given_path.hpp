// Given path: what a person means by a path that was typed, pasted or dropped.
#pragma once

#include <filesystem>
#include <string>

namespace drapeau {

/// The path that is meant. A file of exactly the given name is what it is; of any other name
///   - space, tabs and line breaks around it fall away, then a pair of quotes,
///   - a file:// URL of this machine is decoded,
///   - ~ and ~/ at its beginning are the home folder.
std::string meant_path(const std::string& given);

/// The ending in small letters: ".png" of Flag.PNG, "" if there is none.
std::string ending_of(const std::filesystem::path& file);

}  // namespace drapeau
