#include "saved_scene.hpp"

#include "io/error.hpp"
#include "scene/file.hpp"

namespace drapeau::lab {

namespace fs = std::filesystem;

Scene as_saved(const Scene& scene, const fs::path& from) {
    Scene saved = scene;
    if (std::string& texture = saved.flag.texture; !texture.empty()) {
        try {
            const fs::path image = find_texture(texture, from, from.string());
            std::error_code failure;
            const bool is_shipped = fs::equivalent(image.parent_path(), assets_directory() / "flags", failure);
            texture = is_shipped ? image.filename().string() : fs::absolute(image).string();
        } catch (const InputError&) {  // the laboratory needs no image
        }
    }
    return saved;
}

}  // namespace drapeau::lab
