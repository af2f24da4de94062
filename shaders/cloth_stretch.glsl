// The colour of cloth by its stretch, in the place of its own: what is left of a picture would be taken for stretch.
#include "colour_scale.glsl"

uniform int by_stretch;
uniform float stretch_scale;         // share, at both ends of the colours
uniform sampler2D stretch_of_masses;

vec3 stretch_colour(vec2 place) {
    vec2 masses = vec2(textureSize(stretch_of_masses, 0));
    float stretch = texture(stretch_of_masses, (place * (masses - 1.0) + 0.5) / masses).r;
    return colour_at(0.5 + 0.5 * stretch / stretch_scale);
}
