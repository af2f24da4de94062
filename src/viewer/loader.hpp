// Loader: scenes and images read on a thread of their own, so that the window goes on while a large one is decoded.
// One file at a time, so that two never need memory at once. A scene replaces everything chosen before it, an image
// only an image: one that is chosen while a scene is read lies on that scene's flag afterwards.
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

class Loader {
public:
    Loader();
    /// Ends promptly, whatever is being decoded.
    ~Loader();
    Loader(const Loader&) = delete;
    Loader& operator=(const Loader&) = delete;

    void load_scene(const std::string& path_or_name);
    void load_image(const std::string& path_or_name);
    void forget_image();  // none is wanted

    /// The name of the file that is waited for; empty if none is.
    std::string waiting_for() const;
    /// What is ready, in the order it was chosen; an image only where the flag is ready for it.
    std::optional<Loaded> take(bool image_too = true);
    void wait();  // until nothing is waited for

private:
    struct Chosen {
        std::string given;  // as it was typed, dropped or listed
        std::string name;   // for a person
    };

    static Chosen chosen(const std::string& given);
    static Loaded load(bool scene, const std::string& given, const std::stop_token& stop);
    void work(const std::stop_token& ending);
    void drop_image();

    mutable std::mutex mutex_;
    std::condition_variable_any wanted_;
    std::condition_variable finished_;
    std::optional<Chosen> scene_, image_;  // not begun
    std::optional<Chosen> now_;            // being read
    bool now_a_scene_ = false;
    std::stop_source abandon_;  // of what is being read
    std::deque<Loaded> ready_;

    std::jthread thread_;  // the last member: it is joined first
};

}  // namespace drapeau
