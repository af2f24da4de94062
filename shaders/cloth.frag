#version 330 core
#include "cloth_light.glsl"

uniform int textured;

const vec3 plain = vec3(0.075, 0.125, 0.215);

void main() { shade = vec4(lit(textured == 1 ? on_cloth(texture(picture, texture_place)) : plain), 1.0); }
