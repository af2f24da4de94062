// Transparency: pictures that were drawn over nothing hold the light that reaches the eye, alpha times that of what is
// seen; files want the colour of what is seen, and alpha beside it.
#pragma once

#include "image/image.hpp"

namespace drapeau {

/// The picture with each pixel's light divided by its alpha. Light is divided, not its sRGB code.
Image unpremultiplied(Image picture);

}  // namespace drapeau
