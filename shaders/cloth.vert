#version 330 core
#include "frame.glsl"
#include "cloth_point.glsl"
#include "sun_place.glsl"

out vec3 to_eye;
out vec3 half_way;  // between the eye and the sun
out vec3 normal;
out vec2 texture_place;
out vec3 sun_place;

void main() {
    ivec2 point = point_number();
    vec3 place = point_place(point);
    to_eye = normalize(eye.xyz - place);
    half_way = normalize(sun.xyz + to_eye);
    normal = point_normal(point);
    texture_place = place_on_texture(point);
    sun_place = sun_place_of(place, normal);
    gl_Position = to_clip * vec4(place, 1.0);
}
