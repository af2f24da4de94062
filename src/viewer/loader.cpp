#include "loader.hpp"

#include "image/image_file.hpp"
#include "io/error.hpp"
#include "io/given_path.hpp"
#include "scene/file.hpp"

#include <algorithm>
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

void Loader::load_small(const std::filesystem::path& file) {
    {
        const std::lock_guard lock(mutex_);
        const auto is_it = [&](const SmallImage& made) { return made.file == file; };
        if (small_now_ == file || std::find(small_.begin(), small_.end(), file) != small_.end() ||
            std::any_of(small_ready_.begin(), small_ready_.end(), is_it))
            return;
        small_.push_back(file);
    }
    wanted_.notify_one();
}

std::optional<SmallImage> Loader::take_small() {
    const std::lock_guard lock(mutex_);
    if (small_ready_.empty()) return {};
    SmallImage first = std::move(small_ready_.front());
    small_ready_.pop_front();
    return first;
}

bool Loader::makes_small() const {
    const std::lock_guard lock(mutex_);
    return small_now_ || !small_.empty() || !small_ready_.empty();
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
    finished_.wait(lock, [this] { return !scene_ && !image_ && !now_ && small_.empty() && !small_now_; });
}

void Loader::work(const std::stop_token& ending) {
    std::unique_lock lock(mutex_);
    const auto is_wanted = [this] { return scene_ || image_ || !small_.empty(); };
    while (wanted_.wait(lock, ending, is_wanted) && !ending.stop_requested()) {
        if (!scene_ && !image_) {
            make_small(lock);
            continue;
        }
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

void Loader::make_small(std::unique_lock<std::mutex>& lock) {
    small_now_ = small_.front();
    small_.pop_front();
    now_a_scene_ = false;
    abandon_ = std::stop_source();
    const std::stop_token stop = abandon_.get_token();
    const std::filesystem::path file = *small_now_;
    lock.unlock();
    SmallImage made = small_copy(file, stop);
    lock.lock();
    if (!stop.stop_requested()) small_ready_.push_back(std::move(made));
    small_now_.reset();
    finished_.notify_all();
}

SmallImage Loader::small_copy(const std::filesystem::path& file, const std::stop_token& stop) {
    try {
        return {file, shrunk_to(drapeau::load_image(file, stop), small_side)};
    } catch (const Abandoned&) {
        return {file, {}};
    } catch (const std::exception&) {
        return {file, {}};
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
