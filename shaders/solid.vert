#version 330 core
#include "frame.glsl"
#include "solid.glsl"

out vec3 place;
out vec3 normal;

void main() {
    place = solid_place();
    normal = solid_normal;
    gl_Position = to_clip * vec4(place, 1.0);
}
