// AppState: what the window is about, as plain data. Panels and keys edit it and leave commands; main carries them out.
#pragma once

#include "camera.hpp"
#include "film_desk.hpp"
#include "findings.hpp"
#include "hand.hpp"
#include "history.hpp"
#include "message.hpp"
#include "palette.hpp"
#include "playback.hpp"
#include "readout.hpp"
#include "run/simulation.hpp"
#include "scene/material.hpp"
#include "thumbnail.hpp"
#include "user_settings.hpp"
#include "wind_streaks.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace drapeau {

/// What panels and keys ask main to do after this frame.
struct Commands {
    bool step = false;
    Travel travel;
    bool restart = false;
    bool screenshot = false;
    bool reset_camera = false;
    bool use_safe_step = false;
    bool restart_reference = false;
    bool undo = false, redo = false;
    bool copy_scene = false, paste_scene = false;  // as text, by the clipboard
    bool forget_settings = false;
    std::optional<Measuring::Subject> measure;
    bool stop_measuring = false;
    bool start_film = false, stop_film = false;
    bool save_shape = false;                            // as OBJ
    std::optional<std::filesystem::path> replace_film;  // make the film over this file
    std::optional<std::string> load_scene;              // a path or a shipped name
    std::optional<std::string> load_texture;            // a path; empty: no image
    std::optional<std::string> save_scene;              // a path
    std::optional<std::filesystem::path> overwrite;     // save the scene over this file
};

struct AppState;

/// A question that waits for an answer before something is lost: a file's content, a film under way, all that is
/// remembered.
struct Question {
    std::string text;
    std::string answer, tip;              // the button that agrees
    std::function<void(AppState&)> then;  // what is done then
};

/// How far the run has gone from its reference.
struct ReferenceGap {
    double since = 0.0, time = 0.0;    // s, when both were the same, and when they were compared
    double rms = 0.0, greatest = 0.0;  // m
    double dt = 0.0;                   // s, the reference's step
    std::string trouble;               // why there is none; empty while there is one

    /// Whether the reference is noticeably behind a run that is at `now` (s).
    bool lags(double now) const { return now - time > 0.25; }
};

/// What the panels show of the run.
struct Status {
    Readings readings;
    std::optional<Divergence> divergence;
    std::string failure;  // why the run stands otherwise; empty while it does not
    double time = 0.0;    // s, simulated
    long long steps = 0;
    int columns = 0, rows = 0;
    Method method{};  // of the run, which follows the scene's a little later
    double dt = 0.0;  // s
    long long steps_per_batch = 0;
    StableStep stability_limit;
    std::optional<StableStep> live_limit;   // here and now
    std::string limit_remark;               // that the step is past it; empty where it is not
    std::string method_remark;              // what the method does by nature at this step; empty where nothing
    std::string step_reason;                // what the step in use was chosen by
    std::optional<ErrorEstimate> error;     // the newest, of the step in use
    std::string lowered_because;            // why an automatic step is smaller than usual; empty where it is not
    std::string precision_remark;           // what float cannot honour; empty where all is well
    std::string start_remark;               // what a start is not that it may seem; empty where all is well
    std::optional<StretchLimit> limit;      // of the scene that runs
    std::optional<ReferenceGap> reference;  // while one is shown and there is something to say of it
    double force_scale = 1.0;               // N, that the end of the force colours follows
    double stretch_scale = 1.0;             // share, the same of stretch
    bool shows_kept = false;                // a moment that is looked back at
    double speed_scale = 1.0;               // m/s, of the longest line of velocities
    double pull_force = 0.0;                // N, of the hand that holds the cloth
    bool clock = true;                      // false: wall-clock readings are not shown, so that pictures repeat
    double real_time_factor = 0.0;
    double step_seconds = 0.0;      // wall-clock
    double frame_seconds = 0.0;     // wall-clock
    double own_seconds = 0.0;       // processor time of the window itself in a frame; see OwnWork
    double flag_proportions = 0.0;  // of the texture, width / height; 0 without one
    bool image_has_holes = false;   // parts that may be cut out

    std::string loading;    // the name of a file that is being read; empty: none is
    bool settling = false;  // a hanging flag is coming to rest before it starts

    bool stands() const { return divergence || !failure.empty(); }
    /// Why the run stands, in full.
    const std::string& standstill() const { return divergence ? divergence->message : failure; }
    /// Wall-clock time over simulated time, if steps followed each other without rest.
    double times_slower() const { return step_seconds * static_cast<double>(steps_per_batch) / batch_seconds; }
};

struct AppState {
    Scene scene;   // what the controls edit
    Scene origin;  // as it was loaded: what the controls go back to
    std::filesystem::path scene_file;
    std::filesystem::path texture_file;              // of the image on the flag; empty: none
    std::vector<std::filesystem::path> saved_files;  // scenes written since the program began
    std::vector<std::string> scene_names;
    std::vector<std::filesystem::path> texture_files;
    std::vector<SceneCard> scene_cards;
    std::map<std::filesystem::path, Thumbnail> thumbnails;  // by their image

