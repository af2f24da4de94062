// The window that most tests look at.
#pragma once

#include "app.hpp"
#include "scenes.hpp"

namespace drapeau::window_tests {

/// A window on the still flag; what a test does is all that can change the picture.
struct StillFlag {
    Screen screen;
    TemporaryFolder folder;
    std::string file = written(folder, "still.toml", still_scene);
    App app{screen, {file, "--size", "900x640"}};
};

}  // namespace drapeau::window_tests
