// User settings: what is remembered comes back as it was; a file that cannot be used is put aside, never written over.
#include "catch.hpp"
#include "temporary_folder.hpp"

#include "io/error.hpp"
#include "viewer/user_settings.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

using namespace drapeau;
namespace fs = std::filesystem;

namespace {

struct Folder : TemporaryFolder {
    fs::path file = path / "drapeau" / "settings.toml";

    Folder() { fs::create_directories(file.parent_path()); }
};

void write(const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}
std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// An environment variable for a while.
struct Variable {
    const char* name;
    std::string before;
    bool was_set;

    Variable(const char* variable, const char* value) : name(variable) {
        const char* old = std::getenv(name);
        was_set = old;
        if (old) before = old;
        value ? setenv(name, value, 1) : unsetenv(name);
    }
    ~Variable() { was_set ? setenv(name, before.c_str(), 1) : unsetenv(name); }
};

}  // namespace

TEST_CASE("user settings come back as they were written", "[settings]") {
    const Folder folder;
    UserSettings settings;
    settings.width = 900;
    settings.height = 700;
    settings.panel = false;
    settings.page = "Wind";
    settings.recent_scenes = {"/a b/\"quoted\".toml", "/ümlaut\n.toml"};
    settings.recent_images = {"/flag.png"};
    fs::remove_all(folder.file.parent_path());  // the folder is made
    save_user_settings(settings, folder.file);
    const FoundSettings found = find_user_settings(folder.file);
    CHECK(found.settings == settings);
    CHECK(found.trouble.empty());
    CHECK(found.may_be_saved);
}

TEST_CASE("without a file, or in an empty one, settings are defaults and nothing is said", "[settings]") {
    const Folder folder;
    CHECK(find_user_settings(folder.file).settings == UserSettings{});
    CHECK(find_user_settings(folder.file).may_be_saved);
    CHECK_FALSE(find_user_settings({}).may_be_saved);
    write(folder.file, "");
    CHECK(find_user_settings(folder.file).settings == UserSettings{});
    write(folder.file, "of_a_later_version = 1\nwidth = 700\n");
    CHECK(find_user_settings(folder.file).settings.width == 700);
    CHECK(find_user_settings(folder.file).trouble.empty());
}

TEST_CASE("settings that cannot be used are put aside with their bytes, and one sentence says so", "[settings]") {
    const std::string deep = "width = " + std::string(100000, '[');
    for (const std::string& text :
         {std::string("width = nan\n"), std::string("width = 0\n"), std::string("width = 99999999999\n"),
          std::string("width = \"wide\"\n"), std::string("width = 900.5\n"), std::string("panel = 1\n"),
          std::string("page = [\"Wind\"]\n"), std::string("recent_scenes = [1, 2]\n"),
          std::string("recent_scenes = \"one\"\n"), std::string("[width]\na = 1\n"), std::string("\x7f\x45LF\0\1\2", 7),
          std::string("\xff\xfe w"), std::string("width = "), deep, std::string(5000, '['),
          std::string(1 << 20, '#')}) {
        CAPTURE(text.substr(0, 40));
        const Folder folder;
        write(folder.file, text);
        const FoundSettings found = find_user_settings(folder.file);
        CHECK(found.settings == UserSettings{});
        CHECK(found.trouble.find("settings.toml") != std::string::npos);
        CHECK(found.trouble.find('\n') == std::string::npos);
        CHECK(found.may_be_saved);
        CHECK_FALSE(fs::exists(folder.file));
        CHECK(read(folder.file.string() + ".bad") == text);
    }
}

TEST_CASE("what was put aside before stays, a folder in the file's place is put aside too", "[settings]") {
    const Folder folder;
    for (const std::string text : {"width = 1\n", "width = 2\n"}) {
        write(folder.file, text);
        find_user_settings(folder.file);
    }
    fs::create_directory(folder.file);
    const FoundSettings found = find_user_settings(folder.file);
    CHECK(found.settings == UserSettings{});
    CHECK(found.trouble.find(".bad-3") != std::string::npos);
    CHECK(read(folder.file.string() + ".bad") == "width = 1\n");
    CHECK(read(folder.file.string() + ".bad-2") == "width = 2\n");
    CHECK(fs::is_directory(folder.file.string() + ".bad-3"));
}

TEST_CASE("a fault of the settings names its line and what is wanted", "[settings]") {
    try {
        parse_user_settings("panel = true\nheight = 7\n", "settings.toml");
        FAIL("it was taken");
    } catch (const InputError& fault) {
        CHECK(std::string(fault.what()) == "settings.toml:2: height: a whole number from 360 to 16384 is wanted");
    }
}

TEST_CASE("settings that cannot be written are one error, and a file in the folder's place stays", "[settings]") {
    const Folder folder;
    write(folder.path / "taken", "precious");
    CHECK_THROWS_AS(save_user_settings({}, folder.path / "taken" / "drapeau" / "settings.toml"), InputError);
    CHECK(read(folder.path / "taken") == "precious");
    CHECK(find_user_settings(folder.path / "taken" / "settings.toml").settings == UserSettings{});
}

TEST_CASE("the file lies where XDG says, else in the home folder, else nowhere", "[settings]") {
    const Variable home("HOME", "/home/someone");
    {
        const Variable config("XDG_CONFIG_HOME", "/elsewhere");
        CHECK(user_settings_file() == "/elsewhere/drapeau/settings.toml");
    }
    for (const char* useless : {static_cast<const char*>(nullptr), "", "relative"}) {
        const Variable config("XDG_CONFIG_HOME", useless);
        CHECK(user_settings_file() == "/home/someone/.config/drapeau/settings.toml");
        const Variable homeless("HOME", nullptr);
        CHECK(user_settings_file().empty());
    }
}

TEST_CASE("recent files: the newest first, each once, only some, and those with one name show their paths",
          "[settings]") {
    std::vector<std::string> files;
    for (int i = 0; i < 12; ++i) remember_file(files, "/scenes/" + std::to_string(i) + ".toml");
    CHECK(files.size() == max_recent_files);
    CHECK(files.front() == "/scenes/11.toml");
    remember_file(files, "/scenes/9.toml");
    CHECK(files.size() == max_recent_files);
    CHECK(files.front() == "/scenes/9.toml");
    CHECK(std::count(files.begin(), files.end(), "/scenes/9.toml") == 1);

    const std::vector<std::string> alike{"/a/x.toml", "/b/x.toml", "/a/storm.toml", "/a/y.toml"};
    CHECK(shown_names(alike, false, {"storm"}) ==
          std::vector<std::string>{"/a/x.toml", "/b/x.toml", "/a/storm.toml", "y"});
    CHECK(shown_names({"/a/f.png"}, true) == std::vector<std::string>{"f.png"});
}
