// The viewer's other half: from the newest moment to the picture, the panels and the files.
#include "viewer.hpp"

#include "hand_overlay.hpp"
#include "legend.hpp"
#include "stage.hpp"

#include "io/error.hpp"
#include "io/text.hpp"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <glm/vec4.hpp>

#include <algorithm>
#include <chrono>
#include <thread>

namespace drapeau {

namespace {

constexpr double min_frame_seconds = 0.008;  // where the display does not hold the loop back

std::string written(Area area) {
    return fmt::format("{:.1f} {:.1f} {:.1f} {:.1f}", area.x0, area.y0, area.x1, area.y1);
}

/// The pixels that the panel covers whatever the rounding of its corners.
glm::ivec4 pixels_under(const Area& panel, float pixels_per_unit, int height) {
    const float inset = 10.0f;
    if (panel.width() < 3.0f * inset || panel.height() < 3.0f * inset) return glm::ivec4(0);
    const auto pixels = [&](float units) { return int(units * pixels_per_unit); };
    return {pixels(panel.x0 + inset), height - pixels(panel.y1 - inset), pixels(panel.width() - 2.0f * inset),
            pixels(panel.height() - 2.0f * inset)};
}

/// The rectangle around the masses as they are drawn.
Area around_masses(const FieldBuffer<float>& position, const glm::mat4& to_clip, glm::vec2 size) {
    Area area{1e9f, 1e9f, -1e9f, -1e9f};
    for (int row = 0; row < position.rows(); ++row)
        for (int column = 0; column < position.columns(); ++column) {
            const glm::vec4 clip = to_clip * glm::vec4(glm::vec3(position.at(column, row)), 1.0f);
            if (clip.w <= 0.0f) continue;
            const glm::vec2 place((0.5f + 0.5f * clip.x / clip.w) * size.x, (0.5f - 0.5f * clip.y / clip.w) * size.y);
            area = {std::min(area.x0, place.x), std::min(area.y0, place.y), std::max(area.x1, place.x),
                    std::max(area.y1, place.y)};
        }
    return area;
}

/// A wireframe that is behind in time is faint: it shows where the reference was, not how far the flag is from it.
float reference_opacity(const Status& status) {
    if (!status.reference || !status.reference->trouble.empty()) return 0.0f;
    return status.reference->lags(status.time) ? 0.25f : 0.8f;
}

}  // namespace

Picture Viewer::picture() const {
    const ViewSettings& view = app_.scene.view;
    const FlagSettings& flag = moment_.scene.flag;
    const float pixel_scale = float(target_.height()) / std::max(1.0f, size().y);
    const std::vector<Streak> none;
    return {.view = camera_.view_matrix(framing_, app_.view_area),
            .projection = camera_.projection(framing_, app_.view_area, size()),
            .eye = camera_.eye(framing_, app_.view_area),
            .cloth = view.cloth,
            .texture = view.texture,
            .cut_out = view.cut_out,
            .springs = view.springs,
            .forces = view.forces,
            .masses = view.masses,
            .bare_grid = view.bare_grid,
            .cloth_size = {float(flag.width), float(flag.height)},
            .header = has_header(flag),
            .reference = reference_opacity(app_.status),
            .kinds = moment_.kinds,
            .force_scale = float(force_end(app_)),
            .colours = view.colours,
            .stretch = view.stretch,
            .stretch_scale = float(stretch_end(app_)),
            .streaks = view.wind && app_.scene.wind() ? app_.streaks.streaks() : none,
            .velocities = view.velocities ? velocities_of(moment_.snapshot, flag, speed_end(app_)) : none,
            .hidden = pixels_under(app_.panel_area, pixel_scale, target_.height()),
            .pixel_scale = pixel_scale,
            .stage = stage_of(moment_.scene, view.person),
            .background = view.background};
}

void Viewer::draw() {
    const FlagSettings& flag = moment_.scene.flag;
    framing_ = framing_of(flag, stage_of(moment_.scene, app_.scene.view.person));
    // What nothing holds falls; the camera goes with it, unless there is ground to see it fall upon.
    if (flag.attach == Attach::none && !moment_.scene.limits.get<Ground>())
        framing_.centre = middle_of(moment_.snapshot.position);
    film_frame();
    if (!picture_wanted()) return;
    const Picture wanted = picture();
    own_work_.pause();
    renderer_.draw(wanted, target_);
    own_work_.begin();
}

void Viewer::panels() {
    own_work_.pause();
    if (picture_wanted()) target_.begin_panels();
    own_work_.begin();
    draw_panels(app_, panel_memory_, map_);
    note_changes();
    gui_.end();
    own_work_.pause();
    gui_.draw();
}

void Viewer::present() {
    ++frame_;
    own_work_.end_frame();
    app_.status.own_seconds = own_work_.seconds();
    if (picture_wanted()) {
        const glm::ivec2 window = window_.framebuffer_size();
        if (film_) film_->add(target_.read(options_.transparent));
        if (app_.commands.screenshot) take_screenshot(free_screenshot_name());
        if (frame_ == options_.frames && !options_.screenshot.empty())
            write_png(options_.screenshot, target_.read(transparent()));
        if (frame_ == options_.frames && film_) film_->finish();
        if (transparent()) renderer_.draw_checkerboard(12.0f * float(target_.height()) / std::max(1.0f, size().y));
        target_.show(window.x, window.y);
        gl_errors_.poll();
    }
    rest_seconds_ = repeatable() ? 0.0 : rest_.seconds(activity());
    write_map();
    window_.swap();
    const double spent = glfwGetTime() - last_time_;
    if (!repeatable() && spent < min_frame_seconds)
        std::this_thread::sleep_for(std::chrono::duration<double>(min_frame_seconds - spent));
}

Activity Viewer::activity() const {
    const Message& message = app_.message;
    return {.events = had_events_ || gui_.has_waiting_keys() || app_.mark,
            .runs = runs() || app_.playback.backwards || app_.orbits,
            .simulation = !simulation_.idle() || opening_ || !app_.status.loading.empty() || loader_.makes_small() ||
                          measuring_.under_way() || filming_ || film_asked_,
            .hidden = hidden_,
            .typing = ImGui::GetIO().WantTextInput,
            .message_left = message.text.empty() ? 0.0 : message.seconds_left,
            .panel_left = panel_memory_.widgets.due};
}

void Viewer::take_screenshot(const std::filesystem::path& file) {
    app_.commands.screenshot = false;
    try {
        write_png(file, target_.read(transparent()));
        say(app_, Message::Cause::screenshot, "Saved " + std::filesystem::absolute(file).string(), false);
    } catch (const InputError& wrong) {
        say(app_, Message::Cause::screenshot, wrong.what(), true);
    }
}

void Viewer::write_map() {
    if (!map_.wanted()) return;
    const Status& status = app_.status;
    const glm::vec3 target = camera_.target(framing_);
    const glm::mat4 to_clip =
        camera_.projection(framing_, app_.view_area, size()) * camera_.view_matrix(framing_, app_.view_area);
    map_.state("frame", frame_);
    map_.state("scene", app_.scene.name);
    map_.state("time", status.time);
    map_.state("steps", double(status.steps));
    map_.state("paused", app_.paused || status.stands() ? "1" : "0");
    map_.state("shown", app_.playback.shown ? rounded(*app_.playback.shown, 9) : "");
    map_.state("backwards", app_.playback.backwards ? "1" : "0");
    map_.state("speed", app_.playback.speed().factor);
    map_.state("kept_from", app_.playback.from);
    map_.state("kept_to", app_.playback.to);
    map_.state("kept", double(app_.playback.moments));
    map_.state("diverged", status.divergence ? "1" : "0");
    map_.state("columns", status.columns);
    map_.state("rows", status.rows);
    map_.state("texture", app_.texture_file.string());
    map_.state("message", app_.message.shown());
    const bool has_message = !app_.message.text.empty() || app_.status.stands();
    map_.state("message_box", has_message ? written(app_.message_area) : "");
    map_.state("question", app_.question ? printable(app_.question->text) : "");
    map_.state("loading", printable(status.loading));
    map_.state("settling", status.settling ? "1" : "0");
    map_.state("azimuth", double(camera_.azimuth));
    map_.state("elevation", double(camera_.elevation));
    map_.state("distance", double(camera_.distance(framing_, app_.view_area)));
    map_.state("target_x", double(target.x));
    map_.state("target_y", double(target.y));
    map_.state("target_z", double(target.z));
    write_hand(app_, map_);
    map_.state("framebuffer", std::to_string(target_.width()) + "x" + std::to_string(target_.height()));
    map_.state("window", std::to_string(int(size().x)) + "x" + std::to_string(int(size().y)));
    map_.state("panel", app_.panel_open() ? written(app_.panel_area) : "");
    map_.state("view", written(app_.view_area));
    map_.state("flag", written(around_masses(moment_.snapshot.position, to_clip, size())));
    map_.state("resting", rest_seconds_ > 0.0 ? "1" : "0");
    map_.state("help", app_.help_shown ? "1" : "0");
    map_.state("palette", app_.palette.open ? "1" : "0");
    map_.state("undo", app_.history.undone());
    map_.state("redo", app_.history.redone());
    map_.state("force_scale", force_end(app_));
    map_.state("reference_mm", status.reference ? 1e3 * status.reference->rms : -1.0);
    map_.state("measuring", app_.findings.under_way ? rounded(app_.findings.share, 3) : "");
    map_.state("film", app_.film.under_way ? std::to_string(app_.film.written) : "");
    map_.state("own_ms", 1e3 * status.own_seconds);
    map_.state("gl_errors", gl_errors_.count());
    map_.write();
}

}  // namespace drapeau
