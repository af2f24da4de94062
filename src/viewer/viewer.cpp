#include "viewer.hpp"

#include "image/image_file.hpp"
#include "numbered_name.hpp"
#include "scene_cards.hpp"
#include "stage.hpp"

#include "io/error.hpp"
#include "io/given_path.hpp"
#include "io/output_file.hpp"
#include "io/terminal.hpp"
#include "scene/file.hpp"
#include "scene/material.hpp"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cstdlib>
#include <thread>
#include <utility>

namespace drapeau {

namespace {

constexpr int samples = 4;                      // a pixel
constexpr int settling_frames = 4;              // pictures ImGui needs to lay its boxes out
constexpr double longest_frame_seconds = 0.25;  // a pause of the whole program is not caught up

bool debug_wanted() {
    const char* debug = std::getenv("DRAPEAU_GL_DEBUG");
    return std::getenv("DRAPEAU_UI_MAP") || (debug && *debug && *debug != '0');
}

bool into_files(const Options& options) {
    return !options.record.empty() || (options.frames > 0 && !(options.screenshot.empty() && options.film.empty()));
}

float pixels_per_unit(const Window& window) {
    return float(window.framebuffer_size().x) / float(std::max(1, window.size().x));
}

/// The scene with what the command line says instead, and whether the files asked for can be written.
LoadedScene loaded_for(const Options& options) {
    std::vector<Assignment> assignments;
    NamedFile texture{"--texture", options.texture};
    for (const std::string& text : options.set) {
        const Assignment assignment = assignment_in(text);
        if (assignment.key != "flag.texture" || assignment.value.empty()) {
            assignments.push_back(assignment);
        } else if (options.texture.empty()) {  // a path that is typed is no path of the scene's folder
            texture = {assignment.option, meant_path(assignment.value)};
        }
    }
    if (!texture.name.empty()) texture.name = find_picture(texture.name).string();
    LoadedScene loaded = load_scene(options.scene, assignments);
    std::vector<NamedFile> inputs{{"the scene", loaded.file.string()}}, outputs;
    if (!loaded.texture_file.empty()) inputs.push_back({"the scene's texture", loaded.texture_file.string()});
    if (!texture.name.empty()) inputs.push_back(texture);
    if (!options.screenshot.empty()) outputs.push_back({"--screenshot", options.screenshot});
    if (!options.record.empty()) {
        const bool sequence = means_sequence(options.record);
        outputs.push_back({"--record", sequence ? numbered(options.record, 0).string() : options.record});
    }
    if (!options.film.empty()) outputs.push_back({"--film", options.film});
    check_outputs(inputs, outputs);
    if (!texture.name.empty()) {
        loaded.texture_file = texture.name;
        loaded.image = load_image(loaded.texture_file);
        loaded.fault.clear();
        loaded.scene.flag.texture = texture_name(loaded.texture_file);
    }
    preset_view(options, loaded.scene.view);
    return loaded;
}

/// What the window begins with: a hanging flag is flat until it has settled, which it does in sight.
Simulation first_simulation(Scene scene, bool repeatable) {
    if (!repeatable && scene.flag.start == Start::hanging) scene.flag.start = Start::flat;
    return Simulation(scene);
}

}  // namespace

void preset_view(const Options& options, ViewSettings& view) {
    if (options.springs) view.springs = true;
    if (options.forces) view.forces = true;
    if (options.masses) view.masses = true;
    if (options.no_texture) view.texture = false;
    if (options.transparent) view.background = Background::transparent;
}

Viewer::Viewer(const Options& options) : Viewer(options, loaded_for(options)) {}

Viewer::Viewer(const Options& options, LoadedScene loaded)
    : options_(options),
      window_({.debug = debug_wanted(), .vsync = options.frames == 0}),
      gl_errors_(debug_wanted()),
      gui_(window_.handle(), options.frames > 0 ? 1.0f : window_.content_scale(),
           options.frames > 0 ? 1.0f : pixels_per_unit(window_)),
      target_(options.width, options.height, samples),
      film_(options.film.empty() ? nullptr
                                 : std::make_unique<Film>(FilmSettings{.file = options.film,
                                                                       .width = options.width,
                                                                       .height = options.height,
                                                                       .transparent = options.transparent,
                                                                       .asked_by = "--film"})),
      simulation_(first_simulation(loaded.scene, repeatable()), simulation_threads(std::thread::hardware_concurrency()),
                  repeatable() ? ErrorWatch::Mode::awaited : ErrorWatch::Mode::aside) {
    recall();
    if (!into_files(options)) window_.show(options_.width, options_.height, !options.size_given && !repeatable());
    app_.scene_names = shipped_scenes();
    app_.texture_files = shipped_pictures();
    app_.scene_cards = scene_cards();
    app_.panel_shown = !options.hide_ui && app_.remembered.panel;
    app_.status.clock = !repeatable();
    if (options.azimuth) camera_.azimuth = *options.azimuth;
    if (options.elevation) camera_.elevation = *options.elevation;
    first_file_ = loaded.file;
    adopt(std::move(loaded));
    sent_ = app_.scene;
    if (sent_.flag.start == Start::hanging && !repeatable()) simulation_.restart(sent_, ++revision_);
    last_time_ = glfwGetTime();
}

bool Viewer::running() const {
    return window_.open() && !app_.quits && (!repeatable() || frame_ < options_.frames);
}

int Viewer::exit_status() const {
    if (!repeatable()) return 0;
    return app_.status.divergence ? 3 : app_.status.failure.empty() ? 0 : 1;
}

glm::vec2 Viewer::size() const {
    if (repeatable()) return {float(options_.width), float(options_.height)};
    return glm::vec2(window_.size());
}

// A hidden window needs no picture of frames that nobody will see.
bool Viewer::picture_wanted() const {
    const bool last = frame_ + settling_frames >= options_.frames;
    if (hidden_) return false;
    return !repeatable() || last || film_ || options_.screenshot.empty() || map_.wanted();
}

void Viewer::input() {
    std::vector<InputEvent> events = wait_for_events();
    own_work_.begin();
    // Time at rest is none that the run could be behind.
    if (rest_seconds_ > 0.0 && !runs()) last_time_ = glfwGetTime();
    had_events_ = !events.empty() || file_changed_;
    if (!window_.open() && app_.film.under_way && !app_.quits) {
        window_.stay_open();
        ask_to_quit(app_);
    }
    hidden_ = !repeatable() && window_.hidden();
    if (!repeatable()) target_.resize(window_.framebuffer_size().x, window_.framebuffer_size().y);
    const float pixels = float(target_.width()) / std::max(1.0f, size().x);
    const bool field_comes = keyboard_is_awaited();
    panel_memory_.widgets.bars.pressed_twice = double_press_.in(events);
    gui_.begin({.size = size(), .pixels_per_unit = pixels, .seconds = repeatable() ? 1.0f / 60.0f : 0.0f}, events,
               field_comes);
    if (gui_.dropped_keys() && (field_comes || gui_.is_text_edited() || panel_memory_.widgets.bars.pressed_twice))
        say(app_, Message::Cause::typed,
            "What was typed last was lost: its field was not there yet as the mouse was pressed.", false);
    lay_out(app_, size().x, size().y, repeatable() ? 1.0f : window_.content_scale());
    const auto is_escape = [](const InputEvent& e) { return e.kind == InputEvent::Kind::key && e.key == Key::escape; };
    const auto escape = std::find_if(events.begin(), events.end(), is_escape);
    if (escape != events.end() && gui_.close_list()) events.erase(escape);
    const ImGuiIO& io = ImGui::GetIO();
    controls_.apply(events, {.mouse = io.WantCaptureMouse, .keyboard = io.WantTextInput || field_comes}, framing_, app_,
                    camera_);
    if (app_.commands.reset_camera) camera_.reset(), app_.orbits = false;
    follow_hand();
}

// What is typed before the field that was opened for it has the keyboard is kept for it.
bool Viewer::keyboard_is_awaited() const {
    return panel_memory_.widgets.bars.awaits_keyboard() || (app_.palette.open && !gui_.is_text_edited());
}

void Viewer::exchange() {
    const double now = glfwGetTime();
    const double passed = std::min(now - last_time_, longest_frame_seconds);
    last_time_ = now;
    wall_ += passed;
    if (app_.orbits) camera_.orbit(passed);

    note_changes();
    undo_wanted();
    reload_wanted();
    clipboard_wanted();
    load_wanted();
    save_wanted();
    use_safe_step();
    measure_wanted();
    film_wanted();
    note_changes();
    travel(passed);
    send_settings();
    if (app_.commands.step && app_.paused) simulation_.ask_step();
    const bool screenshot = app_.commands.screenshot;
    remember();
    app_.commands = {};
    app_.commands.screenshot = screenshot;
    if (runs()) ask_for_time(passed);
    if (repeatable()) simulation_.wait();
    receive(passed);
    app_.playback.shown ? app_.history.look_at(entry_now()) : app_.history.amend(entry_now());
}

void Viewer::use_safe_step() {
    const auto& divergence = app_.status.divergence;
    if (!app_.commands.use_safe_step || !divergence || divergence->safe_dt <= 0.0) return;
    app_.scene.time.dt = divergence->safe_dt;
    app_.scene.time.tolerance.reset();
}

void Viewer::measure_wanted() {
    Findings& findings = app_.findings;
    if (app_.commands.stop_measuring && findings.under_way) {
        measuring_.stop();
        findings.trouble = "stopped before it was done";
        findings.troubled = *findings.under_way;
    }
    if (app_.commands.measure) {
        findings.trouble.clear();
        measuring_.measure(*app_.commands.measure, app_.scene);
    }
    findings.under_way = measuring_.under_way();
    findings.share = measuring_.share();
    if (auto measurement = measuring_.take()) take(std::move(*measurement), app_.scene, findings);
}

void Viewer::send_settings() {
    if (opening_) return;
    keep_proportions();
    fit_cells(app_.scene, sent_.flag);
    const bool changed = physics_of(app_.scene) != physics_of(sent_);
    if (app_.commands.restart)
        simulation_.restart(app_.scene, ++revision_);
    else if (changed && looked_at_)
        go_on_from_shown();
    else if (changed)
        simulation_.apply(app_.scene, ++revision_);
    if (app_.commands.restart || changed) sent_ = app_.scene;
    simulation_.follow_reference(app_.scene.view.reference);
    simulation_.give_velocities(wants_velocities());
    if (app_.commands.restart_reference) simulation_.restart_reference();
}

bool Viewer::wants_velocities() const {
    const auto& read = app_.readout.chosen();
    return app_.scene.view.velocities || (read && !read->is_spring());
}

void Viewer::keep_proportions() {
    const double proportions = std::clamp(app_.status.flag_proportions, 0.2, 5.0);
    if (app_.scene.view.texture_proportions && app_.status.flag_proportions > 0.0)
        app_.scene.flag.width = app_.scene.flag.height * proportions;
}

// A refused scene leaves the old one in place, on the panel too.
void Viewer::hear_of_run() {
    const auto answer = run_messages_.hear(newest_, revision_, app_.message);
    if (answer == RunMessages::Answer::refused) {
        opening_.reset();
        Scene kept = newest_.scene;
        kept.view = app_.scene.view;
        kept.name = app_.scene.name;
        kept.flag.texture = app_.scene.flag.texture;
        app_.scene = sent_ = kept;
    } else if (answer == RunMessages::Answer::taken && opening_) {
        adopt(std::move(*opening_));
        measuring_.stop();
        app_.findings = {};
        sent_ = app_.scene;
        camera_.reset();
        opening_.reset();
    }
    if (!newest_.failure.empty()) opening_.reset();
}

void Viewer::receive_reference() {
    auto& gap = app_.status.reference;
    if (!app_.scene.view.reference) reference_ = {};
    if (!app_.scene.view.reference || app_.playback.shown) return gap.reset();  // it follows the run alone
    const bool comes_back = !gap && reference_.dt > 0.0;
    if (simulation_.take_reference(reference_) || comes_back) {
        renderer_.upload_reference(reference_.snapshot);
        gap = ReferenceGap{.since = reference_.since,
                           .time = reference_.snapshot.time,
                           .rms = reference_.rms,
                           .greatest = reference_.greatest,
                           .dt = reference_.dt,
                           .trouble = {}};
    }
    if (const std::string trouble = simulation_.reference_trouble(); !trouble.empty())
        gap = ReferenceGap{.trouble = trouble};
}

/// The moment to the picture and the panels.
void Viewer::show_moment() {
    Status& status = app_.status;
    renderer_.upload(moment_.snapshot);
    force_scale_.follow(moment_.readings.rms_spring_force);
    if (app_.scene.view.stretch) stretch_scale_.follow(moment_.snapshot.position, moment_.kinds);
    if (app_.scene.view.velocities) speed_scale_.follow(moment_.snapshot.velocity);
    if (repeatable() && moment_.stands() && !status.stands()) complain("drapeau", app_.message.text);
    status.readings = moment_.readings;
    status.divergence = moment_.divergence;
    status.failure = moment_.failure;
    status.shows_kept = looked_at_ != nullptr;
    status.time = moment_.snapshot.time;
    status.steps = moment_.snapshot.steps;
    status.columns = moment_.snapshot.position.columns();
    status.rows = moment_.snapshot.position.rows();
    status.method = moment_.scene.time.method;
    status.dt = moment_.dt;
    status.steps_per_batch = moment_.steps_per_batch;
    status.stability_limit = moment_.stability_limit;
    status.live_limit = moment_.live_limit;
    status.limit_remark = moment_.limit_remark;
    status.method_remark = moment_.method_remark;
    status.step_reason = moment_.step_reason;
    status.error = moment_.error;
    status.lowered_because = moment_.lowered_because;
    status.precision_remark = moment_.precision_remark;
    status.start_remark = moment_.start_remark;
    status.limit = moment_.scene.limits.get<StretchLimit>();
    status.pull_force = moment_.pull_force;
    status.step_seconds = moment_.step_seconds;
    status.force_scale = force_scale_.newtons();
    status.stretch_scale = stretch_scale_.share();
    status.speed_scale = speed_scale_.end();
}

void Viewer::receive(double passed) {
    Status& status = app_.status;
    receive_moment();
    app_.readout.observe(moment_.snapshot, moment_.scene);
    if (app_.scene.view.wind && app_.scene.wind()) app_.streaks.drift(*app_.scene.wind(), framing_, status.time);
    receive_reference();
    status.settling = simulation_.settling();
    if (runs())
        pacer_.observe(wall_, status.time);
    else
        pacer_.forget();
    status.real_time_factor = pacer_.real_time_factor();
    if (rest_seconds_ > 0.0) return;
    status.frame_seconds += (passed - status.frame_seconds) * (status.frame_seconds > 0.0 ? 0.05 : 1.0);
}

}  // namespace drapeau
