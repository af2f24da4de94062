#include "library.hpp"

#include "error.hpp"
#include "image/image_file.hpp"
#include "output_file.hpp"
#include "scene_file.hpp"

#include <algorithm>
#include <cstdio>
#include <system_error>

namespace drapeau {

namespace fs = std::filesystem;

LoadedScene load_scene(const std::string& path_or_name) {
    LoadedScene loaded;
    loaded.file = find_scene(path_or_name);
    loaded.scene = read_scene(loaded.file);
    if (loaded.scene.flag.texture.empty()) return loaded;
    loaded.texture_file = find_texture(loaded.scene.flag.texture, loaded.file);
    loaded.image = load_image(loaded.texture_file);
    return loaded;
}

std::vector<fs::path> shipped_images() {
    std::vector<fs::path> files;
    std::error_code failure;
    for (fs::directory_iterator entry(assets_directory() / "flags", failure), end; !failure && entry != end;
         entry.increment(failure)) {
        const std::string ending = entry->path().extension().string();
        if (ending == ".png" || ending == ".jpg" || ending == ".jpeg") files.push_back(entry->path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

fs::path find_image(const std::string& path_or_name) {
    std::error_code failure;
    if (fs::exists(path_or_name, failure)) return path_or_name;
    for (const fs::path& file : shipped_images())
        if (file.filename() == path_or_name || file.stem() == path_or_name) return file;
    throw InputError(path_or_name + ": no such image");
}

std::string texture_name(const fs::path& image) {
    if (image.empty()) return {};
    std::error_code failure;
    const fs::path folder = image.parent_path();
    if (fs::equivalent(folder, assets_directory() / "flags", failure)) return image.filename().string();
    return fs::absolute(image, failure).string();
}

fs::path save_scene(const Scene& scene, const std::string& path) {
    if (path.empty()) throw InputError("a scene needs a file name to be saved, for example my-flag.toml");
    fs::path file = path;
    if (!file.has_extension()) file += ".toml";
    write_file(file.string(), [&](const Append& append) { append(write_scene(scene)); });
    return fs::absolute(file);
}

fs::path free_screenshot_name() {
    std::error_code failure;
    for (int number = 1;; ++number) {
        char name[40];
        std::snprintf(name, sizeof name, "drapeau-%03d.png", number);
        if (!fs::exists(name, failure)) return name;
    }
}

}  // namespace drapeau
