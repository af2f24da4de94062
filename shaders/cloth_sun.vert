#version 330 core
#include "frame.glsl"
#include "cloth_point.glsl"

out vec2 texture_place;

void main() {
    ivec2 point = point_number();
    texture_place = place_on_texture(point);
    gl_Position = to_sun_map * vec4(point_place(point), 1.0);
}
