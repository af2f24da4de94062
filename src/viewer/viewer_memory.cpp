// What the viewer remembers: settings to go back to, files saved elsewhere, what is kept between runs.
#include "viewer.hpp"

#include "io/error.hpp"
#include "io/terminal.hpp"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace drapeau {

namespace fs = std::filesystem;

namespace {

constexpr double saving_pause = 2.0;  // s between two writes of what is remembered
constexpr double early = 0.02;        // s by which a wait that was not interrupted may end too soon

bool starts_alike(const FlagSettings& one, const FlagSettings& other) {
    return one.start == other.start && one.prestretch == other.prestretch && one.disturbance == other.disturbance;
}

/// What the command line says instead of its scene's file, but for the image, which is loaded once.
std::vector<Assignment> assignments_of(const Options& options) {
    std::vector<Assignment> assignments;
    for (const std::string& text : options.set)
        if (const Assignment one = assignment_in(text); one.key != "flag.texture" || one.value.empty())
            assignments.push_back(one);
    return assignments;
}

bool gives_image(const Options& options) {
    const auto names_it = [](const std::string& text) { return assignment_in(text).key == "flag.texture"; };
    return !options.texture.empty() || std::any_of(options.set.begin(), options.set.end(), names_it);
}

std::string with_undo(const std::string& text) {
    return text + " Ctrl Z brings back what was set before.";
}

}  // namespace

void Viewer::recall() {
    if (repeatable()) return;
    settings_file_ = user_settings_file();
    FoundSettings found = find_user_settings(settings_file_);
    app_.remembered = kept_settings_ = found.settings;
    for (auto* files : {&app_.remembered.recent_scenes, &app_.remembered.recent_images})
        std::erase_if(*files, [](const std::string& file) {
            std::error_code failure;
            return !fs::exists(file, failure);
        });
    if (!found.may_be_saved) settings_file_.clear();
    if (!found.trouble.empty()) say(app_, Message::Cause::settings, found.trouble, true);
    const auto* page = std::find(std::begin(page_names), std::end(page_names), app_.remembered.page);
    if (page != std::end(page_names)) panel_memory_.page = int(page - page_names);
    if (options_.size_given) {
        passing_size_ = {options_.width, options_.height};
    } else {
        options_.width = app_.remembered.width;
        options_.height = app_.remembered.height;
    }
}

void Viewer::remember() {
    if (repeatable()) return;
    if (app_.commands.forget_settings) {
        app_.remembered = {};
        app_.panel_shown = true;
        panel_memory_.page = 0;
        passing_size_ = window_.size();
        say(app_, Message::Cause::settings, "Forgotten: the window begins with defaults at the next start", false);
    }
    UserSettings& remembered = app_.remembered;
    if (!options_.hide_ui) remembered.panel = app_.panel_shown;
    remembered.page = page_names[panel_memory_.page];
    if (const glm::ivec2 size = window_.size(); size != passing_size_ && !hidden_) {
        const float scale = window_.content_scale();
        remembered.width = std::clamp(int(std::lround(float(size.x) / scale)), 480, 16384);
        remembered.height = std::clamp(int(std::lround(float(size.y) / scale)), 360, 16384);
        passing_size_ = {};
    }
    if (wall_ - saved_settings_at_ > saving_pause) save_remembered();
}

void Viewer::save_remembered() {
    if (settings_file_.empty() || app_.remembered == kept_settings_) return;
    saved_settings_at_ = wall_;
    try {
        save_user_settings(app_.remembered, settings_file_);
        kept_settings_ = app_.remembered;
    } catch (const InputError& wrong) {
        settings_file_.clear();  // said once
        say(app_, Message::Cause::settings, std::string("Not remembered: ") + wrong.what(), false);
    }
}

Viewer::~Viewer() {
    save_remembered();
}

void Viewer::note_changes() {
    app_.history.observe(entry_now(), ImGui::GetActiveID());
}

// While an image to go back to is loaded, the flag still has the one before.
History::Entry Viewer::entry_now() const {
    return {app_.scene, restored_image_.empty() ? app_.texture_file : restored_image_};
}

void Viewer::undo_wanted() {
    const bool undo = app_.commands.undo;
    if (!(undo || app_.commands.redo) || opening_) return;
    if (app_.playback.shown)
        return say(app_, Message::Cause::history, "An earlier moment is shown: go on from it, or back to the end",
                   false);
    if (undo && drop_other_scene()) return say(app_, Message::Cause::history, "Undone: the scene that was read", false);
    const std::string what = undo ? app_.history.undone() : app_.history.redone();
    const auto entry = undo ? app_.history.undo() : app_.history.redo();
    if (!entry) return say(app_, Message::Cause::history, undo ? "Nothing to undo" : "Nothing to redo", false);
    app_.scene = entry->scene;
    restore_image(entry->image);
    say(app_, Message::Cause::history, (undo ? "Undone: " : "Redone: ") + what, false);
}

