#version 330 core
#include "frame.glsl"
#include "grid.glsl"
#include "cloth_normal.glsl"

uniform ivec2 grid;  // columns, rows

out vec3 to_eye;
out vec3 half_way;  // between the eye and the sun
out vec3 normal;
out vec2 texture_place;

void main() {
    ivec2 mass = ivec2(gl_VertexID % grid.x, gl_VertexID / grid.x);
    vec3 place = position(mass);
    to_eye = normalize(eye.xyz - place);
    half_way = normalize(sun.xyz + to_eye);
    normal = cloth_normal(mass, grid);
    texture_place = vec2(mass) / vec2(max(grid - 1, ivec2(1)));
    gl_Position = to_clip * vec4(place, 1.0);
}
