#version 330 core
#include "haze.glsl"

in vec2 across;
in float clear, edge;
out vec4 shade;

const vec3 grass = vec3(0.140, 0.225, 0.070);

// Light and dark patches, without any repetition to be seen.
float patches(vec2 at) {
    vec2 wave = sin(at * 0.61 + 1.7 * sin(at.yx * 0.37));
    vec2 finer = sin(at.yx * 1.93 + 1.3 * sin(at * 1.31));
    return 0.5 * wave.x * wave.y + 0.3 * finer.x * finer.y;
}

void main() {
    float band = clamp((abs(fract(across.x * 0.42) - 0.5) - 0.25) * 4.0 * edge, -1.0, 1.0);
    shade = vec4(mix(horizon, grass * (1.0 + (0.08 * band + 0.09 * min(edge, 1.0) * patches(across)) * clear), clear), 1.0);
}
