#version 330 core
#include "frame.glsl"

out vec2 place;

void main() {
    place = vec2(gl_VertexID % 2, gl_VertexID / 2);
    vec2 at = shadow_area.xy + place / shadow_area.zw;
    gl_Position = to_clip * vec4(at.x, ground.x, at.y, 1.0);
    gl_Position.z = 0.9996 * gl_Position.w;
}
