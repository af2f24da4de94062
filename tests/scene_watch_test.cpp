// SceneWatch: a file that another program wrote is noticed once it is whole, however it was written.
#include "catch.hpp"
#include "temporary_folder.hpp"

#include "viewer/scene_watch.hpp"

#include <filesystem>
#include <fstream>

using namespace drapeau;
namespace fs = std::filesystem;

namespace {

struct Watched {
    TemporaryFolder folder;
    fs::path file = folder / "scene.toml";
    SceneWatch watch;
    double now = 0.0;  // s

    Watched() {
        write("one");
        watch.begin(file);
    }
    void write(const std::string& text) const { std::ofstream(file, std::ios::binary | std::ios::trunc) << text; }
    /// Looks so often.
    int changes(int looks) {
        int told = 0;
        for (int i = 0; i < looks; ++i) told += watch.changed(now += SceneWatch::pause);
        return told;
    }
};

}  // namespace

TEST_CASE("a file that is written is told once, within a second", "[watch]") {
    Watched watched;
    CHECK(watched.changes(4) == 0);
    watched.write("another");
    CHECK(watched.changes(3) == 1);
    CHECK(watched.changes(4) == 0);
}

TEST_CASE("a file that takes the place of another is a change, of the same length too", "[watch]") {
    Watched watched;
    const auto time = fs::last_write_time(watched.file);
    std::ofstream(watched.folder / "new", std::ios::binary) << "two";
    fs::last_write_time(watched.folder / "new", time);
    fs::rename(watched.folder / "new", watched.file);
    CHECK(watched.changes(3) == 1);
}

TEST_CASE("a file that is away, empty or still growing is waited for", "[watch]") {
    Watched watched;
    fs::remove(watched.file);
    CHECK(watched.changes(4) == 0);
    watched.write("");
    CHECK(watched.changes(4) == 0);
    for (const char* text : {"t", "tw", "two"}) {
        watched.write(text);
        CHECK(watched.changes(1) == 0);
    }
    CHECK(watched.changes(2) == 1);
}

TEST_CASE("what is no file is not read, and neither is what this program wrote", "[watch]") {
    Watched watched;
    watched.write("by this program");
    watched.watch.accept();
    CHECK(watched.changes(4) == 0);
    fs::remove(watched.file);
    fs::create_directory(watched.file);
    CHECK(watched.changes(4) == 0);
    watched.watch.begin({});
    CHECK(watched.changes(4) == 0);
}

TEST_CASE("a file is looked at no more often than the pause between looks", "[watch]") {
    Watched watched;
    CHECK(watched.changes(2) == 0);
    watched.write("another");
    for (int i = 0; i < 100; ++i) CHECK_FALSE(watched.watch.changed(watched.now + 0.001 * i));
}
