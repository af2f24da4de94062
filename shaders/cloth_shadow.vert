#version 330 core
#include "frame.glsl"
#include "grid.glsl"
#include "shadow_place.glsl"

uniform ivec2 grid;  // columns, rows

out vec2 texture_place;

void main() {
    ivec2 mass = ivec2(gl_VertexID % grid.x, gl_VertexID / grid.x);
    texture_place = vec2(mass) / vec2(max(grid - 1, ivec2(1)));
    gl_Position = shadow_place(position(mass));
}
