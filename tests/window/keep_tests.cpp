// What is kept of the flag: films from the command line and from the window, pictures with alpha, backgrounds, shapes.
#include "app.hpp"
#include "image/image_file.hpp"
#include "pixels.hpp"
#include "scenes.hpp"

#include "catch.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <thread>

using namespace drapeau::window_tests;
namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

Words command(Words words) {
    words.insert(words.begin(), program());
    return words;
}

Finished drapeau_run(const Words& words, const Surroundings& surroundings) {
    return run(command(words), surroundings, 2.0 * patience);
}

long long files_in(const fs::path& folder) {
    return std::distance(fs::directory_iterator(folder), {});
}

/// Whether something is written: an empty file may be a trial.
bool has_begun(const fs::path& folder) {
    std::error_code gone;
    for (const auto& entry : fs::directory_iterator(folder))
        if (const auto size = entry.file_size(gone); !gone && size > 0) return true;
    return false;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

void check_refused(const Finished& answer, const std::string& part) {
    CAPTURE(answer.errors);
    CHECK(answer.status == 2);
    CHECK(answer.output.empty());
    CHECK(std::count(answer.errors.begin(), answer.errors.end(), '\n') == 1);
    CHECK(has(answer.errors, part));
}

/// What ffprobe tells of a film's picture, its frames counted.
std::map<std::string, std::string> probed(const fs::path& film) {
    const Finished answer = run({"ffprobe", "-v", "error", "-count_frames", "-select_streams", "v", "-show_entries",
                                 "stream=codec_name,width,height,pix_fmt,r_frame_rate,nb_read_frames:stream_tags",
                                 "-of", "default=noprint_wrappers=1", film.string()});
    std::map<std::string, std::string> told;
    std::istringstream lines(answer.output);
    for (std::string line; std::getline(lines, line);) {
        const auto equals = line.find('=');
        if (equals != std::string::npos) told[line.substr(0, equals)] = line.substr(equals + 1);
    }
    return told;
}

Surroundings without_display() {
    return {.variables = {{"DISPLAY", std::nullopt}, {"WAYLAND_DISPLAY", std::nullopt}}, .folder = {}};
}

struct Desk {
    Screen screen;
    TemporaryFolder folder;
    App app{screen, {written(folder, "still.toml", still_scene), "--size", "900x640"}};

    void open_dialog() {
        app.press("ctrl+r");
        app.wait_until("the dialog", [](const Look& look) { return look.has("Film file"); });
    }
    void wait_for_message(const std::string& part) {
        app.wait_until("a message with '" + part + "'",
                       [&part](const Look& look) { return has(look.text("message"), part); });
    }
};

}  // namespace

TEST_CASE("a film has the frames, the size, the rate and the pixels that were asked for") {
    const Screen screen;
    const TemporaryFolder folder;
    struct Case {
        std::string name, rate, pixels;
        Words options;
    };
    const std::vector<Case> cases{{"a.mp4", "24", "yuv420p", {}},
                                  {"a.mov", "50", "yuva444p", {"--transparent"}},
                                  {"a.webm", "25", "yuv420p", {"--transparent"}},  // its alpha is a second picture
                                  {"a.gif", "20", "bgra", {"--transparent", "--loop"}}};
    for (const Case& film : cases) {
        CAPTURE(film.name);
        const double seconds = 10.0 / std::stod(film.rate);
        Words words{"report", "--record", folder / film.name, "--fps", film.rate, "--seconds", std::to_string(seconds),
                    "--size", "160x100"};
        words.insert(words.end(), film.options.begin(), film.options.end());
        const Finished answer = drapeau_run(words, screen.surroundings());
        CAPTURE(answer.errors);
        REQUIRE(answer.status == 0);
        CHECK(answer.errors.empty());
        auto told = probed(folder / film.name);
        CHECK(told["nb_read_frames"] == "10");
        CHECK(told["width"] == "160");
        CHECK(told["height"] == "100");
        CHECK(told["r_frame_rate"] == film.rate + "/1");
        CHECK(told["pix_fmt"].starts_with(film.pixels));
        if (film.name == "a.webm") CHECK(told["TAG:alpha_mode"] == "1");
    }
    CHECK(files_in(folder.path) == 4);
}

TEST_CASE("a film's frame is the picture that the window draws at its time") {
    const Screen screen;
    const TemporaryFolder folder;
    REQUIRE(drapeau_run({"report", "--record", folder / "p-%02d.png", "--seconds", "0.2", "--size", "161x101"},
                        screen.surroundings())
                .status == 0);
    CHECK(files_in(folder.path) == 12);
    REQUIRE(drapeau_run(
                {"report", "--frames", "11", "--hide-ui", "--size", "161x101", "--screenshot", folder / "window.png"},
                screen.surroundings())
                .status == 0);
    CHECK(read_text(folder / "p-11.png") == read_text(folder / "window.png"));
    CHECK(read_text(folder / "p-10.png") != read_text(folder / "window.png"));
}

