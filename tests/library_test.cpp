// Saved scenes open again, with their image, from anywhere.
#include "catch.hpp"
#include "temporary_folder.hpp"
#include "io/error.hpp"
#include "scene/file.hpp"
#include "viewer/library.hpp"
#include "viewer/saving.hpp"

#include "image/image.hpp"

#include <filesystem>
#include <fstream>

using namespace drapeau;
namespace fs = std::filesystem;

namespace {

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
    const TemporaryFolder folder;
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
    const TemporaryFolder folder;
    const fs::path image = picture(folder.path / "here" / "pictures" / "a.png");
    const Saved saved = save_scene(some_scene(), (folder.path / "here" / "saved.toml").string(), image);
    fs::rename(folder.path / "here", folder.path / "there");
    const LoadedScene again = load_scene((folder.path / "there" / saved.file.filename()).string());
    CHECK(again.fault.empty());
    CHECK(again.texture_file == folder.path / "there" / "pictures" / "a.png");

    // Above the scene's folder or, brought there from elsewhere, beside it.
    const fs::path above = picture(folder.path / "home" / "b.png");
    fs::create_directories(folder.path / "home" / "scenes");
    save_scene(some_scene(), (folder.path / "home" / "scenes" / "s.toml").string(), above);
    fs::rename(folder.path / "home", folder.path / "away");
    CHECK(load_scene((folder.path / "away" / "scenes" / "s.toml").string()).fault.empty());
    fs::rename(folder.path / "away" / "b.png", folder.path / "away" / "scenes" / "b.png");
    CHECK(load_scene((folder.path / "away" / "scenes" / "s.toml").string()).fault.empty());
    fs::remove(folder.path / "away" / "scenes" / "b.png");
    CHECK_FALSE(load_scene((folder.path / "away" / "scenes" / "s.toml").string()).fault.empty());
}

TEST_CASE("an image path that a scene file cannot hold is left out and said, and the scene opens") {
    const TemporaryFolder folder;
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
    const TemporaryFolder folder;
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

TEST_CASE("a scene is saved without a question only where nothing is lost") {
    const TemporaryFolder folder;
    const auto question = [&](const fs::path& file, const std::vector<fs::path>& own = {}) {
        return question_before_saving(file, own, {}).value_or("");
    };
    const fs::path scene = folder.path / "scene.toml";
    CHECK(question(scene).empty());
    save_scene(some_scene(), scene);
    CHECK(question(scene) == scene.string() + " exists. Overwrite it?");
    const fs::path link = folder.path / "link.toml";
    fs::create_symlink(scene, link);
    CHECK(question(link).starts_with(link.string() + " exists."));
    CHECK(question(scene, {folder.path / "gone.toml", link}).empty());
    CHECK(question(link, {scene}).empty());
    for (const std::string content : {"no scene", "", "[springs]\nmass = -1\n"}) {
        const fs::path foreign = folder.path / "foreign.toml";
        std::ofstream(foreign) << content;
        CHECK(question(foreign).find(" exists and is not a scene.") != std::string::npos);
    }
    CHECK(question("/dev/null").empty());
}

TEST_CASE("a scene is never saved over the image on its flag") {
    const TemporaryFolder folder;
    const fs::path image = picture(folder.path / "a.png"), link = folder.path / "b.toml";
    fs::create_symlink(image, link);
    for (const fs::path& name : {image, link})
        CHECK_THROWS_WITH(question_before_saving(name, {image}, image), ContainsSubstring("the image on the flag"));
    CHECK(question_before_saving(image, {}, {})->find("is not a scene") != std::string::npos);
}

TEST_CASE("a scene gets the path that was typed, with an ending") {
    CHECK(scene_path("/tmp/flag") == "/tmp/flag.toml");
    CHECK(scene_path("/tmp/flag.txt") == "/tmp/flag.txt");
    CHECK(scene_path("flag") == fs::current_path() / "flag.toml");
    CHECK_THROWS_AS(scene_path(""), InputError);
}

TEST_CASE("what would not open again to the same scene is not saved, and the file stays as it was") {
    const TemporaryFolder folder;
    const fs::path file = folder.path / "scene.toml";
    save_scene(some_scene(), file);
    Scene impossible = some_scene();
    impossible.flag.columns = 0;
    CHECK_THROWS_AS(save_scene(impossible, file), InputError);
    CHECK(load_scene(file.string()).scene == some_scene());
}
