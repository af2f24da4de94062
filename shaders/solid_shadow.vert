#version 330 core
#include "frame.glsl"
#include "solid.glsl"
#include "shadow_place.glsl"

void main() { gl_Position = shadow_place(solid_place()); }
