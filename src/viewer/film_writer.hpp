// Film writer: encodes the frames of a film on a thread of its own, into one file or a sequence of pictures. What is
// not finished is removed.
#pragma once

#include "film.hpp"
#include "film_plan.hpp"

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace drapeau {

class FilmWriter {
public:
    /// Throws InputError if the file cannot be written or there is no ffmpeg. `asked_by`: "--record", or nothing.
    FilmWriter(const FilmPlan& plan, const std::string& asked_by);
    ~FilmWriter();
    FilmWriter(const FilmWriter&) = delete;
    FilmWriter& operator=(const FilmWriter&) = delete;

    bool has_room() const;  // for one more frame, so that add need not wait
    void add(Image frame);  // the last of the plan's frames finishes the film
    long long written() const;

    bool done() const;            // whether the film is whole
    std::string trouble() const;  // why it cannot be made; empty while it can

    /// Until a frame more is written, or the end; at most so many seconds.
    void wait(double seconds);

private:
    void work();
    void write(const Image& frame, long long number);
    void name_pictures();
    void remove_pictures();

    FilmPlan plan_;
    std::optional<Film> film_;                     // none: a sequence of pictures
    std::vector<std::filesystem::path> pictures_;  // written so far; only the thread touches it

    mutable std::mutex mutex_;
    std::condition_variable wanted_, finished_;
    std::deque<Image> waiting_;
    long long written_ = 0;
    bool ending_ = false, done_ = false;
    std::string trouble_;
    std::thread thread_;
};

}  // namespace drapeau
