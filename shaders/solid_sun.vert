#version 330 core
#include "frame.glsl"
#include "solid.glsl"

void main() { gl_Position = to_sun_map * vec4(solid_place(), 1.0); }
