#include "loader.hpp"

#include "image/image_file.hpp"
#include "io/error.hpp"
#include "io/given_path.hpp"
#include "scene/file.hpp"

#include <exception>
#include <new>
#include <utility>

namespace drapeau {

Loader::Loader() : thread_([this](const std::stop_token& ending) { work(ending); }) {}

Loader::~Loader() {
    const std::lock_guard lock(mutex_);
    abandon_.request_stop();
    thread_.request_stop();
}

Loader::Chosen Loader::chosen(const std::string& given) {
    return {given, std::filesystem::path(meant_path(given)).filename().string()};
}

void Loader::load_scene(const std::string& path_or_name) {
    {
        const std::lock_guard lock(mutex_);
        abandon_.request_stop();
        ready_.clear();
        image_.reset();
        scene_ = chosen(path_or_name);
    }
    wanted_.notify_one();
}

void Loader::load_image(const std::string& path_or_name) {
    {
        const std::lock_guard lock(mutex_);
        drop_image();
        image_ = chosen(path_or_name);
    }
    wanted_.notify_one();
}

void Loader::forget_image() {
    const std::lock_guard lock(mutex_);
    drop_image();
}

void Loader::drop_image() {
    image_.reset();
    if (!now_a_scene_) abandon_.request_stop();
    std::erase_if(ready_, [](const Loaded& loaded) { return !loaded.is_scene; });
}

std::string Loader::waiting_for() const {
    const std::lock_guard lock(mutex_);
    for (const auto* chosen : {&image_, &scene_, &now_})
        if (*chosen) return (*chosen)->name;
    return "";
}

std::optional<Loaded> Loader::take(bool image_too) {
    const std::lock_guard lock(mutex_);
    if (ready_.empty() || (!image_too && !ready_.front().is_scene)) return {};
    Loaded first = std::move(ready_.front());
    ready_.pop_front();
    return first;
}

void Loader::wait() {
    std::unique_lock lock(mutex_);
    finished_.wait(lock, [this] { return !scene_ && !image_ && !now_; });
}

void Loader::work(const std::stop_token& ending) {
    std::unique_lock lock(mutex_);
    while (wanted_.wait(lock, ending, [this] { return scene_ || image_; }) && !ending.stop_requested()) {
        now_a_scene_ = scene_.has_value();
        now_ = std::exchange(now_a_scene_ ? scene_ : image_, std::nullopt);
        abandon_ = std::stop_source();
        const std::stop_token stop = abandon_.get_token();
        const std::string given = now_->given;
        const bool scene = now_a_scene_;
        lock.unlock();
        Loaded loaded = load(scene, given, stop);
        lock.lock();
        if (!stop.stop_requested()) ready_.push_back(std::move(loaded));
        now_.reset();
        finished_.notify_all();
    }
}

// What was abandoned is thrown away by whoever asked.
Loaded Loader::load(bool scene, const std::string& given, const std::stop_token& stop) {
    Loaded loaded{.is_scene = scene, .scene = {}, .file = {}, .image = {}, .fault = {}};
    try {
        if (scene) {
            loaded.scene = drapeau::load_scene(given, {}, stop);
        } else {
            loaded.file = find_picture(given);
            loaded.image = drapeau::load_image(loaded.file, stop);
        }
    } catch (const Abandoned&) {
        return loaded;
    } catch (const std::bad_alloc&) {
        loaded.fault = "not enough memory to load this file; use a smaller one";
    } catch (const std::exception& wrong) {
        loaded.fault = wrong.what();
    }
    return loaded;
}

}  // namespace drapeau
