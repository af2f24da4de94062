#version 330 core
#include "grid.glsl"
#include "whole_normal.glsl"

// A point of the smooth surface through the masses: sum of B_i(s) B_j(t) x_ij over the 4 x 4 masses around it, with the
// cubics of Catmull and Rom; its normal from the derivatives.

uniform ivec2 masses;  // columns, rows
uniform ivec2 pieces;  // of a cell, along the fly and along the hoist

layout(location = 0) out vec4 place;
layout(location = 1) out vec4 normal;

// The mass beyond a border would lie as far out as the one within: x_-1 = 2 x_0 - x_1.
vec4 at_borders(vec4 weight, int cell, int count) {
    if (cell == 0) weight = vec4(0.0, weight.y + 2.0 * weight.x, weight.z - weight.x, weight.w);
    if (cell == count - 2) weight = vec4(weight.x, weight.y - weight.w, weight.z + 2.0 * weight.w, 0.0);
    return weight;
}

vec4 values(float t) {
    return 0.5 * vec4(t * (t * (2.0 - t) - 1.0), t * t * (3.0 * t - 5.0) + 2.0, t * (t * (4.0 - 3.0 * t) + 1.0), t * t * (t - 1.0));
}
vec4 slopes(float t) {
    return 0.5 * vec4(t * (4.0 - 3.0 * t) - 1.0, t * (9.0 * t - 10.0), t * (8.0 - 9.0 * t) + 1.0, t * (3.0 * t - 2.0));
}

void main() {
    ivec2 point = ivec2(gl_FragCoord.xy);
    ivec2 cell = min(point / pieces, masses - 2);
    vec2 within = vec2(point - cell * pieces) / vec2(pieces);
    vec4 across = at_borders(values(within.x), cell.x, masses.x), across_slope = at_borders(slopes(within.x), cell.x, masses.x);
    vec4 down = at_borders(values(within.y), cell.y, masses.y), down_slope = at_borders(slopes(within.y), cell.y, masses.y);

    vec3 middle = vec3(0.0), along = vec3(0.0), up = vec3(0.0);
    for (int j = 0; j < 4; ++j) {
        vec3 row = vec3(0.0), row_slope = vec3(0.0);
        for (int i = 0; i < 4; ++i) {
            vec3 mass = position(clamp(cell + ivec2(i - 1, j - 1), ivec2(0), masses - 1));
            row += across[i] * mass;
            row_slope += across_slope[i] * mass;
        }
        middle += down[j] * row;
        along += down[j] * row_slope;
        up -= down_slope[j] * row;
    }
    place = vec4(middle, 1.0);
    normal = vec4(whole_normal(along, up), 0.0);
}
