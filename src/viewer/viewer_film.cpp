// What the viewer does with films: those the window asks for, frame by frame beside its own pictures, and that of
// --record, which is all the program does then.
#include "film_options.hpp"
#include "interruption.hpp"
#include "numbered_name.hpp"
#include "obj_file.hpp"
#include "progress_line.hpp"
#include "stage.hpp"
#include "viewer.hpp"

#include "io/error.hpp"
#include "io/terminal.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <utility>

namespace drapeau {

namespace {

constexpr int samples = 4;           // a pixel
constexpr float line_height = 1080;  // pixels of a picture whose lines are one pixel a unit wide

/// The first file that the plan writes.
std::filesystem::path first_file(const FilmPlan& plan) {
    return means_sequence(plan.file) ? numbered(plan.file, 0) : plan.file;
}

}  // namespace

glm::vec3 middle_of(const FieldBuffer<float>& position) {
    glm::dvec3 sum(0.0);
    for (int row = 0; row < position.rows(); ++row)
        for (int column = 0; column < position.columns(); ++column) sum += position.at(column, row);
    return glm::vec3(sum / std::max(1.0, double(position.columns()) * position.rows()));
}

Picture Filming::picture(const FilmFrame& frame) {
    const Area whole{0.0f, 0.0f, float(target.width()), float(target.height())};
    Picture shown = view;
    shown.stage = stage_of(scene);
    Framing framing = framing_of(scene.flag, shown.stage);
    if (scene.flag.attach == Attach::none && !scene.limits.get<Ground>())
        framing.centre = middle_of(frame.snapshot.position);
    shown.view = camera.view_matrix(framing, whole);
    shown.projection = camera.projection(framing, whole, {whole.x1, whole.y1});
    shown.eye = camera.eye(framing, whole);
    shown.reference = 0.0f;
    shown.force_scale = float(settings.force_range.value_or(frame.force_scale));
    if (settings.stretch) stretch_scale.follow(frame.snapshot.position, shown.kinds);
    shown.stretch_scale = float(settings.stretch_range.value_or(stretch_scale.share()));
    shown.streaks.clear();  // they drift with the window's moments
    if (settings.velocities) {
        speed_scale.follow(frame.snapshot.velocity);
        shown.velocities =
            velocities_of(frame.snapshot, scene.flag, settings.velocity_range.value_or(speed_scale.end()));
    }
    shown.hidden = glm::ivec4(0);
    shown.pixel_scale = std::max(1.0f, whole.y1 / line_height);
    return shown;
}

void Viewer::begin_film(const FilmPlan& plan, const Scene& scene, std::optional<Fork> start,
                        const std::string& asked_by) {
    check_film(plan);
    filming_.reset(new Filming{.recording = Recording(plan, scene, std::move(start), asked_by),
                               .target = RenderTarget(plan.width, plan.height, samples),
                               .view = picture(),
                               .camera = camera_,
                               .scene = scene,
                               .settings = app_.scene.view});
}

/// One frame at most: the window is drawn in between.
void Viewer::film_frame() {
    if (!filming_) return;
    const auto frame = filming_->recording.take();
    if (!frame) return;
    RenderTarget& target = filming_->target;
    renderer_.upload(frame->snapshot);
    renderer_.draw(filming_->picture(*frame), target);
    target.begin_panels();
    filming_->recording.add(target.read(filming_->recording.plan().transparent));
    renderer_.upload(moment_.snapshot);
    ++filming_->drawn;
}

void Viewer::film_wanted() {
    FilmDesk& desk = app_.film;
    if (desk.open && desk.file.empty()) desk.file = free_file_name(".mp4").string();
    if (app_.commands.save_shape) save_shape();
    if (app_.commands.stop_film) stop_film("The film was stopped; nothing is left of it.");
    try {
        if (app_.commands.start_film || app_.commands.replace_film) ask_film();
        if (film_asked_)
            if (auto fork = simulation_.take_fork()) {
                const Scene scene = fork->scene;
                begin_film(*std::exchange(film_asked_, std::nullopt), scene, std::move(fork), "");
            }
    } catch (const InputError& wrong) {
        film_asked_.reset();
        say(app_, Message::Cause::film, wrong.what(), true);
    }
    hear_of_film();
}

/// A film is asked for: it begins once the simulation has told where it is, unless it would replace a file.
void Viewer::ask_film() {
    if (filming_ || film_asked_) return;
    const FilmPlan plan = film_plan(app_.film, window_.framebuffer_size(), transparent());
    check_film(plan);
    std::error_code failure;
    if (!app_.commands.replace_film && std::filesystem::exists(first_file(plan), failure)) {
        app_.question =
            question_before_overwriting(plan.file.string() + " exists. Overwrite it?",
                                        [file = plan.file](AppState& app) { app.commands.replace_film = file; });
        return;
    }
    check_outputs({}, {{"the film", first_file(plan).string()}});
    close_if(app_.message, Message::Cause::film);
    film_asked_ = plan;
    app_.film.written = app_.film.frames = 0;
    app_.film.open = false;
    simulation_.ask_fork();
}

void Viewer::hear_of_film() {
    FilmDesk& desk = app_.film;
    desk.under_way = filming_ || film_asked_;
    if (!filming_) return;
    const Recording& recording = filming_->recording;
    desk.name = recording.plan().file.filename().string();
    desk.written = recording.written();
    desk.frames = recording.plan().frames();
    const std::string trouble = recording.trouble(), file = recording.plan().file.string();
    if (!trouble.empty()) return stop_film("No film: " + trouble);
    if (!recording.done()) return;
    filming_.reset();
    desk.under_way = false;
    desk.file.clear();
    say(app_, Message::Cause::film, "Saved " + file, false);
}

void Viewer::stop_film(const std::string& why) {
    if (!filming_ && !film_asked_) return;
    filming_.reset();
    film_asked_.reset();
    app_.film.under_way = false;
    say(app_, Message::Cause::film, why, true);
}

void Viewer::save_shape() {
    try {
        const auto file = free_file_name(".obj");
        write_obj(file, moment_.snapshot);
        say(app_, Message::Cause::film, "Saved " + std::filesystem::absolute(file).string(), false);
    } catch (const InputError& wrong) {
        say(app_, Message::Cause::film, wrong.what(), true);
    }
}

int Viewer::make_film() {
    const Interruption interruption;
    FilmPlan plan = film_plan(options_);
    plan.transparent = transparent();
    receive(0.0);
    begin_film(plan, app_.scene, std::nullopt, "--record");
    ProgressLine progress(plan);
    Recording& recording = filming_->recording;
    constexpr double patience = 0.1;  // s between two looks at signals
    while (!recording.done() && recording.trouble().empty()) {
        if (const int signal = interruption.signal()) {
            filming_.reset();
            progress.end();
            complain("drapeau", "stopped; nothing is left of " + one_line(plan.file.string(), 1000));
            return 128 + signal;
        }
        if (filming_->drawn < plan.frames())
            recording.wait(patience);
        else
            recording.wait_for_writer(patience);
        film_frame();
        progress.show(recording.written());
    }
    progress.end();
    if (recording.done()) return 0;
    if (!recording.diverged()) throw InputError(recording.trouble());
    complain("drapeau", recording.trouble());
    return 3;
}

}  // namespace drapeau
