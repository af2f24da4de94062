// Output files: whole or as they were, whatever goes wrong.
#include "catch.hpp"
#include "temporary_folder.hpp"

#include "image/image.hpp"
#include "io/error.hpp"
#include "io/output_file.hpp"
#include "viewer/library.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace drapeau;
namespace fs = std::filesystem;

namespace {

/// A folder that everybody may enter.
struct Folder : TemporaryFolder {
    Folder() { fs::permissions(path, fs::perms::all); }

    std::string operator/(const std::string& name) const { return (path / name).string(); }
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const auto& entry : fs::directory_iterator(path)) all.push_back(entry.path().filename().string());
        std::sort(all.begin(), all.end());
        return all;
    }
};

using Names = std::vector<std::string>;

std::string contents(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}
void put(const std::string& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}
void write_text(const std::string& file, const std::string& text) {
    write_file(file, [&](const Append& append) { append(text); });
}
mode_t mode_of(const std::string& file) {
    struct stat status {};
    REQUIRE(stat(file.c_str(), &status) == 0);
    return status.st_mode & 07777;
}

/// What the InputError of `act` says, in a process of its own that `prepare` may take rights from; "" if there is none.
std::string refusal_in_child(const std::function<void()>& prepare, const std::function<void()>& act) {
    std::array<int, 2> ends{};
    REQUIRE(pipe(ends.data()) == 0);
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        std::string said;
        try {
            prepare();
            act();
        } catch (const InputError& wrong) {
            said = wrong.what();
        } catch (...) {
            _exit(2);
        }
        _exit(write(ends[1], said.data(), said.size()) == static_cast<ssize_t>(said.size()) ? 0 : 3);
    }
    close(ends[1]);
    std::string said(4096, '\0');
    std::size_t length = 0;
    for (ssize_t count; (count = read(ends[0], said.data() + length, said.size() - length)) > 0;)
        length += static_cast<std::size_t>(count);
    close(ends[0]);
    int status = -1;
    waitpid(child, &status, 0);
    REQUIRE(WIFEXITED(status));
    REQUIRE(WEXITSTATUS(status) == 0);
    said.resize(length);
    return said;
}

/// No file grows beyond 1000 bytes, as on a disk that is full then.
void disk_is_nearly_full() {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    if (setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(4);
}

/// Rights of a user to whom nothing belongs; the tests may run as one to whom everything does.
void be_nobody_in_particular() {
    if (geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0)) _exit(5);
}

bool says(const std::string& message, const std::string& what) {
    CAPTURE(message, what);
    return message.find(what) != std::string::npos && message.find('\n') == std::string::npos;
}

const std::string long_text(5000, 'x');

Scene long_scene() {
    Scene scene;
    scene.name = std::string(2000, 'n');
    return scene;
}

Image noise() {
    Image image{.width = 64, .height = 64, .rgba = std::vector<std::uint8_t>(64 * 64 * 4)};
    std::mt19937 random(1);
    for (auto& byte : image.rgba) byte = static_cast<std::uint8_t>(random());
    return image;
}

}  // namespace

TEST_CASE("a file holds all that was appended, and its permissions are those of any new file") {
    const Folder folder;
    const mode_t mask = umask(027);
    write_file(folder / "new.txt", [](const Append& append) {
        for (int i = 0; i < 100; ++i) append(long_text);
    });
    umask(mask);
    CHECK(contents(folder / "new.txt").size() == 100 * long_text.size());
    CHECK(mode_of(folder / "new.txt") == 0640);
    CHECK(folder.names() == Names{"new.txt"});
}

TEST_CASE("on a full disk the old file stays, no other appears, and the reason is told") {
    const Folder folder;
    const std::function<void(const std::string&)> writers[] = {
        [](const std::string& file) { write_text(file, long_text); },
        [](const std::string& file) { write_png(file, noise()); },
        [](const std::string& file) { save_scene(long_scene(), file); },
    };
    put(folder / "old.toml", "what was here");
    for (const auto& write : writers) {
        for (const std::string name : {"old.toml", "new.toml"}) {
            const std::string said = refusal_in_child(disk_is_nearly_full, [&] { write(folder / name); });
            CHECK(says(said, folder / name + ": cannot be written: File too large"));
            CHECK(contents(folder / "old.toml") == "what was here");
            CHECK(folder.names() == Names{"old.toml"});
        }
    }
}

TEST_CASE("a writer that fails halfway leaves the old file as it was") {
    const Folder folder;
    put(folder / "old.txt", "what was here");
    CHECK_THROWS_WITH(write_file(folder / "old.txt",
                                 [](const Append& append) {
                                     for (int i = 0; i < 100; ++i) append(long_text);
                                     throw std::runtime_error("halfway");
                                 }),
                      "halfway");
    CHECK(contents(folder / "old.txt") == "what was here");
    CHECK(folder.names() == Names{"old.txt"});
}

TEST_CASE("what is not finished is removed, and files under way to one name do not meet") {
    const Folder folder;
    {
        OutputFile given_up(folder / "film.mp4");
        OutputFile first(folder / "film.mp4"), second(folder / "film.mp4");
        given_up.append("none");
        first.append("first");
        second.append("second");
        CHECK(first.path() != second.path());
        CHECK(first.path().extension() == ".mp4");
        CHECK(first.path().parent_path() == fs::canonical(folder.path));
        second.finish();
        CHECK(contents(folder / "film.mp4") == "second");
        first.finish();
    }
    CHECK(contents(folder / "film.mp4") == "first");
    CHECK(folder.names() == Names{"film.mp4"});
}

