// Film desk: what the window's film dialog holds, and how far a film under way is, as plain data.
#pragma once

#include "film_plan.hpp"

#include <glm/vec2.hpp>

#include <array>
#include <string>

namespace drapeau {

/// The sizes offered, in pixels; the first stands for the window's own.
inline constexpr std::array<glm::ivec2, 6> film_sizes{glm::ivec2(0, 0), {1280, 720},  {1920, 1080},
                                                      {2560, 1440},     {3840, 2160}, {1080, 1080}};
inline constexpr std::array<double, 6> film_rates{24.0, 25.0, 30.0, 50.0, 60.0, 120.0};  // frames/s

struct FilmDesk {
    static constexpr int usual_size = 2, usual_rate = 4;  // of the lists above
    static constexpr double usual_seconds = 10.0;

    bool open = false;
    std::string file;  // as typed
    int size = usual_size, rate = usual_rate;
    double seconds = usual_seconds;
    bool loop = false;

    // Of a film under way.
    bool under_way = false;
    std::string name;  // of its file
    long long written = 0, frames = 0;
};

/// The film that the dialog asks for, of a window of so many pixels.
FilmPlan film_plan(const FilmDesk& desk, glm::ivec2 window, bool transparent);

}  // namespace drapeau
