// The cloth's normal at a mass, from the neighbours on both sides (one-sided at borders).
#include "whole_normal.glsl"

vec3 cloth_normal(ivec2 mass, ivec2 grid) {
    vec3 along = position(ivec2(min(mass.x + 1, grid.x - 1), mass.y)) - position(ivec2(max(mass.x - 1, 0), mass.y));
    vec3 up = position(ivec2(mass.x, max(mass.y - 1, 0))) - position(ivec2(mass.x, min(mass.y + 1, grid.y - 1)));
    return whole_normal(along, up);
}