TEST_CASE("a folder without permission, or none at all, is refused in one line and before anything is written") {
    const Folder folder;
    fs::create_directory(folder / "shut");
    put(folder / "shut/old.txt", "what was here");
    fs::permissions(folder / "shut", fs::perms(0555));
    fs::permissions(folder / "shut/old.txt", fs::perms(0666));
    for (const std::string name : {"shut/new.txt", "shut/old.txt"}) {
        const std::string file = folder / name;
        CHECK(says(refusal_in_child(be_nobody_in_particular, [&] { write_text(file, "new"); }),
                   file + ": cannot be written: Permission denied"));
        CHECK(says(refusal_in_child(be_nobody_in_particular, [&] { check_writable(file); }),
                   file + ": cannot be written: Permission denied"));
    }
    CHECK(contents(folder / "shut/old.txt") == "what was here");
    CHECK_THROWS_WITH(write_text(folder / "missing/new.txt", "new"),
                      folder / "missing/new.txt" + ": cannot be written: No such file or directory");
    CHECK_THROWS_WITH(write_text(folder / "shut", "new"), folder / "shut" + ": a folder, a file to write is wanted");
    CHECK_THROWS_WITH(write_text(folder / "new/", "new"), ContainsSubstring("cannot be written"));
    CHECK_THROWS_AS(write_text("", "new"), InputError);
    CHECK(folder.names() == Names{"shut"});
}

TEST_CASE("a file that may not be written is not replaced") {
    const Folder folder;
    put(folder / "kept.txt", "what was here");
    fs::permissions(folder / "kept.txt", fs::perms(0444));
    const std::string file = folder / "kept.txt";
    CHECK(says(refusal_in_child(be_nobody_in_particular, [&] { write_text(file, "new"); }), "Permission denied"));
    CHECK(says(refusal_in_child(be_nobody_in_particular, [&] { check_writable(file); }), "Permission denied"));
    CHECK(contents(file) == "what was here");
    CHECK(folder.names() == Names{"kept.txt"});
}

TEST_CASE("an existing file keeps its permissions") {
    const Folder folder;
    for (const mode_t mode : {0600u, 0640u, 0755u, 0666u}) {
        put(folder / "old.txt", "old");
        REQUIRE(chmod((folder / "old.txt").c_str(), mode) == 0);
        write_text(folder / "old.txt", "new");
        CHECK(contents(folder / "old.txt") == "new");
        CHECK(mode_of(folder / "old.txt") == mode);
    }
}

TEST_CASE("links are followed, to a file that is there or not, and stay links") {
    const Folder folder;
    fs::create_directory(folder / "far");
    put(folder / "far/old.txt", "old");
    fs::create_symlink("far/old.txt", folder / "link");
    fs::create_symlink("link", folder / "link to link");
    fs::create_symlink("far/new.txt", folder / "dangling");
    fs::create_symlink("round", folder / "round");

    write_text(folder / "link to link", "replaced");
    CHECK(contents(folder / "far/old.txt") == "replaced");
    check_writable(folder / "dangling");
    CHECK(!fs::exists(folder / "far/new.txt"));
    write_text(folder / "dangling", "made");
    CHECK(contents(folder / "far/new.txt") == "made");
    CHECK_THROWS_AS(write_text(folder / "round", "nowhere"), InputError);

    for (const std::string name : {"link", "link to link", "dangling", "round"}) CHECK(fs::is_symlink(folder / name));
    CHECK(folder.names() == Names{"dangling", "far", "link", "link to link", "round"});
    CHECK(fs::exists(folder / "far/old.txt"));
    CHECK(std::distance(fs::directory_iterator(folder / "far"), {}) == 2);
}

TEST_CASE("a trial leaves nothing behind and touches nothing") {
    const Folder folder;
    put(folder / "old.txt", "old");
    const auto written = fs::last_write_time(folder / "old.txt");
    check_writable(folder / "old.txt");
    check_writable(folder / "new.txt");
    CHECK(folder.names() == Names{"old.txt"});
    CHECK(fs::last_write_time(folder / "old.txt") == written);
    CHECK(contents(folder / "old.txt") == "old");
}

TEST_CASE("devices and pipes are written as they are") {
    CHECK_THROWS_WITH(check_writable("/proc/none"), "/proc/none: cannot be written: No such file or directory");
    {
        // Who may make devices could also break the system's own: such a test writes to some of its own.
        const Folder folder;
        const auto device = [&](const std::string& name, unsigned minor) {
            const bool made = mknod((folder / name).c_str(), S_IFCHR | 0666, makedev(1, minor)) == 0;
            return made ? folder / name : "/dev/" + name;
        };
        const std::string full = device("full", 7), null = device("null", 3);
        CHECK_THROWS_WITH(write_text(full, "any"), full + ": cannot be written: No space left on device");
        write_text(null, long_text);
        CHECK(fs::is_character_file(null));
    }

    // Through a link too.
    const Folder folder;
    REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
    fs::create_symlink("pipe", folder / "link");
    std::string read;
    std::thread reader([&] { read = contents(folder / "pipe"); });
    write_text(folder / "link", long_text);
    reader.join();
    CHECK(read == long_text);
    CHECK(fs::is_fifo(folder / "pipe"));
    CHECK(folder.names() == Names{"link", "pipe"});
}
