// Film: frames handed to ffmpeg as they are drawn; the file's ending chooses the format. The film appears once it is
// whole. Its colours are those of the pictures: converted by BT.709, as players of HD take them to be, and marked so.
#pragma once

#include "image/image.hpp"
#include "io/output_file.hpp"

#include <filesystem>

#include <sys/types.h>

namespace drapeau {

/// Throws InputError if the ending of the name, in capitals or not, is that of no kind of film made here.
void check_film_name(const std::filesystem::path& file);

class Film {
public:
    /// Throws InputError if the file cannot be written or there is no ffmpeg.
    Film(const std::filesystem::path& file, int width, int height, int frames_per_second);
    ~Film();
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;

    void add(const Image& frame);

    /// Throws InputError if ffmpeg did not make the film.
    void finish();

private:
    int end();
    [[noreturn]] void fail();

    std::filesystem::path file_;
    OutputFile output_;
    int width_, height_;
    int pipe_ = -1;
    int complaints_ = -1;  // a file in memory, what ffmpeg writes to its standard error
    pid_t ffmpeg_ = -1;
};

}  // namespace drapeau
