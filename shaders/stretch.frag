#version 330 core
#include "grid.glsl"

// The stretch at a mass, as src/viewer/stretch.hpp has it: the greatest over the directions of its springs.

uniform ivec2 masses;                  // columns, rows
uniform float fly, hoist, diagonal;    // L of the springs of each kind, m; 0: there are none

out float stretch;

float greatest;

void look(float rest, ivec2 offset) {
    if (rest <= 0.0) return;
    ivec2 mass = ivec2(gl_FragCoord.xy);
    float sum = 0.0, count = 0.0;
    for (int side = -1; side <= 1; side += 2) {
        ivec2 other = mass + side * offset;
        if (any(lessThan(other, ivec2(0))) || any(greaterThanEqual(other, masses))) continue;
        sum += distance(position(mass), position(other)) / rest - 1.0;
        count += 1.0;
    }
    if (count > 0.0) greatest = max(greatest, sum / count);
}

void main() {
    greatest = -1e9;
    look(fly, ivec2(1, 0));
    look(hoist, ivec2(0, 1));
    look(diagonal, ivec2(1, 1));
    look(diagonal, ivec2(-1, 1));
    stretch = greatest;
}
