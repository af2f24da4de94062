#version 330 core
#include "frame.glsl"
#include "casing.glsl"

uniform vec3 color;
uniform float casing;

in float across;
in float half_width;
in float presence;

out vec4 shade;

void main() { shade = cased(color, abs(across), half_width, casing * picture_size.z, presence); }
