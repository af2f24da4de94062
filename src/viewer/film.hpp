// Film: frames handed to ffmpeg as they are drawn; the file's ending chooses the format. The film appears once it is
// whole. Its colours are those of the pictures: converted by BT.709, as players of HD take them to be, and marked so.
#pragma once

#include "image/image.hpp"
#include "io/output_file.hpp"

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include <sys/types.h>

namespace drapeau {

/// What a film of an ending is made with: ffmpeg's filter and its options of codecs.
struct FilmFormat {
    std::string ending;
    std::string filter;
    std::vector<std::string> codec;
    std::string alpha_filter{};              // of a transparent one
    std::vector<std::string> alpha_codec{};  // likewise
    bool alpha = false;                      // may be transparent
    bool even = true;                        // its sides
};

/// Throws InputError if the ending of the name, in capitals or not, is that of no kind of film made here. What means a
/// sequence is one of PNG pictures.
const FilmFormat& film_format(const std::filesystem::path& file);

/// "webm, mov ..."
std::string transparent_formats();

/// Throws InputError if the ending of the name is that of no film that is one file; `asked_by` is the option's name.
void check_film_name(const std::filesystem::path& file, const std::string& asked_by);

struct FilmSettings {
    std::filesystem::path file;
    int width = 0, height = 0;  // pixels
    double rate = 60.0;         // frames/s
    bool transparent = false;
    std::string asked_by{};  // "--film": begins the messages
};

class Film {
public:
    /// Throws InputError if the file cannot be written or there is no ffmpeg.
    explicit Film(const FilmSettings& settings);
    /// What is not finished is given up: no file is left of it.
    ~Film();
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;

    /// Throws InputError where ffmpeg takes no more.
    void add(const Image& frame);

    /// Throws InputError if ffmpeg did not make the film.
    void finish();

    /// Ends ffmpeg at once, from any thread: an add or a finish under way throws.
    void give_up();

private:
    int end();
    [[noreturn]] void fail();
    std::string name() const;

    FilmSettings settings_;
    OutputFile output_;
    int pipe_ = -1;
    int complaints_ = -1;  // a file in memory, what ffmpeg writes to its standard error
    std::mutex mutex_;     // guards the next
    pid_t ffmpeg_ = -1;
};

}  // namespace drapeau
