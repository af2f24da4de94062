#version 330 core
#include "frame.glsl"
#include "cloth_point.glsl"
#include "shadow_place.glsl"

out vec2 texture_place;

void main() {
    ivec2 point = point_number();
    texture_place = place_on_texture(point);
    gl_Position = shadow_place(point_place(point));
}
