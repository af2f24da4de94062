// Colour scales: the colours of forces and of stretch, the same on springs, on the cloth and in their legends.
//
// A scale is given by 33 colours at equal distances, mixed in linear light between them:
//   white to red     forces; a mixture of the two ends in linear light
//   cool to warm     stretch, from compressed (blue) over rest (grey) to stretched (red): the diverging scale of
//                    K. Moreland, "Diverging color maps for scientific visualization", ISVC 2009; within 1.7/255 of it
//   viridis          both; dark blue to yellow, by N. Smith and S. van der Walt (2015, CC0), ever lighter and told
//                    apart by the colour-blind; within 2.4/255 of the published table
#pragma once

#include "scene/scene.hpp"

#include <glm/vec3.hpp>

#include <array>

namespace drapeau {

/// Linear light, from the scale's lower end to its upper one.
using ColourScale = std::array<glm::vec3, 33>;

const ColourScale& force_colours(Colours colours);
/// Its middle is rest.
const ColourScale& stretch_colours(Colours colours);

/// The colour (linear light) at a share of the scale; beyond its ends that of the end.
glm::vec3 colour_at(const ColourScale& scale, float share);

float as_srgb(float linear);
float as_linear(float srgb);

}  // namespace drapeau
