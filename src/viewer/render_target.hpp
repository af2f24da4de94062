// Render target: where a frame is drawn before it is shown. Multisampled sRGB for the scene, resolved for panels, files
// and the window; its size is the picture's, whatever the window system made of the window.
#pragma once

#include "gl_objects.hpp"
#include "image/image.hpp"
#include "picture.hpp"

#include <optional>

namespace drapeau {

class RenderTarget {
public:
    /// The picture that was drawn, and of which masses (as the renderer counts them).
    struct Contents {
        Picture picture;
        long long shapes = 0;

        bool operator==(const Contents&) const = default;
    };

    RenderTarget(int width, int height, int samples);

    int width() const { return width_; }
    int height() const { return height_; }
    void resize(int width, int height);

    bool holds(const Contents& contents) const { return contents_ == contents; }
    void begin_scene(Contents contents);  // from here colours are linear and multisampled
    void begin_panels();                  // from here colours are written as they are, on the resolved picture
    void show(int window_width, int window_height);  // onto the window

    Image read(bool transparent = false) const;  // opaque unless asked for otherwise

private:
    void allocate();

    int width_, height_, samples_;
    std::optional<Contents> contents_;
    GlRenderbuffer scene_color_, scene_depth_, shown_color_;
    GlFramebuffer scene_, shown_;
};

}  // namespace drapeau
