// User settings: what the window remembers between runs, in $XDG_CONFIG_HOME/drapeau/settings.toml (by default
// ~/.config/drapeau/settings.toml). To remember something else, add its member and its row in each_remembered.
#pragma once

#include "recent_files.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace drapeau {

struct UserSettings {
    int width = 1280, height = 800;                         // of the window, in units of usual text
    bool panel = true;                                      // shown, where there is room for it beside the flag
    std::string page = "Flag";                              // of the panel
    std::vector<std::string> recent_scenes, recent_images;  // paths, the newest first

    bool operator==(const UserSettings&) const = default;
};

/// Calls visit(key, member, lowest, highest) for each; the ends are those of numbers.
template <class Settings, class Visit>
void each_remembered(Settings& settings, Visit&& visit) {
    visit("width", settings.width, 480, 16384);
    visit("height", settings.height, 360, 16384);
    visit("panel", settings.panel, 0, 1);
    visit("page", settings.page, 0, 0);
    visit("recent_scenes", settings.recent_scenes, 0, 0);
    visit("recent_images", settings.recent_images, 0, 0);
}

/// The file; empty if the environment names no place for it: $XDG_CONFIG_HOME is no full path, and there is no $HOME.
std::filesystem::path user_settings_file();

/// Throws InputError naming file, line and key if any of it cannot be used. Keys that are not known are passed over.
UserSettings parse_user_settings(const std::string& text, const std::string& origin);
std::string write_user_settings(const UserSettings& settings);

/// What the file says. One that cannot be used is renamed to settings.toml.bad (or .bad-2, if that is taken).
struct FoundSettings {
    UserSettings settings;      // defaults where the file could not be used
    std::string trouble;        // what was wrong and where the file is now; empty if nothing was
    bool may_be_saved = false;  // nothing would be lost by writing the file
};
FoundSettings find_user_settings(const std::filesystem::path& file);

/// Writes the file, whole or not at all, and its folder if there is none. Throws InputError.
void save_user_settings(const UserSettings& settings, const std::filesystem::path& file);

}  // namespace drapeau
