// Scenes written by the window tests: small, and still, so that two pictures differ only in what a test changed.
#pragma once

#include "process.hpp"

#include <string>
#include <vector>

namespace drapeau::window_tests {

/// Held nowhere, in no wind and without weight: it never moves. Four by three masses are three by two cells.
inline const std::string still_scene = R"(name = "Still"
[flag]
columns = 4
rows = 3
width = 1.5
height = 1.0
attach = "none"
start = "flat"
texture = "france.png"
[springs]
mass = 0.001
stiffness = 50.0
damping = 0.01
drag = 0.001
[time]
method = "semi-implicit-euler"
dt = "auto"
)";

/// Hangs from its top edge and rests: a vertical spring carries all the masses below it, so force grows upwards.
inline const std::string hanging_scene = R"(name = "Hanging"
[flag]
columns = 9
rows = 9
width = 1.0
height = 1.0
attach = "top"
start = "hanging"
[springs]
mass = 0.01
stiffness = 400.0
damping = 0.2
drag = 0.01
[gravity]
[time]
method = "semi-implicit-euler"
dt = "auto"
)";

/// The same with steps of about three times the limit of its springs: a first unevenness is all it needs to diverge.
inline std::string diverging_scene() {
    std::string scene = hanging_scene;
    const std::string automatic = "dt = \"auto\"";
    return scene.replace(scene.find(automatic), automatic.size(), "dt = 0.0166");
}

/// What opens a scene for tests that look at the panel alone: its frames cost a processor little.
inline std::vector<std::string> without_cloth(const std::string& scene, const std::string& size = "900x640") {
    return {scene, "--size", size, "--set", "view.cloth=false"};
}

inline std::string written(const TemporaryFolder& folder, const std::string& name, const std::string& text) {
    const std::filesystem::path file = folder / name;
    write_text(file, text);
    return file.string();
}

}  // namespace drapeau::window_tests
