#include "library.hpp"

#include "image/image_file.hpp"
#include "io/error.hpp"
#include "io/output_file.hpp"
#include "saving.hpp"
#include "scene/file.hpp"
#include "scene/settings.hpp"

#include <fmt/format.h>

namespace drapeau {

namespace fs = std::filesystem;

LoadedScene load_scene(const std::string& path_or_name, std::span<const Assignment> assignments,
                       const std::stop_token& stop) {
    LoadedScene loaded;
    loaded.file = find_scene(path_or_name);
    loaded.scene = read_scene(loaded.file, assignments);
    if (loaded.scene.flag.texture.empty()) return loaded;
    try {
        const fs::path file = find_texture(loaded.scene.flag.texture, loaded.file, place_of_texture(loaded.file));
        loaded.image = load_image(file, stop);
        loaded.texture_file = file;
    } catch (const InputError& fault) {
        loaded.fault = fault.what();
    }
    return loaded;
}

std::string texture_name(const fs::path& image, const fs::path& folder) {
    if (image.empty()) return {};
    std::error_code failure;
    fs::path named = fs::absolute(image, failure);
    if (fs::equivalent(image.parent_path(), assets_directory() / "flags", failure)) {
        named = image.filename();
    } else if (!folder.empty()) {
        const fs::path way =
            fs::weakly_canonical(image, failure).lexically_relative(fs::weakly_canonical(folder, failure));
        if (!way.empty() && *way.begin() != "..") named = way;
    }
    const std::string name = named.string();
    return settings::is_allowed(name, {}) ? name : "";
}

Saved save_scene(Scene scene, const fs::path& path, const fs::path& image) {
    const fs::path file = scene_path(path.string());
    if (!image.empty()) scene.flag.texture = texture_name(image, file.parent_path());
    const std::string text = write_scene(scene);
    if (parse_scene(text, file.string()) != scene)
        throw InputError(file.string() + ": not saved, for the file would not open to the same scene");
    write_file(file.string(), [&](const Append& append) { append(text); });
    return {file, !image.empty() && scene.flag.texture.empty()};
}

fs::path free_file_name(const std::string& ending) {
    std::error_code failure;
    for (int number = 1;; ++number) {
        const std::string name = fmt::format("drapeau-{:03}{}", number, ending);
        if (!fs::exists(name, failure)) return name;
    }
}

fs::path free_screenshot_name() {
    return free_file_name(".png");
}

}  // namespace drapeau
