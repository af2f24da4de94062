// Shipped scenes and textures, found from the program's own place: the build tree, the source tree or an installation.
#include "error.hpp"
#include "scene_file.hpp"
#include "text.hpp"

#include <algorithm>

namespace drapeau {

namespace fs = std::filesystem;

namespace {

bool is_folder(const fs::path& path) {
    std::error_code ignored;
    return fs::is_directory(path, ignored);
}

bool is_there_and_no_folder(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored) && !is_folder(path);
}

/// Names of the files of one kind, sorted; without the extension if asked.
std::vector<std::string> names_in_folder(const fs::path& folder, std::string_view extension, bool keep_extension) {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const fs::path& path = entry->path();
        if (path.extension() == extension) names.push_back((keep_extension ? path.filename() : path.stem()).string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::string list(const std::vector<std::string>& names) {
    std::string text;
    for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

}  // namespace

fs::path assets_directory() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    for (fs::path folder = program.parent_path(); !error && !folder.empty(); folder = folder.parent_path()) {
        for (const fs::path& assets : {folder / "assets", folder / "share" / "drapeau" / "assets"}) {
            if (is_folder(assets / "scenes")) return assets;
        }
        if (folder == folder.parent_path()) break;
    }
    throw InputError("the folder assets/scenes is missing: it is neither above " + one_line(program.string(), 1000) +
                     " nor in share/drapeau beside it");
}

std::vector<std::string> shipped_scenes() {
    auto names = names_in_folder(assets_directory() / "scenes", ".toml", false);
    std::stable_partition(names.begin(), names.end(), [](const std::string& name) { return name == "report"; });
    return names;
}

fs::path find_scene(const std::string& path_or_name) {
    if (is_there_and_no_folder(path_or_name)) return path_or_name;
    const auto shipped = shipped_scenes();
    if (std::find(shipped.begin(), shipped.end(), path_or_name) != shipped.end()) {
        return assets_directory() / "scenes" / (path_or_name + ".toml");
    }
    if (is_folder(path_or_name)) throw InputError(one_line(path_or_name, 1000) + ": a folder, a scene file is wanted");

    const std::vector<std::string_view> names(shipped.begin(), shipped.end());
    const auto meant = nearest(path_or_name, names);
    throw InputError(one_line(path_or_name, 1000) + ": no such file or shipped scene; " +
                     (meant ? "did you mean " + std::string(*meant) + "? " : "") + "shipped: " + list(shipped));
}

fs::path find_texture(const std::string& texture, const fs::path& scene_file) {
    const fs::path flags = assets_directory() / "flags";
    for (const fs::path& candidate : {scene_file.parent_path() / texture, flags / texture}) {
        if (!texture.empty() && is_there_and_no_folder(candidate)) return candidate;
    }
    throw InputError(
        "texture " + one_line(in_quotes(texture), 300) +
        ": neither beside the scene nor in assets/flags; there: " + list(names_in_folder(flags, ".png", true)));
}

}  // namespace drapeau
