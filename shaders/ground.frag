#version 330 core
#include "haze.glsl"

in float across, clear, edge;
out vec4 shade;

const vec3 grass = vec3(0.152, 0.245, 0.078);

void main() {
    float band = clamp((abs(fract(across * 0.42) - 0.5) - 0.25) * 4.0 * edge, -1.0, 1.0);
    shade = vec4(mix(horizon, grass * (1.0 + 0.10 * band * clear), clear), 1.0);
}