    std::optional<double> diagonals;  // N/m, or share; kept while diagonal springs are off

    bool paused = false;
    Playback playback;
    bool panel_shown = true;    // where there is room for it beside the flag
    bool panel_opened = false;  // where there is none
    bool narrow = false;        // the window has no room for the panel beside the flag
    bool help_shown = false;
    bool scenes_shown = false;
    Message message;
    std::optional<Question> question;
    Status status;
    Findings findings;
    FilmDesk film;
    Hand hand;            // on the cloth
    Readout readout;      // of what was clicked
    bool orbits = false;  // the camera goes slowly around
    Lens lens;            // of this frame
    WindStreaks streaks;  // while the wind is shown
    Commands commands;
    History history;
    UserSettings remembered;  // between runs
    Palette palette;
    std::optional<Mark> mark;  // the control that was looked for
    bool quits = false;

    // What the panels took of the window in this frame, in window units.
    Area panel_area;
    Area view_area;
    Area message_area;          // the box, or the line that stands for a closed one
    std::vector<Area> claimed;  // no drag that begins here turns the flag

    bool panel_open() const { return narrow ? panel_opened : panel_shown; }
    bool opener_shown() const { return narrow && panel_shown && !panel_opened; }  // a button in a corner
    void toggle_panel() {
        bool& open = narrow ? panel_opened : panel_shown;
        open = !open;
    }
};

inline void say(AppState& app, Message::Cause cause, const std::string& text, bool trouble) {
    app.message = {.text = text, .trouble = trouble, .seconds_left = trouble ? 0.0 : 5.0, .cause = cause};
}

/// Opens the message of a run that stands.
inline void say_why_it_stands(AppState& app) {
    say(app, Message::Cause::standstill, app.status.standstill(), true);
}

/// Closes what was opened last: the palette, a question, unanswered, before the list of keys, the scenes, the readout
/// and the message. A hand that holds the cloth lets go first.
inline void close_one(AppState& app) {
    if (app.palette.open)
        app.palette.open = false;
    else if (app.hand.is_busy())
        app.hand.let_go();
    else if (app.question)
        app.question.reset();
    else if (app.film.open)
        app.film.open = false;
    else if (app.help_shown)
        app.help_shown = false;
    else if (app.scenes_shown)
        app.scenes_shown = false;
    else if (app.readout.chosen())
        app.readout.close();
    else
        app.message.text.clear();
}

/// Does what was asked about.
inline void agree(AppState& app) {
    if (!app.question) return;
    const auto then = std::exchange(app.question, std::nullopt)->then;
    then(app);
}

inline Question question_before_overwriting(const std::string& text, std::function<void(AppState&)> then) {
    return {text, "Overwrite", "What the file holds is replaced.", std::move(then)};
}

inline void ask_to_forget(AppState& app) {
    app.question = Question{.text =
                                "Forget the window's size, its panel and page, and the recent files? The scene "
                                "stays as it is.",
                            .answer = "Forget",
                            .tip = "The window begins with defaults from the next start on.",
                            .then = [](AppState& state) { state.commands.forget_settings = true; }};
}

/// Asks before what would end a film under way; without one it is done at once.
inline void unless_filming(AppState& app, const std::string& what, std::function<void(AppState&)> then) {
    if (!app.film.under_way) return then(app);
    app.question = Question{.text = "A film is being made: " + app.film.name + ". " + what + " and lose it?",
                            .answer = what,
                            .tip = "The film ends, and nothing is left of it.",
                            .then = std::move(then)};
}

inline void ask_to_quit(AppState& app) {
    unless_filming(app, "Quit", [](AppState& state) { state.quits = true; });
}

/// Another name of the fabric brings its values, but for the drag, which is the air's, and a bending that is not the
/// fabric's own.
inline void bring_fabric(AppState& app, FabricName before) {
    Fabric& fabric = *app.scene.fabric;
    if (fabric.name == before) return;
    const auto drag = fabric.drag_per_area;
    fabric = fabric_of(fabric.name);
    fabric.drag_per_area = drag;
    auto& bending = app.scene.terms.get<Bending>();
    if (bending && bending->stiffness == bending_of(before)) bending->stiffness = bending_of(fabric.name);
    app.diagonals.reset();
}

/// Diagonal springs off, or on as stiff as they last were.
inline void toggle_diagonals(AppState& app) {
    auto& diagonals = app.scene.diagonals();
    if (diagonals) app.diagonals = *diagonals;
    diagonals = diagonals ? std::nullopt : std::optional(app.diagonals.value_or(usual_diagonals(app.scene)));
}

}  // namespace drapeau
