#version 330 core
#include "frame.glsl"
#include "casing.glsl"

uniform float opacity;
uniform float casing;
uniform int dashed;

in vec3 tint;
in float across;
in float length_share;
flat in float half_width;
flat in float presence;

out vec4 shade;

void main() {
    if (dashed == 1 && abs(length_share - 0.5) > 0.3) discard;
    shade = cased(tint, abs(across), half_width, casing * picture_size.z, opacity * presence);
}
