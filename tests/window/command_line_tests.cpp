// The program as a command: what it says and gives back without anybody touching the window.
#include "app.hpp"
#include "image/image_file.hpp"
#include "pixels.hpp"
#include "scenes.hpp"

#include "catch.hpp"

#include <algorithm>

using namespace drapeau::window_tests;

namespace {

Finished drapeau_run(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
    const TemporaryFolder home;
    std::vector<std::string> command{program()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return run(command, at_home_in(home, surroundings), 2.0 * patience);
}

Surroundings without_display() {
    return {.variables = {{"DISPLAY", std::nullopt}, {"WAYLAND_DISPLAY", std::nullopt}}, .folder = {}};
}

bool is_one_line(const std::string& text) {
    return text.size() > 1 && text.back() == '\n' && std::count(text.begin(), text.end(), '\n') == 1;
}

}  // namespace

TEST_CASE("help, version and the list of scenes need no display") {
    for (const std::string option : {"--help", "--version", "--scene-list"}) {
        CAPTURE(option);
        const Finished answer = drapeau_run({option}, without_display());
        CHECK(answer.status == 0);
        CHECK(answer.errors.empty());
        CHECK(!answer.output.empty());
    }
    const std::string scenes = drapeau_run({"--scene-list"}, without_display()).output;
    for (const std::string name : {"report", "breeze", "storm", "calm", "banner", "drop", "drum", "spring"})
        CHECK(scenes.find(name) != std::string::npos);
}

TEST_CASE("a bad command line gives one line that names what is wrong, and status 2") {
    const TemporaryFolder folder;
    struct Case {
        std::vector<std::string> arguments;
        std::string named;
    };
    const std::vector<Case> cases{
        {{"--no-such-option"}, "no-such-option"},
        {{"no-such-scene"}, "no-such-scene"},
        {{written(folder, "broken.toml", "[flag]\ncolumns = \"many\"\n")}, "columns"},
        {{written(folder, "empty.toml", "")}, "empty.toml"},
        {{folder.path().string()}, folder.path().string()},
        {{"--size", "enormous", "--frames", "1", "--screenshot", folder / "a.png"}, "size"},
        {{"--size", "0x0", "--frames", "1", "--screenshot", folder / "a.png"}, "size"},
        {{"--frames", "-1", "--screenshot", folder / "a.png"}, "frames"},
        {{"--frames", "two", "--screenshot", folder / "a.png"}, "frames"},
        {{"--frames", "1", "--screenshot", folder / "missing-folder/a.png"}, "missing-folder"},
        {{"report", "storm"}, "storm"},
    };
    const Screen screen;
    for (const Case& bad : cases) {
        CAPTURE(bad.arguments);
        const Finished answer = drapeau_run(bad.arguments, screen.surroundings());
        CAPTURE(answer.errors);
        CHECK(answer.status == 2);
        CHECK(answer.output.empty());
        CHECK(is_one_line(answer.errors));
        CHECK(answer.errors.find(bad.named) != std::string::npos);
    }
}

TEST_CASE("without a display it says so in one line") {
    const Finished answer = drapeau_run({}, without_display());
    CAPTURE(answer.errors);
    CHECK(answer.status == 2);
    CHECK(answer.output.empty());
    CHECK(is_one_line(answer.errors));
    CHECK(answer.errors.find("display") != std::string::npos);
}

TEST_CASE("the same run gives the same picture, byte for byte, and another moment another one") {
    const Screen screen;
    const TemporaryFolder folder;
    const auto picture_after = [&](const std::string& frames, const std::string& name) {
        const std::string file = folder / name;
        const Finished answer = drapeau_run({"report", "--frames", frames, "--size", "640x480", "--screenshot", file},
                                            screen.surroundings());
        CAPTURE(answer.errors);
        REQUIRE(answer.status == 0);
        CHECK(answer.errors.empty());
        return file;
    };
    const std::string first = picture_after("20", "first.png"), second = picture_after("20", "second.png");
    const std::string later = picture_after("40", "later.png");
    CHECK(read_text(first) == read_text(second));
    CHECK(read_text(first) != read_text(later));

    const drapeau::Image picture = drapeau::load_image(first);
    CHECK(picture.width == 640);
    CHECK(picture.height == 480);
}

TEST_CASE("a picture without panels shows the flag's colours, blue at the pole and red at the fly") {
    const Screen screen;
    const TemporaryFolder folder;
    const std::string file = folder / "flag.png";
    const Finished answer = drapeau_run({written(folder, "still.toml", still_scene), "--frames", "2", "--hide-ui",
                                         "--size", "640x480", "--screenshot", file},
                                        screen.surroundings());
    CAPTURE(answer.errors);
    REQUIRE(answer.status == 0);

    // The flag is in the middle; a third of its width is more than a tenth of the picture's.
    const drapeau::Image picture = drapeau::load_image(file);
    const Colour left = colour_around(picture, {0.5 * 640 - 90, 240});
    const Colour middle = colour_around(picture, {0.5 * 640, 240});
    const Colour right = colour_around(picture, {0.5 * 640 + 90, 240});
    CHECK(left.blue > left.red + 30);
    CHECK(middle.vividness() < 40);
    CHECK(middle.red > 120);
    CHECK(right.red > right.blue + 60);
}

TEST_CASE("a film that cannot be made leaves the file of that name as it was, and one line says why") {
    const Screen screen;
    const TemporaryFolder folder;
    const std::string file = written(folder, "film.no-such-format", "what was here");
    const Finished answer =
        drapeau_run({"report", "--frames", "3", "--size", "320x240", "--film", file}, screen.surroundings());
    CAPTURE(answer.errors);
    CHECK(answer.status == 2);
    CHECK(is_one_line(answer.errors));
    CHECK(answer.errors.find("film.no-such-format: ffmpeg could not make it: ") != std::string::npos);
    CHECK(read_text(file) == "what was here");
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}
