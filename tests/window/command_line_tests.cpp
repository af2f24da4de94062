// The program as a command: what it says and gives back without anybody touching the window.
#include "app.hpp"
#include "image/image_file.hpp"
#include "pixels.hpp"
#include "scenes.hpp"

#include "catch.hpp"

#include <algorithm>
#include <array>
#include <cmath>

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

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Bad input as it should be: status 2, one visible line on standard error that says this, nothing on standard output.
void check_refused(const Finished& answer, const std::string& part) {
    CAPTURE(answer.errors);
    CHECK(answer.status == 2);
    CHECK(answer.output.empty());
    CHECK(is_one_line(answer.errors));
    CHECK(has(answer.errors, part));
}

/// The program with its standard output going where the shell sends it: ">/dev/full".
Finished run_into(const std::string& where, const std::string& option) {
    return run({"sh", "-c", "exec '" + program() + "' " + option + " " + where}, without_display());
}

/// One value that ffprobe tells of a film's picture, such as "color_space".
std::string probed(const std::string& film, const std::string& entry) {
    const Finished answer = run({"ffprobe", "-v", "error", "-select_streams", "v", "-show_entries", "stream=" + entry,
                                 "-of", "default=nokey=1:noprint_wrappers=1", film});
    return answer.output.substr(0, answer.output.find('\n'));
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
        {{folder.path.string()}, folder.path.string()},
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

TEST_CASE("a program without its scenes says where it looked for them") {
    const TemporaryFolder folder;
    const std::string alone = folder / "drapeau";
    std::filesystem::copy(DRAPEAU_PROGRAM, alone);
    for (const std::string argument : {"--scene-list", "report"}) {
        const Finished answer = run({alone, argument}, without_display());
        CAPTURE(argument, answer.errors);
        CHECK(answer.status == 2);
        CHECK(is_one_line(answer.errors));
        CHECK(answer.errors.find(folder.path.string()) != std::string::npos);
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
    const std::string file = written(folder, "film.mp4", "what was here");
    // A program of that name that makes no film.
    const std::string stand_in = written(folder, "ffmpeg", "#!/bin/sh\necho no such codec >&2\nexit 1\n");
    std::filesystem::permissions(stand_in, std::filesystem::perms::owner_all);
    Surroundings surroundings = screen.surroundings();
    surroundings.variables["PATH"] = folder.path.string() + ":/usr/bin:/bin";
    const Finished answer = drapeau_run({"report", "--frames", "3", "--size", "320x240", "--film", file}, surroundings);
    check_refused(answer, "film.mp4: ffmpeg could not make it: no such codec");
    CHECK(read_text(file) == "what was here");
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path), {}) == 2);
}

TEST_CASE("a setting given on the command line is the scene's") {
    TemporaryFolder folder;
    Screen screen;
    const std::string scene = written(folder, "still.toml", still_scene);
    for (const std::string file : {"as-it-is.png", "higher.png"}) {
        std::vector<std::string> words{scene, "--frames", "1", "--hide-ui", "--size", "320x240", "--screenshot"};
        words.push_back(folder / file);
        if (file == "higher.png") words.insert(words.end(), {"--set", "flag.height=2", "--set=view.texture=off"});
        REQUIRE(drapeau_run(words, screen.surroundings()).status == 0);
    }
    CHECK(read_text(folder / "as-it-is.png") != read_text(folder / "higher.png"));
    check_refused(drapeau_run({scene, "--set", "flag.columns=0"}, without_display()),
                  "--set flag.columns = 0: a whole number from 1 to 4096 is allowed");
}

