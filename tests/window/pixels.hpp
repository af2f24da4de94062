// Pixels: what tests ask of a picture of the window: its colours in places, what changed, and into what it is divided.
#pragma once

#include "app.hpp"

#include "image/image.hpp"

#include <vector>

namespace drapeau::window_tests {

/// 0 to 255, as shown.
struct Colour {
    double red = 0.0, green = 0.0, blue = 0.0;

    /// How far from grey: the greatest difference between two of the three.
    double vividness() const;
};

Colour colour_at(const Image& picture, Point p);

/// Mean over the square of side 2 * `reach` + 1 around `p`.
Colour colour_around(const Image& picture, Point p, int reach = 2);

/// One flag per pixel of a box, row by row.
struct Mask {
    int width = 0, height = 0;
    std::vector<char> set;

    bool at(int x, int y) const { return set[std::size_t(y) * width + x] != 0; }
    int count() const;
};

/// The pixels of `box` that differ between two pictures by more than `tolerance` in some channel.
Mask changed(const Image& before, const Image& after, const Box& box, int tolerance = 10);

/// Of how many pieces, of at least `smallest` pixels each, the unset part of a mask consists that do not touch its
/// border: the faces of a drawn net. Pieces join through sides of pixels, not corners.
int enclosed_pieces(const Mask& lines, int smallest);

}  // namespace drapeau::window_tests
