// Film plan: what a film shows and where it is kept. Frame k shows the flag k / rate seconds after the first.
#pragma once

#include <filesystem>

namespace drapeau {

inline constexpr long long max_film_frames = 1000000;
inline constexpr double max_film_rate = 240.0;  // frames/s
inline constexpr double max_swing_in = 3600.0;  // s

struct FilmPlan {
    std::filesystem::path file;       // its ending chooses the format; frames-%04d.png: a picture a frame
    int width = 1920, height = 1080;  // pixels
    double rate = 60.0;               // frames/s
    double seconds = 10.0;            // its length
    double from = 0.0;                // s of simulated time that pass before its first frame
    bool loop = false;                // its last second passes into its beginning
    bool transparent = false;

    /// How many frames it has: one at least.
    long long frames() const;
    /// Seconds of simulated time from where the run begins to frame k.
    double time_of(long long frame) const;
    /// Of a film that loops, how many of its last frames pass over into what came before its first.
    long long blended() const;
    /// Of a frame, the share of what came as long before the first frame as this one comes before the film's end.
    double share_of_beginning(long long frame) const;
};

/// The rate for films of this ending where none is given (frames/s).
double usual_film_rate(const std::filesystem::path& file);

/// Throws InputError if the plan's times are none that a film can have.
void check_times(const FilmPlan& plan);

/// Throws InputError, in one line that begins with the file's name or with what is wrong, if no such film can be made.
void check_film(const FilmPlan& plan);

}  // namespace drapeau
