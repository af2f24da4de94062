#version 330 core
#include "image.glsl"

in vec2 texture_place;

out vec4 shade;

void main() {
    if (texture(picture, texture_place).a < 0.5) discard;
    shade = vec4(1.0);
}
