#version 330 core
#include "frame.glsl"

uniform float share;  // of the slab's radius

const float around = 64.0;

void main() {
    float turn = 6.2831853 * float(gl_VertexID) / around;
    vec2 place = vec2(ground.z, 0.0) + ground.w * share * vec2(cos(turn), sin(turn));
    gl_Position = to_clip * vec4(place.x, ground.x, place.y, 1.0);
    gl_Position.z = (0.9998 - 0.0002 * (1.0 - share)) * gl_Position.w;  // the narrower the nearer
}
