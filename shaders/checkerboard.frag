#version 330 core

uniform float side;  // of a square, pixels

out vec4 shade;

// As shown, not linear: what it is mixed with is shown too.
void main() {
    ivec2 square = ivec2(floor(gl_FragCoord.xy / side));
    shade = vec4(vec3((square.x + square.y) % 2 == 0 ? 0.40 : 0.46), 1.0);
}
