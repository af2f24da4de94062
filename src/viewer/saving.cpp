#include "saving.hpp"

#include "io/error.hpp"
#include "scene/file.hpp"

#include <algorithm>

namespace drapeau {

namespace fs = std::filesystem;

namespace {

bool is_scene(const fs::path& file) {
    try {
        read_scene(file);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

}  // namespace

fs::path scene_path(const std::string& typed) {
    if (typed.empty()) throw InputError("a scene needs a file name to be saved, for example my-flag.toml");
    fs::path file = typed;
    if (!file.has_extension()) file += ".toml";
    return fs::absolute(file);
}

std::optional<std::string> question_before_saving(const fs::path& file, const std::vector<fs::path>& own,
                                                  const fs::path& image) {
    std::error_code failure;
    if (!fs::is_regular_file(file, failure)) return {};
    const auto is_same = [&](const fs::path& other) { return fs::equivalent(other, file, failure); };
    if (!image.empty() && is_same(image))
        throw InputError(file.string() + ": the image on the flag; choose another name for the scene");
    if (std::any_of(own.begin(), own.end(), is_same)) return {};
    return file.string() + " exists" + (is_scene(file) ? "." : " and is not a scene.") + " Overwrite it?";
}

}  // namespace drapeau