TEST_CASE("a transparent picture holds the flag in its own colours, and nothing else") {
    const Screen screen;
    const TemporaryFolder folder;
    const std::string scene = written(folder, "still.toml", still_scene);
    REQUIRE(drapeau_run({scene, "--frames", "1", "--hide-ui", "--transparent", "--size", "640x480", "--screenshot",
                         folder / "p.png"},
                        screen.surroundings())
                .status == 0);
    const drapeau::Image picture = drapeau::load_image(folder / "p.png");
    CHECK(picture.pixel(0, 0)[3] == 0);
    CHECK(picture.pixel(639, 479)[3] == 0);
    CHECK(picture.pixel(320, 240)[3] == 255);
    // Along the left edge of the flag its blue, not mixed with black: half covered, black would take half its light.
    int edges = 0;
    for (int row = 200; row < 280; ++row)
        for (int column = 1; column < 320; ++column) {
            const std::uint8_t* const edge = picture.pixel(column, row);
            const std::uint8_t* const cloth = picture.pixel(column + 3, row);
            if (edge[3] < 60 || edge[3] > 200 || cloth[3] != 255) continue;
            ++edges;
            CHECK(std::abs(int(edge[2]) - int(cloth[2])) < 12);
        }
    CHECK(edges > 20);
}

