// Filming: a film under way in the window or without it: its frames as they fly, and what they are drawn with.
#pragma once

#include "camera.hpp"
#include "picture.hpp"
#include "recording.hpp"
#include "render_target.hpp"
#include "stretch.hpp"
#include "velocity_lines.hpp"

namespace drapeau {

struct Filming {
    Recording recording;
    RenderTarget target;
    Picture view;  // what is seen, as it was when the film began; the places of masses and camera are each frame's
    Camera camera;
    Scene scene;
    ViewSettings settings;  // that the view was made of
    StretchScale stretch_scale{};
    SpeedScale speed_scale{};
    long long drawn = 0;

    /// The picture of a frame. Frames come in order: scales follow them.
    Picture picture(const FilmFrame& frame);
};

/// The middle of all masses.
glm::vec3 middle_of(const FieldBuffer<float>& position);

}  // namespace drapeau
