// Options: the command line of the window.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace drapeau {

struct Options {
    std::string scene = "report";
    int frames = 0;  // 0: until the window is closed
    std::string screenshot, film;
    std::string record, obj;                   // files; each makes what it names and leaves
    std::optional<double> seconds, fps, from;  // of record and obj
    bool loop = false, transparent = false;
    int width = 1280, height = 800;
    bool size_given = false;
    std::string texture;           // instead of the scene's own
    std::vector<std::string> set;  // "KEY=VALUE", instead of what the scene says
    bool hide_ui = false;
    bool springs = false, forces = false, masses = false, no_texture = false;
    std::optional<float> azimuth, elevation;  // degrees
};

/// Reads the command line. Gives an exit status if the program has nothing more to do (help, version, bad input).
std::optional<int> read_options(int count, char** words, Options& options);

}  // namespace drapeau