TEST_CASE("an option given an empty value is refused, not taken for absent") {
    for (const std::string option :
         {"--frames", "--screenshot", "--film", "--size", "--texture", "--azimuth", "--elevation"}) {
        CAPTURE(option);
        check_refused(drapeau_run({"report", option, ""}, without_display()), option + ": an empty value");
        check_refused(drapeau_run({"report", option + "="}, without_display()), option + ": an empty value");
        check_refused(drapeau_run({option + "=", "report"}, without_display()), option + ": an empty value");
    }
    check_refused(drapeau_run({"report", "--size", "320x200", "--size", "400x300"}, without_display()),
                  "--size is given more than once");
    check_refused(drapeau_run({"report", "--set="}, without_display()), "--set: an empty value");
    check_refused(drapeau_run({"report", "--hide-ui="}, without_display()), "--hide-ui takes no value");
    for (const std::string nothing : {"", " ", "''", "\n"})
        check_refused(drapeau_run({nothing}, without_display()), "SCENE: an empty value");
}

TEST_CASE("a message is one visible line, whatever the names in it hold") {
    for (const std::string name : {"a\x1b[2Jb", "a\nb", "a\tb", "a\xff", "a\xc2\x9b"}) {
        const std::vector<std::vector<std::string>> cases{{name},
                                                          {"--" + name},
                                                          {"--texture", name},
                                                          {"--frames", name},
                                                          {"--size", name},
                                                          {"--azimuth", name},
                                                          {"--frames", "1", "--screenshot", "none/" + name},
                                                          {"--frames", "1", "--film", name}};
        for (const auto& arguments : cases) {
            CAPTURE(arguments);
            const Finished answer = drapeau_run(arguments, without_display());
            check_refused(answer, "\\");
            CHECK(std::all_of(answer.errors.begin(), answer.errors.end() - 1,
                              [](char c) { return c >= ' ' && c <= '~'; }));
        }
    }
}

TEST_CASE("whatever is for standard output fails where it cannot be written") {
    for (const std::string option : {"--help", "--version", "--scene-list"}) {
        CAPTURE(option);
        check_refused(run_into(">/dev/full", option), "standard output cannot be written: No space left");
        check_refused(run_into(">&-", option), "standard output cannot be written: Bad file descriptor");
    }
}

TEST_CASE("the help tells exit statuses, an example and the key that lists the keys") {
    const std::string help = drapeau_run({"--help"}, without_display()).output;
    for (const std::string part : {"Exit status: 0 good, 1", "Example: drapeau ", "F1"}) CHECK(has(help, part));
}

TEST_CASE("a film's ending is one of those known, in capitals or not, and a picture's is .png") {
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& option, const std::string& name, const std::string& part) {
        CAPTURE(name);
        // Without a display: refused before there could be any work.
        check_refused(drapeau_run({"--frames", "1", option, folder / name}, without_display()), part);
    };
    for (const std::string name : {"a.no-such-format", "a.txt", "a.png", "a.toml"})
        refused("--film", name, name + ": .mp4, .mov, .mkv, .webm or .gif is allowed");
    refused("--film", "a", "a: .mp4, .mov, .mkv, .webm or .gif is allowed");
    for (const std::string name : {"a.jpg", "a.JPEG", "a.bmp", "a.mp4"})
        refused("--screenshot", name, name + ": .png is allowed");
    CHECK(std::filesystem::is_empty(folder.path));

    const Screen screen;
    for (const std::string name : {"A.MP4", "A.WebM", "A.GIF", "a.mkv", "a.mov"}) {
        CAPTURE(name);
        const Finished answer = drapeau_run(
            {"spring", "--frames", "2", "--size", "320x240", "--film", folder / name, "--screenshot", folder / "A.PNG"},
            screen.surroundings());
        CAPTURE(answer.errors);
        CHECK(answer.status == 0);
        CHECK(probed(folder / name, "width") == "320");
        CHECK(read_text(folder / "A.PNG").starts_with("\x89PNG"));
    }
    CHECK(probed(folder / "A.MP4", "codec_name") == "h264");
    CHECK(probed(folder / "A.GIF", "codec_name") == "gif");
    // A name without an ending is taken as it is: a PNG.
    const Finished bare =
        drapeau_run({"spring", "--frames", "1", "--screenshot", folder / "bare"}, screen.surroundings());
    CHECK(bare.status == 0);
    CHECK(read_text(folder / "bare").starts_with("\x89PNG"));
}

