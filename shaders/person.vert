#version 330 core
#include "frame.glsl"

uniform vec3 feet;

out vec2 place;  // m from the feet, to the right and up

const vec2 half_and_top = vec2(0.40, 1.80);

void main() {
    place = vec2(gl_VertexID % 2 == 0 ? -half_and_top.x : half_and_top.x, gl_VertexID < 2 ? -0.02 : half_and_top.y);
    vec2 to_viewer = normalize(eye.xz - feet.xz + vec2(1e-6, 0.0));
    vec3 right = vec3(to_viewer.y, 0.0, -to_viewer.x);
    gl_Position = to_clip * vec4(feet + place.x * right + vec3(0.0, place.y, 0.0), 1.0);
}
