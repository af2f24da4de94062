// Library: scenes and images from disk, whole or not at all. Everything here throws InputError and touches nothing
// else.
#pragma once

#include "image/image.hpp"
#include "scene/file.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace drapeau {

/// A scene with the image it names.
struct LoadedScene {
    Scene scene;
    std::filesystem::path file;
    std::filesystem::path texture_file;  // empty: the scene names none
    std::optional<Image> image;
    std::string fault;  // why the image that the scene names is not there; empty if it is, or none is named
};

/// Throws InputError where the scene cannot be read. An image that cannot be is told in `fault`: the flag flies plain.
/// Throws Abandoned soon after `stop` is asked to stop.
LoadedScene load_scene(const std::string& path_or_name, std::span<const Assignment> assignments = {},
                       const std::stop_token& stop = {});

/// How a scene file in `folder` should name this image: shipped ones by name, those in the folder or below it by the
/// way from there, so that both may be moved together, others by their full path. Empty if a scene file cannot hold it.
std::string texture_name(const std::filesystem::path& image, const std::filesystem::path& folder = {});

struct Saved {
    std::filesystem::path file;  // its full path
    bool without_image = false;  // the image's path is none that a scene file can hold
};

/// Writes the scene as TOML, whole or not at all, naming `image` (empty: as the scene has it) as found from there.
/// Throws InputError, having written nothing, also if the file would not open again to the same scene.
Saved save_scene(Scene scene, const std::filesystem::path& file, const std::filesystem::path& image = {});

/// The first of drapeau-001.png, drapeau-002.png ... in the working directory that is not there yet.
std::filesystem::path free_screenshot_name();
/// The same for another ending, ".mp4".
std::filesystem::path free_file_name(const std::string& ending);

}  // namespace drapeau