TEST_CASE("a film has the colours of its pictures, and says that they are BT.709") {
    const Screen screen;
    const TemporaryFolder folder;
    const std::string scene = written(folder, "still.toml", still_scene), picture_file = folder / "p.png";
    constexpr int width = 640, height = 480;
    for (const std::string name : {"f.mp4", "f.webm"}) {
        CAPTURE(name);
        const std::string film = folder / name;
        const Finished answer = drapeau_run(
            {scene, "--frames", "3", "--hide-ui", "--size", "640x480", "--film", film, "--screenshot", picture_file},
            screen.surroundings());
        CAPTURE(answer.errors);
        REQUIRE(answer.status == 0);
        for (const std::string entry : {"color_space", "color_primaries", "color_transfer"})
            CHECK(probed(film, entry) == "bt709");
        CHECK(probed(film, "color_range") == "tv");

        // The last frame as it is stored, Y then Cb then Cr of every other pixel, turned back by BT.709's own
        // equations.
        const std::string stored = folder / "f.yuv";
        REQUIRE(run({"ffmpeg", "-nostdin", "-loglevel", "error", "-y", "-i", film, "-vf", "select=eq(n\\,2)", "-vsync",
                     "0", "-f", "rawvideo", "-pix_fmt", "yuv420p", stored})
                    .status == 0);
        const std::string bytes = read_text(stored);
        REQUIRE(bytes.size() == std::size_t(width * height * 3 / 2));
        const auto value = [&](int at) { return double(static_cast<unsigned char>(bytes[std::size_t(at)])); };
        const drapeau::Image picture = drapeau::load_image(picture_file);
        // The middles of the three bands: a square of 16 pixels in plain cloth, so that halved chroma loses nothing.
        for (const int middle : {width / 2 - 90, width / 2, width / 2 + 90}) {
            std::array<double, 3> shown{}, stored_colour{};
            for (int y = height / 2 - 8; y < height / 2 + 8; ++y)
                for (int x = middle - 8; x < middle + 8; ++x) {
                    const int chroma = width * height + (y / 2) * (width / 2) + x / 2;
                    const double luma = (value(y * width + x) - 16.0) / 219.0;
                    const double blue = (value(chroma) - 128.0) / 224.0;
                    const double red = (value(chroma + width * height / 4) - 128.0) / 224.0;
                    // R - Y = 2 (1 - 0.2126) Cr and B - Y = 2 (1 - 0.0722) Cb; G follows from Y.
                    const double r = luma + 1.5748 * red, b = luma + 1.8556 * blue;
                    const double g = (luma - 0.2126 * r - 0.0722 * b) / 0.7152;
                    stored_colour[0] += r;
                    stored_colour[1] += g;
                    stored_colour[2] += b;
                    for (std::size_t c = 0; c < 3; ++c)
                        shown[c] += picture.rgba[std::size_t(y * width + x) * 4 + c] / 255.0;
                }
            for (std::size_t c = 0; c < 3; ++c) {
                CAPTURE(middle, c);
                // Rounding to a step of Y (255/219) and of a chroma (255/224), half a step each, is at most
                // 0.6 + 1.86 * 0.57 = 1.7 of 255; as much again for the codec's own rounding. BT.601 is 13 off.
                CHECK(std::abs(stored_colour[c] - shown[c]) * 255.0 / 256.0 < 3.4);
            }
        }
    }
}

