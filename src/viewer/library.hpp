// Library: scenes and images from disk, whole or not at all. Everything here throws InputError and touches nothing
// else.
#pragma once

#include "image/image.hpp"
#include "scene.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace drapeau {

/// A scene with the image it names.
struct LoadedScene {
    Scene scene;
    std::filesystem::path file;
    std::filesystem::path texture_file;  // empty: the scene names none
    std::optional<Image> image;
};

LoadedScene load_scene(const std::string& path_or_name);

/// A path to an image, or the name of a shipped one, with or without its ending.
std::filesystem::path find_image(const std::string& path_or_name);

/// The images in assets/flags, sorted.
std::vector<std::filesystem::path> shipped_images();

/// How a scene file should name this image: shipped ones by name, others by their full path.
std::string texture_name(const std::filesystem::path& image);

/// Writes the scene as TOML, whole or not at all; gives the file's full path.
std::filesystem::path save_scene(const Scene& scene, const std::string& path);

/// The first of drapeau-001.png, drapeau-002.png ... in the working directory that is not there yet.
std::filesystem::path free_screenshot_name();

}  // namespace drapeau
