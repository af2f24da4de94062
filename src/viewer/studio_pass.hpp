// Backdrops that are not the sky: the studio's wall and floor, and the checkerboard that stands for nothing.
#pragma once

#include "gl_objects.hpp"
#include "shader.hpp"

namespace drapeau {

class StudioPass {
public:
    StudioPass();

    void draw() const;  // wall and floor, behind everything else

    /// Under what is drawn already, where that is transparent; `side` of a square in pixels. It is not part of what
    /// files keep.
    void draw_checkerboard(float side) const;

private:
    Shader studio_{"studio"};
    Shader checkerboard_{"checkerboard"};
    GlVertexArray nothing_;
};

}  // namespace drapeau
