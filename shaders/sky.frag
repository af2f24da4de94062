#version 330 core

in vec3 color;
out vec4 shade;

void main() { shade = vec4(color, 1.0); }
