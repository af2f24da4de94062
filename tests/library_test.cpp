// Saved scenes open again, with their image, from anywhere.
#include "catch.hpp"
#include "error.hpp"
#include "scene_file.hpp"
#include "viewer/library.hpp"

#include "image/image.hpp"

#include <filesystem>
#include <fstream>
#include <random>

using namespace drapeau;
namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path = fs::temp_directory_path() / ("drapeau-library-" + std::to_string(std::random_device{}()));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
};

fs::path picture(const fs::path& file) {
    fs::create_directories(file.parent_path());
    write_png(file, {2, 1, {255, 0, 0, 255, 0, 0, 255, 255}});
    return file;
}

Scene some_scene() {
    return load_scene("report").scene;
}

}  // namespace

TEST_CASE("a scene saved anywhere opens with the image it had") {
    const Folder folder;
    const std::string long_name(180, 'n');
    for (const fs::path& image :
         {picture(folder.path / "a.png"), picture(folder.path / "pictures" / "b.png"),
          picture(folder.path / "d" / "c.png"), picture(folder.path / long_name / long_name / "e.png"),
          picture(folder.path / "fran\xc3\xa7"
                                "ais.png")}) {
        for (const fs::path& place : {folder.path, folder.path / "d"}) {
            INFO(image << " for a scene in " << place);
            const Saved saved = save_scene(some_scene(), (place / "saved").string(), image);
            CHECK_FALSE(saved.without_image);
            const LoadedScene again = load_scene(saved.file.string());
            CHECK(again.fault.empty());
            CHECK(fs::equivalent(again.texture_file, image));
        }
    }
}

TEST_CASE("scene and image moved together find each other") {
    const Folder folder;
    const fs::path image = picture(folder.path / "here" / "pictures" / "a.png");
    const Saved saved = save_scene(some_scene(), (folder.path / "here" / "saved.toml").string(), image);
    fs::rename(folder.path / "here", folder.path / "there");
    const LoadedScene again = load_scene((folder.path / "there" / saved.file.filename()).string());
    CHECK(again.fault.empty());
    CHECK(again.texture_file == folder.path / "there" / "pictures" / "a.png");
}

TEST_CASE("an image path that a scene file cannot hold is left out and said, and the scene opens") {
    const Folder folder;
    for (const char* name : {"fran\xe7"
                             "ais.png",
                             "tab\there.png"}) {
        const fs::path image = picture(folder.path / name);
        const Saved saved = save_scene(some_scene(), (folder.path / "saved.toml").string(), image);
        CHECK(saved.without_image);
        const LoadedScene again = load_scene(saved.file.string());
        CHECK(again.scene.flag.texture.empty());
        CHECK(again.fault.empty());
        // What the window goes on with is a scene that is allowed.
        Scene scene = some_scene();
        scene.flag.texture = texture_name(image);
        CHECK_NOTHROW(check_scene(scene));
    }
}

TEST_CASE("an image that is missing or broken is a message and a plain flag, never a refused scene") {
    const Folder folder;
    Scene scene = some_scene();
    scene.flag.texture = "missing.png";
    const Saved saved = save_scene(scene, (folder.path / "saved.toml").string());
    const LoadedScene missing = load_scene(saved.file.string());
    CHECK(missing.fault.find("missing.png") != std::string::npos);
    CHECK_FALSE(missing.image);
    CHECK(missing.texture_file.empty());
    CHECK(missing.scene == scene);
    std::ofstream(folder.path / "missing.png") << "no picture";
    CHECK(load_scene(saved.file.string()).fault.find("missing.png") != std::string::npos);
    picture(folder.path / "missing.png");
    CHECK(load_scene(saved.file.string()).fault.empty());
}