TEST_CASE("a film that is stopped or cannot be written leaves no file, and one line says why") {
    const Screen screen;
    const TemporaryFolder folder, logs;
    for (const std::string name : {"a.mp4", "p-%d.png"}) {
        CAPTURE(name);
        Process process(command({"report", "--record", folder / name, "--seconds", "1000", "--size", "160x100"}),
                        screen.surroundings(), logs.path);
        while (process.running() && !has_begun(folder.path)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        process.stop();
        CHECK(process.wait() == 128 + 15);
        CHECK(has(process.errors(), "stopped; nothing is left of "));
        CHECK(files_in(folder.path) == 0);
    }
    // A disk that takes two kilobytes, with and without a signal that says so.
    for (const std::string before : {"trap '' XFSZ; ulimit -f 4; ", "ulimit -f 4; "}) {
        const std::string words = "exec '" + program() + "' report --size 320x200 --seconds 0.5 --record '" +
                                  (folder / "a.mp4").string() + "'";
        check_refused(run({"sh", "-c", before + words}, screen.surroundings()), "a.mp4: ffmpeg could not make it");
        CHECK(files_in(folder.path) == 0);
    }
    Surroundings bare = screen.surroundings();
    bare.variables["PATH"] = folder.path.string();
    check_refused(drapeau_run({"report", "--record", folder / "a.mp4"}, bare), "--record needs ffmpeg");
    CHECK(files_in(folder.path) == 0);
}

TEST_CASE("a film that cannot be made is refused before there is any work") {
    const TemporaryFolder folder;
    const std::vector<std::pair<Words, std::string>> cases{
        {{"--size", "0x0"}, "--size = 0x0"},
        {{"--size", "99999x99999"}, "--size = 99999x99999"},
        {{"--size", "161x101"}, "even sides, such as 162x102"},
        {{"--fps", "0"}, "from 1 to 240 frames/s"},
        {{"--fps", "nan"}, "from 1 to 240 frames/s"},
        {{"--seconds", "1e9"}, "from 1 to 1000000 frames"},
        {{"--transparent"}, ".mov, .webm, .gif, frames-%04d.png are"},
        {{"--loop", "--from", "0"}, "before its first frame"},
        {{"--frames", "5"}, "--record has --seconds, not --frames"},
        {{"--obj", "a.obj"}, "one at a time"}};
    for (const auto& [options, part] : cases) {
        CAPTURE(options);
        Words words{"report", "--record", folder / "a.mp4"};
        words.insert(words.end(), options.begin(), options.end());
        check_refused(drapeau_run(words, without_display()), part);
    }
    check_refused(drapeau_run({"report", "--record", folder / "none/a.mp4"}, without_display()), "none/a.mp4");
    check_refused(drapeau_run({"report", "--seconds", "3"}, without_display()), "for --record or --obj");
    CHECK(files_in(folder.path) == 0);
}

TEST_CASE("shapes are written without a display, one or one a frame") {
    const TemporaryFolder folder;
    CHECK(drapeau_run({"report", "--obj", folder / "a.obj", "--from", "0.5"}, without_display()).status == 0);
    CHECK(drapeau_run({"report", "--obj", folder / "s-%d.obj", "--fps", "30", "--seconds", "0.1"}, without_display())
              .status == 0);
    CHECK(files_in(folder.path) == 4);
    CHECK(has(read_text(folder / "a.obj"), "after 0.5 s"));
    CHECK(has(read_text(folder / "s-2.obj"), "\nvn "));
    check_refused(drapeau_run({"report", "--obj", folder / "a.stl"}, without_display()), ".obj is allowed");
    check_refused(drapeau_run({"report", "--obj", folder / "a.obj", "--seconds", "2"}, without_display()),
                  "one shape has no length");
}

TEST_CASE_METHOD(Desk,
                 "the window makes a film, asks before it replaces a file, and leaves none of one that is stopped") {
    const std::string file = folder / "film.mp4";
    app.click("Page: Time");
    app.show("Film");
    app.click("Film");
    app.wait_until("the dialog, with a name that is free", [](const Look& look) {
        return look.has("Film file") && look.controls.at("Film file").value == "drapeau-001.mp4";
    });
    app.press("Escape");
    app.wait_until("the dialog is closed", [](const Look& look) { return !look.has("Film file"); });

    open_dialog();
    app.click("Film size");
    app.click("Film size: the window's");
    app.click("Frame rate");
    app.click("Frame rate: 30 frames/s");
    app.type_number("Length", "0.2");
    app.type("Film file", file);  // Enter begins
    wait_for_message("film.mp4");
    auto told = probed(file);
    CHECK(told["nb_read_frames"] == "6");
    CHECK(told["r_frame_rate"] == "30/1");
    CHECK(told["width"] == "900");
    CHECK(told["height"] == "640");

    const std::string first = read_text(file);
    open_dialog();
    app.type_number("Length", "100");
    app.type("Film file", file);
    app.wait_until("a question", [](const Look& look) { return has(look.text("question"), "film.mp4 exists"); });
    app.click("Cancel");
    app.wait_until("no question", [](const Look& look) { return look.text("question").empty(); });
    CHECK(read_text(file) == first);
    app.click("Record");
    app.wait_until("a question", [](const Look& look) { return !look.text("question").empty(); });
    app.click("Overwrite");
    const Look begun = app.wait_until("frames", [](const Look& look) {
        return !look.text("film").empty() && look.number("film") >= 3 && look.has("Stop film");
    });
    CHECK(has(begun.controls.at("Reading: Film").value, "film.mp4: "));
    // The flag flies on meanwhile.
    app.wait_until("time to pass", [&](const Look& look) { return look.number("time") > begun.number("time"); });
    // What would end it asks first.
    const auto asked = [](const Look& look) { return has(look.text("question"), "A film is being made"); };
    const auto cancelled = [&] {
        app.wait_until("a question", asked);
        app.settle();  // a box lies where it stays only once it has been drawn
        app.click("Cancel");
        const auto none = [](const Look& look) { return look.text("question").empty(); };
        return !app.wait_until("no question", none).text("film").empty();
    };
    app.press("ctrl+q");
    CHECK(cancelled());
    app.click("Page: Flag");
    app.show("Image file");
    app.type("Image file", "japan");
    CHECK(cancelled());
    app.type("Image file", "japan");
    app.wait_until("a question", asked);
    app.settle();
    app.click("Open another");
    wait_for_message("nothing is left of it");
    app.wait_until("the image", [](const Look& look) { return has(look.text("texture"), "japan"); });
    CHECK(read_text(file) == first);
    CHECK(files_in(folder.path) == 2);
    app.check_healthy();
}

TEST_CASE_METHOD(Desk, "the background is sky, studio or nothing, over which the window draws a checkerboard") {
    const Point corner = app.look().box("view").at(0.97, 0.03);
    const auto choose = [&](const std::string& background) {
        app.click("Page: View");
        app.click("Background");
        app.click("Background: " + background);
        app.wait_until(background, [&](const Look& look) {
            return look.has("Background") && look.controls.at("Background").value == background;
        });
        return app.picture();
    };
    CHECK(colour_around(app.picture(), corner).vividness() > 40.0);
    CHECK(colour_around(choose("studio"), corner).vividness() < 25.0);
    const drapeau::Image nothing = choose("transparent");
    // Squares of two greys, of 12 pixels.
    std::vector<int> greys;
    for (double x = corner.x - 48.0; x < corner.x; x += 1.0)
        greys.push_back(int(colour_at(nothing, {x, corner.y}).red));
    const auto [low, high] = std::minmax_element(greys.begin(), greys.end());
    CHECK(*high - *low > 10);
    CHECK(std::count(greys.begin(), greys.end(), *low) == 24);

    app.click("Page: Time");
    app.show("Save shape");
    app.click("Save shape");
    wait_for_message("drapeau-001.obj");
    app.check_healthy();
}
