#include "options.hpp"

#include "film.hpp"
#include "film_options.hpp"
#include "io/command_line.hpp"
#include "io/error.hpp"
#include "io/given_path.hpp"
#include "io/terminal.hpp"
#include "io/text.hpp"
#include "scene/file.hpp"

#include <cmath>
#include <cstdio>

namespace drapeau {

namespace {

constexpr int max_frames = 1000000;
constexpr int min_side = 16, max_side = 16384;  // pixels

constexpr const char* notes =
    "In the window, F1 lists the keys.\n"
    "Example: drapeau storm --record storm.mp4 --seconds 8\n"
    "Exit status: 0 good, 1 a failure, 2 bad input, 3 a run to files that diverged, 130 stopped by Ctrl+C.";

void size_from(const std::string& text, Options& options) {
    const auto cross = text.find('x');
    std::string width = text.substr(0, cross), height = cross == std::string::npos ? "" : text.substr(cross + 1);
    const CLI::Validator side = whole_number(min_side, max_side);
    if (!side(width).empty() || !side(height).empty())
        throw InputError("--size = " + one_line(text, 60) + ": WIDTHxHEIGHT, each from " + std::to_string(min_side) +
                         " to " + std::to_string(max_side) + " pixels");
    options.width = std::stoi(width);
    options.height = std::stoi(height);
    options.size_given = true;
}

/// A name without an ending says nothing of its format: it is taken as it is.
void check_picture_name(const std::string& file) {
    if (const std::string ending = ending_of(file); !ending.empty() && ending != ".png")
        throw InputError("--screenshot = " + one_line(file, 1000) + ": .png is allowed, the format of the picture");
}

void check_film_options(const Options& options) {
    const bool recorded = !options.record.empty(), shaped = !options.obj.empty();
    if (recorded && shaped) throw InputError("--record and --obj are made one at a time");
    if (options.frames > 0 && (recorded || shaped))
        throw InputError(std::string(recorded ? "--record" : "--obj") + " has --seconds, not --frames");
    if (recorded) film_plan(options);
    if (shaped) shape_plan(options);
    if (recorded || shaped) return;
    if (options.seconds || options.fps || options.from || options.loop)
        throw InputError("--seconds, --fps, --from and --loop are for --record or --obj");
    if (options.transparent && !options.film.empty() && !film_format(options.film).alpha)
        throw InputError("--film = " + one_line(options.film, 1000) + ": not transparent; " + transparent_formats() +
                         " are");
}

void check(const Options& options) {
    if (options.frames == 0 && !options.screenshot.empty())
        throw InputError("--screenshot needs --frames N: the picture is that of the last frame");
    if (options.frames == 0 && !options.film.empty()) throw InputError("--film needs --frames N: how long it is");
    if (options.azimuth && !std::isfinite(*options.azimuth)) throw InputError("--azimuth: a number of degrees");
    if (options.elevation && !(std::abs(*options.elevation) <= 85.0f))
        throw InputError("--elevation: degrees from -85 to 85");
    if (!options.screenshot.empty()) check_picture_name(options.screenshot);
    if (!options.film.empty()) check_film_name(options.film, "--film");
    check_film_options(options);
}

}  // namespace

std::optional<int> read_options(int count, char** words, Options& options) {
    CLI::App app("drapeau: a flag of masses and springs that flies, and says how far it can be trusted", "drapeau");
    std::string size;
    bool scene_list = false;
    take_as_path(app.add_option("SCENE", options.scene, "a scene file, or the name of a shipped scene (report)"));
    app.add_option("--frames", options.frames,
                   "draw N frames of 1/60 s simulated time each, then exit; repeatable exactly")
        ->type_name("N")
        ->check(whole_number(1, max_frames));
    take_as_path(app.add_option("--screenshot", options.screenshot, "with --frames: the last frame as PNG")
                     ->type_name("FILE.png"));
    take_as_path(app.add_option("--film", options.film,
                                "with --frames: all of them, as the ending says: mp4, mov, mkv, webm or gif (needs "
                                "ffmpeg)")
                     ->type_name("FILE"));
    take_as_path(app.add_option("--record", options.record,
                                "make a film and leave: mp4, mov, mkv, webm, gif (needs ffmpeg) or pictures, "
                                "frames-%04d.png; no panel is in it")
                     ->type_name("FILE"));
    app.add_option("--seconds", options.seconds, "how long the film is (10)")->type_name("S");
    app.add_option("--fps", options.fps, "its frames a second, from 1 to 240 (60; gif 25)")->type_name("N");
    app.add_option("--from", options.from, "simulated seconds before its first frame (0; with --loop 3)")
        ->type_name("S");
    app.add_flag("--loop", options.loop, "its end passes into its beginning, over a second");
    app.add_flag("--transparent", options.transparent,
                 "no sky and no ground, for --screenshot and films: webm, mov, gif or frames-%04d.png");
    take_as_path(app.add_option("--obj", options.obj,
                                "write the shape after --from seconds as OBJ and leave; frames-%04d.obj: one a frame")
                     ->type_name("FILE"));
    app.add_option("--size", size,
                   "of the window or picture, in pixels (1280x800, a window grows with the desktop's text; --record "
                   "1920x1080)")
        ->type_name("WxH");
    take_as_path(app.add_option("--texture", options.texture, "an image for the flag, or the name of a shipped one")
                     ->type_name("FILE"));
    add_assignments(app, options.set);
    app.add_flag("--hide-ui", options.hide_ui, "no panel");
    app.add_flag("--springs", options.springs, "show the springs");
    app.add_flag("--forces", options.forces, "colour the springs by their force");
    app.add_flag("--masses", options.masses, "show the masses");
    app.add_flag("--no-texture", options.no_texture, "plain cloth");
    app.add_option("--azimuth", options.azimuth, "seen from this many degrees right of its front")->type_name("DEG");
    app.add_option("--elevation", options.elevation, "seen from this many degrees above")->type_name("DEG");
    app.add_flag("--scene-list", scene_list, "list the shipped scenes");
    app.set_version_flag("--version", "drapeau " DRAPEAU_VERSION);
    app.footer(notes);
    try {
        parse(app, count, words);
        if (!size.empty()) size_from(size, options);
        check(options);
        if (!scene_list) return std::nullopt;
        for (const std::string& name : shipped_scenes()) std::puts(name.c_str());
        return finish_output("drapeau", 0);
    } catch (const CLI::Success& done) {
        return finish_output("drapeau", app.exit(done));
    } catch (const CLI::ParseError& wrong) {
        complain("drapeau", explained(app, wrong) + " (drapeau --help lists what there is)");
        return 2;
    } catch (const InputError& wrong) {
        complain("drapeau", wrong.what());
        return 2;
    }
}

}  // namespace drapeau
