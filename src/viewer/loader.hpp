// Loader: scenes and images read on a thread of their own, so that the window goes on while a large one is decoded.
// One file at a time, so that two never need memory at once. A scene replaces everything chosen before it, an image
// only an image: one that is chosen while a scene is read lies on that scene's flag afterwards. Small copies of images
// are made while nothing else is wanted; one that is begun gives way.
#pragma once

#include "library.hpp"

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

namespace drapeau {

/// What became of a file that was chosen.
struct Loaded {
    bool is_scene = false;
    LoadedScene scene;           // of a scene that was read
    std::filesystem::path file;  // of an image that was read
    std::optional<Image> image;
    std::string fault;  // why the scene or the image cannot be used; empty if it can
};

/// A small copy of an image for a gallery; none if the image cannot be read.
struct SmallImage {
    std::filesystem::path file;
    std::optional<Image> image;
};

class Loader {
public:
    static constexpr int small_side = 240;  // pixels, the longer side of a small copy at most

    Loader();
    /// Ends promptly, whatever is being decoded.
    ~Loader();
    Loader(const Loader&) = delete;
    Loader& operator=(const Loader&) = delete;

    void load_scene(const std::string& path_or_name);
    void load_image(const std::string& path_or_name);
    void forget_image();  // none is wanted
    /// Asks for a small copy, unless it is made already or waits to be; one that gave way has to be asked for again.
    void load_small(const std::filesystem::path& file);

    /// The name of the file that is waited for; empty if none is.
    std::string waiting_for() const;
    /// What is ready, in the order it was chosen; an image only where the flag is ready for it.
    std::optional<Loaded> take(bool image_too = true);
    std::optional<SmallImage> take_small();
    bool makes_small() const;  // or has some to be taken
    void wait();               // until nothing is waited for, small copies included

private:
    struct Chosen {
        std::string given;  // as it was typed, dropped or listed
        std::string name;   // for a person
    };

    static Chosen chosen(const std::string& given);
    static Loaded load(bool scene, const std::string& given, const std::stop_token& stop);
    static SmallImage small_copy(const std::filesystem::path& file, const std::stop_token& stop);
    void work(const std::stop_token& ending);
    void make_small(std::unique_lock<std::mutex>& lock);
    void drop_image();

    mutable std::mutex mutex_;
    std::condition_variable_any wanted_;
    std::condition_variable finished_;
    std::optional<Chosen> scene_, image_;  // not begun
    std::optional<Chosen> now_;            // being read
    bool now_a_scene_ = false;
    std::stop_source abandon_;  // of what is being read
    std::deque<Loaded> ready_;
    std::deque<std::filesystem::path> small_;         // not begun
    std::optional<std::filesystem::path> small_now_;  // being made
    std::deque<SmallImage> small_ready_;

    std::jthread thread_;  // the last member: it is joined first
};

}  // namespace drapeau
