// Laws of paths as people give them: typed, pasted with quotes, dropped as an URL.
#include "catch.hpp"
#include "temporary_folder.hpp"

#include "io/error.hpp"
#include "io/given_path.hpp"
#include "scene/file.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using namespace drapeau;
namespace fs = std::filesystem;

namespace {

/// A folder of its own that is the working directory and the home folder meanwhile.
struct Home : TemporaryFolder {
    fs::path before = fs::current_path();
    std::string home_before = std::getenv("HOME") ? std::getenv("HOME") : "";

    Home() {
        fs::current_path(path);
        setenv("HOME", path.c_str(), 1);
    }
    ~Home() {
        fs::current_path(before);
        setenv("HOME", home_before.c_str(), 1);
    }
    void write(const std::string& name) const {
        fs::create_directories((path / name).parent_path());
        std::ofstream(path / name) << "x";
    }
};

template <class Action>
std::string message_from(const Action& action) {
    try {
        action();
    } catch (const InputError& wrong) {
        return wrong.what();
    }
    return {};
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a path means the same however it was typed, quoted or dropped") {
    const Home home;
    const std::string file = (home.path / "my flag é.toml").string();
    const std::string url = "file://" + home.path.string() + "/my%20flag%20%C3%A9.toml";
    const std::vector<std::string> ways{file,
                                        file + " ",
                                        file + "\n",
                                        "\t" + file + "\r\n",
                                        "'" + file + "'",
                                        "\"" + file + "\"",
                                        " '" + file + "' \n",
                                        url,
                                        url + "\r\n",
                                        "file://localhost" + url.substr(7),
                                        "~/my flag é.toml",
                                        "'~/my flag é.toml'"};
    for (const std::string& way : ways) {
        CAPTURE(way);
        CHECK(meant_path(way) == file);
    }
    CHECK(meant_path("~") == home.path.string());
    for (const std::string plain : {"a~", "~other/x", "a b", "it's", "file:x", "file://far/x", "'", "", "100%.toml"}) {
        CAPTURE(plain);
        CHECK(meant_path(plain) == plain);
    }
    CHECK(meant_path("file:///a%00b%zz%4") == "/a%00b%zz%4");
    CHECK(meant_path(" \n").empty());
}

TEST_CASE("a file of exactly the name given is what is meant") {
    const Home home;
    for (const std::string name : {"~", "'quoted'", " spaced ", "file:"}) {
        home.write(name);
        CHECK(meant_path(name) == name);
    }
}

TEST_CASE("a scene or picture is found by whatever its path may look like") {
    const Home home;
    home.write("t1.toml");
    home.write("my.png");
    for (const std::string way : {"t1.toml", "t1", "'t1'", "~/t1", "t1.toml\n"}) {
        CAPTURE(way);
        CHECK(fs::equivalent(find_scene(way), home.path / "t1.toml"));
    }
    for (const std::string way : {"my.png", "my", "~/my.png", "\"my.png\" "}) {
        CAPTURE(way);
        CHECK(fs::equivalent(find_picture(way), home.path / "my.png"));
    }
    for (const std::string way : {"storm", "storm.toml", "storm\n", "'storm'"})
        CHECK(find_scene(way) == assets_directory() / "scenes" / "storm.toml");
    for (const std::string way : {"japan", "japan.png", " japan"})
        CHECK(find_picture(way) == assets_directory() / "flags" / "japan.png");
    // Shipped scenes keep their names; a file whose whole name it is comes first.
    home.write("storm.toml");
    CHECK(find_scene("storm") == assets_directory() / "scenes" / "storm.toml");
    CHECK(fs::equivalent(find_scene("storm.toml"), home.path / "storm.toml"));
    home.write("storm");
    CHECK(fs::equivalent(find_scene("storm"), home.path / "storm"));
}

TEST_CASE("a folder does not hide what is shipped under its name") {
    const Home home;
    for (const std::string name : {"storm", "japan", "japan.png", "t1"}) fs::create_directory(name);
    CHECK(find_scene("storm") == assets_directory() / "scenes" / "storm.toml");
    CHECK(find_picture("japan") == assets_directory() / "flags" / "japan.png");
    CHECK(find_picture("japan.png") == assets_directory() / "flags" / "japan.png");
    CHECK(find_texture("japan.png", home.path / "x.toml", "x.toml") == assets_directory() / "flags" / "japan.png");
    CHECK(has(message_from([] { find_scene("t1"); }), "t1: a folder"));
    CHECK(has(message_from([] { find_picture("t1"); }), "t1: a folder"));
    home.write("t1.toml");
    CHECK(fs::equivalent(find_scene("t1"), home.path / "t1.toml"));
}

TEST_CASE("a name that nothing has is answered by the nearest that there is") {
    const Home home;
    CHECK(has(message_from([] { find_scene("strom"); }), "did you mean storm?"));
    CHECK(has(message_from([] { find_picture("japn"); }), "japn: no such file or shipped image; did you mean japan?"));
    CHECK(has(message_from([] { find_picture("japn.png"); }), "did you mean japan.png?"));
    CHECK(has(message_from([&] { find_texture("japn.png", home.path / "x.toml", "x.toml"); }),
              "did you mean japan.png?"));
}

TEST_CASE("what the system cannot look at is told in the system's words") {
    const Home home;
    fs::create_symlink("loop.toml", "loop.toml");
    const std::string reason = "loop.toml: Too many levels of symbolic links";
    CHECK(message_from([] { find_scene("loop.toml"); }) == reason);
    CHECK(message_from([] { find_picture("loop.toml"); }) == reason);
    CHECK(has(message_from([&] { find_texture("loop.toml", home.path / "x.toml", "x.toml"); }), "Too many levels"));
    CHECK(has(message_from([] { find_scene(std::string(300, 'a')); }), "File name too long"));
    home.write("plain");
    CHECK(has(message_from([] { find_scene("plain/x.toml"); }), "plain/x.toml: no such file"));
}

TEST_CASE("an ending counts in capitals too") {
    CHECK(ending_of("a/B.PNG") == ".png");
    CHECK(ending_of("film.Mp4") == ".mp4");
    CHECK(ending_of("a.b/film").empty());
    CHECK(ending_of("") == "");
}
