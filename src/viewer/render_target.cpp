#include "render_target.hpp"

#include "transparency.hpp"

#include "io/error.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace drapeau {

RenderTarget::RenderTarget(int width, int height, int samples) : width_(width), height_(height), samples_(samples) {
    GLint max_samples = 0, largest = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &max_samples);
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    samples_ = std::min(samples_, max_samples);
    if (width > largest || height > largest)
        throw InputError("--size = " + std::to_string(width) + "x" + std::to_string(height) +
                         ": this machine draws at most " + std::to_string(largest) + " pixels a side");
    allocate();
}

void RenderTarget::resize(int width, int height) {
    if (width <= 0 || height <= 0 || (width == width_ && height == height_)) return;
    width_ = width;
    height_ = height;
    allocate();
}

void RenderTarget::allocate() {
    contents_.reset();
    scene_ = make_framebuffer();
    shown_ = make_framebuffer();
    scene_color_ = make_renderbuffer();
    scene_depth_ = make_renderbuffer();
    shown_color_ = make_renderbuffer();

    glBindRenderbuffer(GL_RENDERBUFFER, scene_color_.id());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_SRGB8_ALPHA8, width_, height_);
    glBindRenderbuffer(GL_RENDERBUFFER, scene_depth_.id());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_DEPTH_COMPONENT24, width_, height_);
    glBindRenderbuffer(GL_RENDERBUFFER, shown_color_.id());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_SRGB8_ALPHA8, width_, height_);

    glBindFramebuffer(GL_FRAMEBUFFER, scene_.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, scene_color_.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, scene_depth_.id());
    const bool scene_good = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    glBindFramebuffer(GL_FRAMEBUFFER, shown_.id());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, shown_color_.id());
    const bool shown_good = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    if (!scene_good || !shown_good)
        throw InputError("a picture of " + std::to_string(width_) + "x" + std::to_string(height_) +
                         " pixels is more than this machine's graphics can draw");
}

void RenderTarget::begin_scene(Contents contents) {
    contents_ = std::move(contents);
    glBindFramebuffer(GL_FRAMEBUFFER, scene_.id());
    glViewport(0, 0, width_, height_);
    glEnable(GL_FRAMEBUFFER_SRGB);
}

void RenderTarget::begin_panels() {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, scene_.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, shown_.id());
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glBindFramebuffer(GL_FRAMEBUFFER, shown_.id());
}

void RenderTarget::show(int window_width, int window_height) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, shown_.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    const bool same = window_width == width_ && window_height == height_;
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, window_width, window_height, GL_COLOR_BUFFER_BIT,
                      same ? GL_NEAREST : GL_LINEAR);
}

Image RenderTarget::read(bool transparent) const {
    Image image{.width = width_, .height = height_, .rgba = {}};
    const std::size_t row = std::size_t(width_) * 4;
    image.rgba.resize(row * std::size_t(height_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, shown_.id());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());

    // OpenGL counts rows from below, images from above.
    for (int upper = 0, lower = height_ - 1; upper < lower; ++upper, --lower) {
        const auto first = image.rgba.begin() + std::ptrdiff_t(row) * upper;
        std::swap_ranges(first, first + std::ptrdiff_t(row), image.rgba.begin() + std::ptrdiff_t(row) * lower);
    }
    if (transparent) return unpremultiplied(std::move(image));
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
    return image;
}

}  // namespace drapeau
