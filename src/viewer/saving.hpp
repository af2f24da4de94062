// Saving: what a scene that is saved would replace, and whether a person has to agree first.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace drapeau {

/// The full path that save_scene writes for what a person typed. Throws InputError if nothing was.
std::filesystem::path scene_path(const std::string& typed);

/// The question to ask before a scene is saved as `file`; none where nothing is lost: there is no such file, it is one
/// of `own` (the scene that is open, those saved before), or no ordinary file. Throws InputError where it is the image
/// on the flag, which the scene needs.
std::optional<std::string> question_before_saving(const std::filesystem::path& file,
                                                  const std::vector<std::filesystem::path>& own,
                                                  const std::filesystem::path& image);

}  // namespace drapeau
