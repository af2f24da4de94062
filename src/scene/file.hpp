// Scene files: TOML read into a Scene and written back; every shipped scene and texture found from any directory.
#pragma once

#include "scene/scene.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drapeau {

/// What the command line says instead of the file: "--set flag.columns=90", or "--dt auto" for time.dt.
struct Assignment {
    std::string option;  // for messages: "--set flag.columns", "--dt"
    std::string key;     // "flag.columns"
    std::string value;   // as in a file, text without its quotes; "off" takes out what a scene may leave out
};

/// The assignment "--set KEY=VALUE". Throws InputError if there is no key.
Assignment assignment_in(const std::string& text);

/// Reads one scene file. Throws InputError naming file and line (or option), key, value and what is allowed.
Scene read_scene(const std::filesystem::path& file, std::span<const Assignment> assignments = {});

/// The same from text; `origin` stands in for the file's name in messages.
Scene parse_scene(std::string_view text, const std::string& origin, std::span<const Assignment> assignments = {});

/// The scene as TOML, with every key the scene lists and a comment with each unit. parse_scene gives the same Scene
/// back.
std::string write_scene(const Scene& scene);

/// A line of that text: a key, or the name of a table where `key` is "".
struct SceneLine {
    std::string table;  // "" before the first one
    std::string key;
    std::string value;    // as TOML
    std::string unit;     // "" for what has none
    std::string comment;  // "N/m, of springs between side neighbours (k)"

    std::string text(const std::string& note) const;  // without the line break; `note` is its comment
};
std::vector<SceneLine> scene_lines(const Scene& scene, bool with_implied = false);
inline constexpr const char* scene_heading =
    "# A scene of drapeau: what is listed is modelled, what is left out is not.\n";

/// Throws InputError if the scene is impossible (sizes, signs, wind nobody feels, more memory than there is);
/// the window calls it for what its controls made, parse_scene calls it for what a file says.
void check_scene(const Scene& scene);

/// The scene file that is meant: a path as people give it (io/given_path.hpp), the name of a shipped scene ("storm"),
/// or what lacks only its ending ("mine" for mine.toml), in this order; a folder hides nothing. Throws InputError that
/// lists the shipped ones.
std::filesystem::path find_scene(const std::string& path_or_name);

/// The same for an image: a path, a shipped one ("japan"), or what lacks only its ending.
std::filesystem::path find_picture(const std::string& path_or_name);

/// Names of the shipped scenes, "report" first.
std::vector<std::string> shipped_scenes();

/// The images in assets/flags, sorted.
std::vector<std::filesystem::path> shipped_pictures();

/// The image that `texture` of a scene read from `scene_file` means: beside the scene, then in assets/flags. Throws
/// InputError, which begins with `place`, where the scene says so.
std::filesystem::path find_texture(const std::string& texture, const std::filesystem::path& scene_file,
                                   const std::string& place);

/// Where a scene's file says its texture: "storm.toml:7"; "storm.toml" where it does not.
std::string place_of_texture(const std::filesystem::path& scene_file);
std::string place_of_texture(std::string_view text, const std::string& origin);  // of a scene as text

/// assets/ of the source or build tree, or of the installation (found from the program's own place, not the working
/// directory).
std::filesystem::path assets_directory();

/// Names as in scene files and on the command line: "semi-implicit-euler", "hoist", "flat", "float".
std::string_view name_of(Attach attach);
std::string_view name_of(Start start);
std::string_view name_of(Method method);
std::string_view name_of(Precision precision);
/// "forward-euler, ... or rk4", for help and messages.
std::string method_choices();

}  // namespace drapeau