TEST_CASE("an output is not what is read, nor another output, whatever its name") {
    const TemporaryFolder folder;
    std::filesystem::copy_file(std::filesystem::path(DRAPEAU_ASSETS) / "flags" / "france.png", folder / "france.png");
    std::filesystem::copy_file(std::filesystem::path(DRAPEAU_ASSETS) / "flags" / "japan.png", folder / "p.png");
    const std::string scene = written(folder, "still", still_scene);  // names france.png, which lies beside it
    std::filesystem::create_symlink("new.mp4", folder / "link.png");
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{"--screenshot", folder / "still"},
         "--screenshot = " + (folder / "still").string() + ": the same file as the scene"},
        {{"--screenshot", folder / "france.png"}, "the same file as the scene's texture"},
        {{"--texture", folder / "p.png", "--screenshot", folder / "p.png"}, "the same file as --texture"},
        {{"--film", folder / "new.mp4", "--screenshot", folder / "link.png"}, "--film = "}};
    for (const auto& [outputs, part] : cases) {
        std::vector<std::string> arguments{scene, "--frames", "1"};
        arguments.insert(arguments.end(), outputs.begin(), outputs.end());
        CAPTURE(arguments);
        // Without a display: refused before there could be any work.
        const Finished answer = drapeau_run(arguments, without_display());
        check_refused(answer, part);
        check_refused(answer, "the same file as");
    }
    CHECK(read_text(folder / "still") == still_scene);
}

TEST_CASE("a file whose name begins with a dash can be given, and the message says how") {
    const Screen screen;
    const TemporaryFolder folder;
    written(folder, "-dash.toml", still_scene);
    const auto run_there = [&](std::vector<std::string> arguments) {
        Surroundings surroundings = screen.surroundings();
        surroundings.folder = folder.path;
        arguments.insert(arguments.begin(), program());
        return run(arguments, surroundings);
    };
    check_refused(run_there({"-dash.toml", "--frames", "1"}),
                  "-dash.toml begins with a dash: a file of that name is given as ./-dash.toml or after --");
    CHECK(run_there({"--frames", "1", "--", "-dash.toml"}).status == 0);
    CHECK(run_there({"--frames", "1", "./-dash.toml"}).status == 0);
}

TEST_CASE("paths mean what they seem to mean on the command line") {
    const Screen screen;
    const TemporaryFolder folder;
    written(folder, "t1.toml", still_scene);
    std::filesystem::create_directory(folder / "japan");
    const auto run_there = [&](std::vector<std::string> arguments) {
        Surroundings surroundings = at_home_in(folder, screen.surroundings());
        arguments.insert(arguments.begin(), program());
        arguments.insert(arguments.end(), {"--frames", "1", "--screenshot", "~/s.png"});
        return run(arguments, surroundings);
    };
    for (const std::string scene : {"t1", "~/t1", "'t1.toml'", "t1.toml\n"}) {
        CAPTURE(scene);
        const Finished answer = run_there({scene, "--texture", "japan"});
        CAPTURE(answer.errors);
        CHECK(answer.status == 0);
        CHECK(std::filesystem::exists(folder / "s.png"));
        std::filesystem::remove(folder / "s.png");
    }
    check_refused(run_there({"--texture", "japn"}), "did you mean japan?");
}

TEST_CASE("a picture larger than can be drawn is refused before anything is built") {
    const Screen screen;
    const TemporaryFolder folder;
    const auto start = std::chrono::steady_clock::now();
    const Finished answer = drapeau_run(
        {"report", "--frames", "1", "--size", "16384x16384", "--screenshot", folder / "p.png"}, screen.surroundings());
    const Seconds passed = std::chrono::steady_clock::now() - start;
    // Where the graphics can draw it, it is drawn.
    if (answer.status == 0) return;
    check_refused(answer, "16384x16384");
    CHECK(passed < Seconds(5.0));  // a window is opened within a second or two
    CHECK(std::filesystem::is_empty(folder.path));
}

TEST_CASE("a frame is drawn however the flag is folded") {
    // Here triangles are seen edge-on in a way that an anisotropic filter of Mesa's software renderer never ends on.
    Screen screen;
    TemporaryFolder folder;
    for (const std::string frames : {"353", "354", "355", "356"}) {
        CAPTURE(frames);
        CHECK(drapeau_run({"report", "--frames", frames, "--size", "900x640", "--screenshot", folder / "p.png"},
                          screen.surroundings())
                  .status == 0);
    }
}
