#version 330 core
#include "frame.glsl"

// Rings around the place below the eye, each a fixed share wider than the last, out to the horizon.
const float around = 48.0;
const float nearest = 0.25;  // m, or the eye's height if that is more
const float growth = 1.45;

out vec2 across;   // m, over and along the mown bands
out float clear;   // 1 near, 0 where the haze hides everything
out float edge;    // how gently one band passes into the next

void main() {
    float ring = float(gl_InstanceID + gl_VertexID % 2);
    float turn = 6.2831853 * float(gl_VertexID / 2) / around;
    float height = max(nearest, eye.y - ground.x);
    float radius = ring < 0.5 ? 0.0 : height * 0.5 * pow(growth, ring - 1.0);
    vec3 place = vec3(eye.x + radius * cos(turn), ground.x, eye.z + radius * sin(turn));
    float away = distance(place, eye.xyz);
    across = vec2(place.x + 0.3 * place.z, place.z - 0.3 * place.x);
    clear = exp(-away * 0.0055);
    edge = clamp(3.5 / (1.0 + 0.25 * away), 0.0, 3.5);
    gl_Position = to_clip * vec4(place, 1.0);
    gl_Position.z = 0.9999 * gl_Position.w;  // behind everything but the sky
}
