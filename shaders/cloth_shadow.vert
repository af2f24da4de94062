#version 330 core
#include "frame.glsl"
#include "grid.glsl"
#include "shadow_place.glsl"

uniform ivec2 grid;  // columns, rows

void main() { gl_Position = shadow_place(position(ivec2(gl_VertexID % grid.x, gl_VertexID / grid.x))); }
