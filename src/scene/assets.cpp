// Shipped scenes and textures, found from the program's own place: the build tree, the source tree or an installation.
#include "io/error.hpp"
#include "io/given_path.hpp"
#include "io/text.hpp"
#include "scene/file.hpp"

#include <algorithm>
#include <span>

namespace drapeau {

namespace fs = std::filesystem;

namespace {

bool is_folder(const fs::path& path) {
    std::error_code ignored;
    return fs::is_directory(path, ignored);
}

bool is_file(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored) && !is_folder(path);
}

/// What is shipped in a folder of assets/ and may also lie anywhere.
struct Kind {
    std::string_view name, wanted;  // in messages
    std::string_view folder;
    std::vector<std::string_view> endings;
};

const Kind scenes{"scene", "a scene file", "scenes", {".toml"}};
const Kind pictures{"image", "an image", "flags", {".png", ".jpg", ".jpeg", ".webp", ".svg", ".gif", ".bmp"}};

/// The shipped files of one kind, sorted, the scene that the program begins with first.
std::vector<fs::path> shipped(const Kind& kind) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator entry(assets_directory() / kind.folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string ending = ending_of(entry->path());
        if (std::find(kind.endings.begin(), kind.endings.end(), ending) != kind.endings.end())
            files.push_back(entry->path());
    }
    std::sort(files.begin(), files.end());
    std::stable_partition(files.begin(), files.end(), [](const fs::path& file) { return file.stem() == "report"; });
    return files;
}

/// The file that is meant: one of that name, a shipped one with or without its ending, one that lacks only its ending.
/// Empty if there is none. A folder hides nothing.
fs::path find(const Kind& kind, const std::string& name, const fs::path& beside) {
    const fs::path place = beside / name;
    if (name.empty()) return {};
    if (is_file(place)) return place;
    for (const fs::path& file : shipped(kind))
        if (file.filename() == name || file.stem() == name) return file;
    for (const std::string_view ending : kind.endings)
        if (const fs::path longer = place.string() + std::string(ending); is_file(longer)) return longer;
    return {};
}

/// The names of shipped files, the first few where they are many.
std::string list(const Kind& kind, bool with_endings) {
    constexpr std::size_t most = 24;
    const std::vector<fs::path> files = shipped(kind);
    const std::size_t told = files.size() > most ? 8 : files.size();
    std::string text;
    for (const fs::path& file : std::span(files).first(told))
        text += (text.empty() ? "" : ", ") + (with_endings ? file.filename() : file.stem()).string();
    return told < files.size() ? text + " and " + std::to_string(files.size() - told) + " more" : text;
}

/// "did you mean japan? " of a shipped name, or nothing.
std::string suggestion(const Kind& kind, const std::string& name) {
    std::vector<std::string> names;
    for (const fs::path& file : shipped(kind)) {
        names.push_back(file.stem().string());
        names.push_back(file.filename().string());
    }
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    const auto meant = nearest(name, candidates);
    return meant ? "did you mean " + std::string(*meant) + "? " : "";
}

/// Why a name leads to no file, where it is more than that there is none: a loop of links, no permission, a folder.
std::string fault_of(const fs::path& place, const Kind& kind) {
    std::error_code failure;
    const fs::file_type type = fs::status(place, failure).type();
    if (type == fs::file_type::none || type == fs::file_type::unknown) return failure.message();
    if (type == fs::file_type::directory) return "a folder, " + std::string(kind.wanted) + " is wanted";
    return {};
}

fs::path find_or_refuse(const Kind& kind, const std::string& given) {
    const std::string name = meant_path(given);
    if (name.empty()) throw InputError("an empty name, " + std::string(kind.wanted) + " is wanted");
    if (const fs::path file = find(kind, name, {}); !file.empty()) return file;
    std::string fault = fault_of(name, kind);
    if (fault.empty())
        fault = "no such file or shipped " + std::string(kind.name) + "; " + suggestion(kind, name) +
                "shipped: " + list(kind, false);
    throw InputError(one_line(name, 1000) + ": " + fault);
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
    std::vector<std::string> names;
    for (const fs::path& file : shipped(scenes)) names.push_back(file.stem().string());
    return names;
}

fs::path find_scene(const std::string& path_or_name) {
    return find_or_refuse(scenes, path_or_name);
}

fs::path find_picture(const std::string& path_or_name) {
    return find_or_refuse(pictures, path_or_name);
}

std::vector<fs::path> shipped_pictures() {
    return shipped(pictures);
}

fs::path find_texture(const std::string& texture, const fs::path& scene_file, const std::string& place) {
    const std::string name = meant_path(texture);
    if (const fs::path file = find(pictures, name, scene_file.parent_path()); !file.empty()) return file;
    if (const fs::path lost = name; lost.is_absolute()) {  // moved together with the scene, it is where it was to it
        for (const fs::path& folder : {scene_file.parent_path(), scene_file.parent_path() / ".."})
            if (is_file(folder / lost.filename())) return folder / lost.filename();
    }
    std::string fault = name.empty() ? "" : fault_of(scene_file.parent_path() / name, pictures);
    if (fault.empty())
        fault = "neither beside the scene nor in assets/flags; " + suggestion(pictures, name) +
                "there: " + list(pictures, true);
    throw InputError(place + ": flag.texture = " + one_line(in_quotes(texture), 300) + ": " + fault);
}

}  // namespace drapeau
