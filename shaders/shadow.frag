#version 330 core
out vec4 shade;

void main() { shade = vec4(1.0); }
