#version 330 core
#include "frame.glsl"
#include "solid.glsl"
#include "sun_place.glsl"

out vec3 place;
out vec3 normal;
out vec3 sun_place;

void main() {
    place = solid_place();
    normal = solid_normal;
    sun_place = sun_place_of(place, normal);
    gl_Position = to_clip * vec4(place, 1.0);
}
