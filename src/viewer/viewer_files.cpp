// What the viewer does with files: scenes and images that are wanted, scenes to be saved.
#include "saving.hpp"
#include "scene_cards.hpp"
#include "viewer.hpp"

#include "io/error.hpp"
#include "io/given_path.hpp"
#include "io/output_file.hpp"
#include "io/terminal.hpp"

#include <algorithm>
#include <utility>

namespace drapeau {

void Viewer::load_wanted() {
    ask_before_loading();
    const Commands& commands = app_.commands;
    if (commands.load_texture) restored_image_.clear();
    if (commands.load_texture || commands.load_scene) other_.reset();
    if (commands.load_texture && meant_path(*commands.load_texture).empty()) {
        loader_.forget_image();
        wear({}, std::nullopt);
    } else if (commands.load_texture) {
        loader_.load_image(*commands.load_texture);
    }
    if (commands.load_scene) loader_.load_scene(*commands.load_scene);
    if (repeatable()) loader_.wait();
    // An image that was chosen after a scene waits until that is taken; another scene does not.
    while (auto loaded = loader_.take(!opening_)) use(std::move(*loaded));
    app_.status.loading = loader_.waiting_for();
    thumbnail_textures_.serve(app_.thumbnails, loader_, repeatable());
}

/// Another scene or image would end a film under way.
void Viewer::ask_before_loading() {
    Commands& commands = app_.commands;
    if (commands.stop_film || !app_.film.under_way || !(commands.load_scene || commands.load_texture)) return;
    unless_filming(app_, "Open another",
                   [scene = std::exchange(commands.load_scene, std::nullopt),
                    image = std::exchange(commands.load_texture, std::nullopt)](AppState& app) {
                       app.commands.stop_film = true;
                       app.commands.load_scene = scene;
                       app.commands.load_texture = image;
                   });
}

// Files that cannot be used leave everything as it was, with a message.
void Viewer::use(Loaded loaded) {
    auto other = loaded.is_scene ? std::nullopt : std::exchange(other_, std::nullopt);
    const bool restored = !std::exchange(restored_image_, std::filesystem::path()).empty();
    if (!loaded.fault.empty() && other) {
        say(app_, Message::Cause::scene, other->place + ": " + loaded.fault, true);
    } else if (!loaded.fault.empty()) {
        say(app_, loaded.is_scene ? Message::Cause::scene : Message::Cause::image, loaded.fault, true);
    } else if (loaded.is_scene) {
        opening_ = std::move(loaded.scene);
        simulation_.restart(opening_->scene, ++revision_);
    } else if (other) {
        other->image_file = std::move(loaded.file);
        other->image = std::move(loaded.image);
        take_scene(std::move(*other));
    } else if (restored) {
        set_image(loaded.file, std::move(loaded.image));
    } else {
        wear(loaded.file, std::move(loaded.image));
        app_.scene.view.texture = true;
    }
}

/// The image, or none, that was chosen for the flag.
void Viewer::wear(const std::filesystem::path& file, std::optional<Image> image) {
    set_image(file, std::move(image));
    app_.scene.flag.texture = texture_name(file);
}

void Viewer::save_wanted() {
    const Commands& commands = app_.commands;
    try {
        if (commands.overwrite) save(*commands.overwrite);
        if (!commands.save_scene) return;
        const auto file = scene_path(meant_path(*commands.save_scene));
        std::vector<std::filesystem::path> own = app_.saved_files;
        own.push_back(app_.scene_file);
        app_.question.reset();
        if (const auto question = question_before_saving(file, own, app_.texture_file))
            app_.question =
                question_before_overwriting(*question, [file](AppState& app) { app.commands.overwrite = file; });
        else
            save(file);
    } catch (const InputError& wrong) {
        say(app_, Message::Cause::save, wrong.what(), true);
    }
}

void Viewer::save(const std::filesystem::path& file) {
    const Saved saved = save_scene(app_.scene, file, app_.texture_file);
    app_.saved_files.push_back(saved.file);
    remember_file(app_.remembered.recent_scenes, saved.file);
    if (is_same_file(saved.file.string(), watch_.file().string())) watch_.accept();
    const char* without = " without its image: a scene file holds no such file name";
    say(app_, Message::Cause::save, "Saved " + saved.file.string() + (saved.without_image ? without : ""),
        saved.without_image);
}

void Viewer::adopt(LoadedScene loaded) {
    app_.scene = app_.origin = loaded.scene;
    app_.scene_file = loaded.file;
    app_.diagonals.reset();
    app_.question.reset();  // it was about the scene before
    close_if(app_.message, Message::Cause::scene);
    set_image(loaded.texture_file, std::move(loaded.image));
    if (!loaded.fault.empty()) say(app_, Message::Cause::image, loaded.fault, true);
    if (!loaded.fault.empty() && repeatable()) complain("drapeau", loaded.fault);
    window_.set_title("drapeau \xe2\x80\x93 " + printable(loaded.scene.name));
    watch_.begin(loaded.file);
    const auto folder = assets_directory() / "scenes";
    std::error_code failure;
    if (!std::filesystem::equivalent(loaded.file.parent_path(), folder, failure))
        remember_file(app_.remembered.recent_scenes, loaded.file);
    app_.history.begin(entry_now());
}

void Viewer::set_image(const std::filesystem::path& file, std::optional<Image> image) {
    stop_film("The film was stopped: another image or scene was opened; nothing is left of it.");
    app_.status.flag_proportions = image ? double(image->width) / double(image->height) : 0.0;
    app_.status.image_has_holes = renderer_.wear(std::move(image));
    close_if(app_.message, Message::Cause::image);
    app_.texture_file = file;
    const auto& shipped = app_.texture_files;
    if (!file.empty() && std::find(shipped.begin(), shipped.end(), file) == shipped.end())
        remember_file(app_.remembered.recent_images, file);
}

}  // namespace drapeau