/// The image that the scene's settings go with, which they name already.
void Viewer::restore_image(const fs::path& file) {
    if (file == entry_now().image) return;
    drop_other_scene();
    restored_image_ = file;
    if (!file.empty()) return loader_.load_image(file.string());
    loader_.forget_image();
    set_image({}, std::nullopt);
}

std::vector<InputEvent> Viewer::wait_for_events() {
    if (rest_seconds_ <= 0.0) return window_.poll();
    const double end = glfwGetTime() + rest_seconds_;
    for (double now = glfwGetTime(); now < end; now = glfwGetTime()) {
        const double wait = std::min(end - now, SceneWatch::pause);
        std::vector<InputEvent> events = window_.poll(wait);
        file_changed_ = !repeatable() && watch_.changed(glfwGetTime());
        const bool woken = glfwGetTime() - now < wait - early;
        if (woken || file_changed_ || !events.empty()) return events;
    }
    return {};
}

void Viewer::reload_wanted() {
    if (repeatable() || opening_) return;
    if (!std::exchange(file_changed_, false) && !watch_.changed(glfwGetTime())) return;
    drop_other_scene();
    try {
        const bool first = watch_.file() == first_file_;
        Scene read = read_scene(watch_.file(), first ? assignments_of(options_) : std::vector<Assignment>{});
        if (first) preset_view(options_, read.view);
        if (first && gives_image(options_)) read.flag.texture = app_.origin.flag.texture;
        Scene scene = read;
        if (read.view == app_.origin.view) scene.view = app_.scene.view;  // as it is looked at
        set_scene({.scene = std::move(scene),
                   .origin = std::move(read),
                   .place = place_of_texture(watch_.file()),
                   .news = watch_.file().filename().string() + " was saved: it is read again."});
    } catch (const InputError& wrong) {
        say(app_, Message::Cause::scene, wrong.what(), true);
    }
}

/// One that waits for its image is wanted no more.
bool Viewer::drop_other_scene() {
    const bool waited = std::exchange(other_, std::nullopt).has_value();
    if (waited) loader_.forget_image();
    return waited;
}

/// Takes it once its image is there. Throws InputError, beginning with its place, and changes nothing where that is not
/// found.
void Viewer::set_scene(OtherScene other) {
    drop_other_scene();
    const std::string& texture = other.scene.flag.texture;
    if (texture != app_.scene.flag.texture) {
        const fs::path image = texture.empty() ? fs::path() : find_texture(texture, app_.scene_file, other.place);
        other.other_image = image != entry_now().image;
        other.image_file = image;
    }
    if (other.other_image) restored_image_.clear();
    if (!other.other_image || texture.empty()) return take_scene(std::move(other));
    other_ = std::move(other);
    loader_.load_image(other_->image_file.string());
}

void Viewer::take_scene(OtherScene other) {
    const bool differs = other.scene != app_.scene, pasted = !other.origin;
    const bool loses = pasted || physics_of(app_.scene) != physics_of(app_.origin);
    close_if(app_.message, Message::Cause::scene);
    if (differs) {
        note_changes();
        if (!starts_alike(other.scene.flag, app_.scene.flag)) app_.commands.restart = true;
        app_.scene = std::move(other.scene);
        app_.diagonals.reset();
        window_.set_title("drapeau \xe2\x80\x93 " + printable(app_.scene.name));
    }
    if (other.other_image) set_image(other.image_file, std::move(other.image));
    if (!pasted) app_.origin = std::move(*other.origin);
    if (differs || pasted) say(app_, Message::Cause::scene, loses ? with_undo(other.news) : other.news, false);
}

void Viewer::clipboard_wanted() {
    if (app_.commands.copy_scene) {
        Scene scene = app_.scene;
        if (!app_.texture_file.empty()) scene.flag.texture = texture_name(app_.texture_file);
        ImGui::SetClipboardText(write_scene(scene).c_str());
        say(app_, Message::Cause::scene, "Copied: the scene as text", false);
    }
    if (!app_.commands.paste_scene || opening_) return;
    try {
        const char* clipped = ImGui::GetClipboardText();
        const std::string text = clipped ? clipped : "", origin = "pasted text";
        Scene scene = parse_scene(text, origin);
        const std::string news = "Pasted: " + scene.name + ".";
        set_scene({.scene = std::move(scene), .place = place_of_texture(text, origin), .news = news});
    } catch (const InputError& wrong) {
        say(app_, Message::Cause::scene, wrong.what(), true);
    }
}

}  // namespace drapeau
