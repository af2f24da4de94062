#version 330 core
#include "frame.glsl"
#include "haze.glsl"

// The sky over a coarse net of the screen: it is smooth enough to be mixed between the net's knots.
const int columns = 24;
const int rows = 24;

out vec3 color;

const vec3 zenith = vec3(0.085, 0.235, 0.56);
const vec3 upper = vec3(0.25, 0.47, 0.80);
const vec3 abyss = vec3(0.60, 0.72, 0.84);

vec3 sky(vec3 d) {
    vec3 air = mix(horizon, upper, smoothstep(0.0, 0.28, d.y));
    air = mix(air, zenith, smoothstep(0.2, 0.95, d.y));
    air = mix(air, abyss, smoothstep(0.0, 0.6, -d.y));
    return air + vec3(0.20, 0.16, 0.10) * pow(max(0.0, dot(d, sun.xyz)), 6.0);
}

void main() {
    const ivec2 corners[6] = ivec2[6](ivec2(0, 0), ivec2(1, 0), ivec2(1, 1), ivec2(0, 0), ivec2(1, 1), ivec2(0, 1));
    int cell = gl_VertexID / 6;
    ivec2 knot = ivec2(cell % columns, cell / columns) + corners[gl_VertexID % 6];
    vec2 place = vec2(knot) / vec2(columns, rows) * 2.0 - 1.0;
    vec4 far = to_world * vec4(place, 1.0, 1.0);
    color = sky(normalize(far.xyz / far.w - eye.xyz));
    gl_Position = vec4(place, 1.0, 1.0);
}
