// Reduced scene: a scene without some of its parts as a file, in which what was left out stays as comments that say
// what that bought.
#pragma once

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace drapeau::lab {

/// A part that was left out, and a remark on it: "31 % less time, 400 µm rms in 250 ms".
struct LeftOut {
    Scene without;  // the scene after it, and all before it, were left out
    std::string remark;
};

/// The last scene of the list as TOML, which reads back as that scene. `heading`: lines of comment, without their "# ".
std::string reduced_scene_text(const Scene& given, const std::vector<LeftOut>& left_out,
                               const std::vector<std::string>& heading);

}  // namespace drapeau::lab
