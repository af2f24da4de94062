#version 330 core
#include "frame.glsl"

uniform vec2 middle;   // x and z
uniform float radius;  // m
uniform float nearer;  // than the ground below it, a share of the depth

const float around = 64.0;

void main() {
    float turn = 6.2831853 * float(gl_VertexID) / around;
    vec2 place = middle + radius * vec2(cos(turn), sin(turn));
    gl_Position = to_clip * vec4(place.x, ground.x, place.y, 1.0);
    gl_Position.z = (0.9998 - nearer) * gl_Position.w;
}
