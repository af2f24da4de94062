#version 330 core
#include "frame.glsl"
#include "grid.glsl"

uniform int columns;
uniform float radius;       // m
uniform float max_pixels;  // the radius on the screen at most, in units of line width
uniform float lift;         // m towards the eye

out vec2 within;  // pixels from the centre
flat out float pixels;

void main() {
    vec3 place = position(ivec2(gl_InstanceID % columns, gl_InstanceID / columns));
    vec4 centre = to_clip * vec4(place + lift * normalize(eye.xyz - place), 1.0);
    vec2 half_size = 0.5 * picture_size.xy;
    float scale = length(vec3(to_clip[0][1], to_clip[1][1], to_clip[2][1]));
    pixels = clamp(radius * scale * half_size.y / max(centre.w, 1e-3), 1.5 * picture_size.z, max_pixels * picture_size.z);
    within = (vec2(gl_VertexID % 2, gl_VertexID / 2) * 2.0 - 1.0) * (pixels + 1.0);
    gl_Position = centre + vec4(within / half_size * centre.w, 0.0, 0.0);
}
